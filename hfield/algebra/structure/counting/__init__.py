"""Count elements with a property, by formula or by enumeration."""
