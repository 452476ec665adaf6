"""The independent checker of certificates ``hfield-cert/2``; it uses the standard library only.

No module here imports anything of the rest of the package; the parser, the arithmetic and the
product are written a second time, from docs/reference/certificates.md. Begin with
:mod:`hfield.checker.check`.
"""
