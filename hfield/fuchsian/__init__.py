"""Groups of units of norm one of indefinite orders."""
