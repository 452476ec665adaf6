"""The commands `hfield bench` and `hfield figures`."""
