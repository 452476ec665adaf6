"""Write statements as theorems of Coq, which Coq checks independently (docs/explanation/coq.md)."""
