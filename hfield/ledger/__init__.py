"""The ledger: every claim of the thesis, decided over every field of the panel."""
