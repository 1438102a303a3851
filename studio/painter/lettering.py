"""Letters: the face that text is set in, its sizes and weights, and what can be set in it."""

import functools
import unicodedata
from dataclasses import dataclass

import cv2
import numpy as np

from studio.painter.boxes import Box

REGULAR, SEMIBOLD = 400, 600
"""Weights of type."""

CAPITAL_HEIGHT, ASCENT, DESCENT = 0.70, 0.78, 0.22
"""How high capitals are, and how far letters reach above and below the baseline, in type sizes."""

ELLIPSIS = "…"
"""Stands for what was cut off."""

_FONT = "sans"  # the variable-weight face that OpenCV brings along
_MISSING = "□"


def new_face() -> cv2.FontFace:
    """The face that text is set in; one for each thread, for OpenCV's faces cannot be shared."""
    return cv2.FontFace(_FONT)


@dataclass(frozen=True)
class TypeScale:
    """The four sizes of type on a page, px."""

    small: int
    body: int
    heading: int
    title: int


@dataclass(frozen=True)
class PlacedText:
    """A piece of text on the page and the box that it takes up."""

    text: str
    box: Box


def printable(text: str) -> str:
    """The text as it can be set.

    Everything that does not show (line breaks, say) turns into a space, and a letter that the face
    lacks into an empty box.
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(
        (letter if _has_glyph(letter) else _MISSING) if letter.isprintable() else " "
        for letter in unicodedata.normalize("NFC", text)
    )


@functools.cache
def _has_glyph(letter: str) -> bool:
    """Whether the face has such a letter; OpenCV sets a question mark in place of what it lacks."""
    if letter.isascii():
        return True
    face, drawn = new_face(), np.zeros((2, 40, 40), np.uint8)
    for image, text in zip(drawn, (letter, "?"), strict=True):
        cv2.putText(image, text, (4, 28), (255,), face, 24, REGULAR)
    return not np.array_equal(*drawn)
