"""Write statements as Coq theorems, which Coq checks independently (docs/explanation/coq.md)."""
