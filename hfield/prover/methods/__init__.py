"""The methods that prove a statement without quantifiers, over one ring and over all fields."""
