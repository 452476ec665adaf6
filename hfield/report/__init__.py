"""Write a decided ledger as a page or a paper."""

from hfield.report.chapters import Chapter

__all__ = ["Chapter"]
