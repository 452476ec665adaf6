"""The web page: one self-contained file with a hand-written WebGL viewer, fed one quaternion a frame."""

from anim.viewer.page import Curve, Show, curves_of, page, seeing

__all__ = ["Curve", "Show", "curves_of", "page", "seeing"]
