"""The methods for statements that something exists."""
