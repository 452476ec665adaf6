"""The independent checker of certificates ``hfield-cert/2``; it uses the standard library only.

No module here imports anything from the rest of the package. The parser, the arithmetic and the product are
written a second time, from docs/reference/certificates.md. Begin reading with :mod:`hfield.checker.check`.
"""
