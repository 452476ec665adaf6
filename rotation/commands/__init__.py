"""What a user types: `hfield bench` and `hfield figures`."""
