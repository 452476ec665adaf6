"""The web page: one self-contained file with a hand-written WebGL viewer and one quaternion per frame."""

from anim.viewer.page import Curve, Show, curves_of, page, seeing

__all__ = ["Curve", "Show", "curves_of", "page", "seeing"]
