"""The commands of ``hfield``, one module each: ``configure(parser)`` and ``run(args) -> int``."""
