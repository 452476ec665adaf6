"""``python -m hfield`` is the command ``hfield``."""

import sys

from hfield.cli import main

sys.exit(main())
