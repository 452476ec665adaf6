"""The former place of :mod:`hfield.fields`, for one version, with a warning."""

import warnings
