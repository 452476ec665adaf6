"""What a user types: `hfield render`."""
