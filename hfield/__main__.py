"""``python -m hfield`` is the command ``hfield``."""

from hfield.cli import main

if __name__ == "__main__":
    raise SystemExit(main())
