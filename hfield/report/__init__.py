"""A ledger, decided, as one page to read and print: claims, decisions, certificates, errata, chapters."""

from hfield.report.chapters import Chapter

__all__ = ["Chapter"]
