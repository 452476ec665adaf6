"""The thesis's figures 2.1 to 2.5 as plots; ``hfield figures -o DIR`` writes them.

The thesis's text has the captions but not the pictures, so the figures are reconstructed from the surrounding
text. ``FIGURES`` maps the number of a figure to its :class:`Drawing`; :func:`rotation.figures.saving.save`
writes any such mapping, also of another package.
"""

from rotation.figures.drawing import Drawing
from rotation.figures.letter import letter_mirrored, letter_t, letter_turned
from rotation.figures.plane import turned_points
from rotation.figures.points import polar_and_cartesian, turned_vector

FIGURES: dict[str, Drawing] = {
    drawing.number: drawing
    for drawing in (
        Drawing("2.1", "Polar and Cartesian coordinates", (4.6, 3.7), polar_and_cartesian),
        Drawing("2.2", "A vector turned about the origin", (4.6, 4.4), turned_vector),
        Drawing("2.3", "The letter T", (4.8, 4.5), letter_t),
        Drawing("2.4", "The letter T turned", (6.4, 6.4), letter_turned),
        Drawing("2.5", "The letter T mirrored", (10.0, 10.4), letter_mirrored),
    )
}

__all__ = ["FIGURES", "Drawing", "turned_points"]
