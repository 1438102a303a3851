"""A canvas with lines and discs that lie between pixels, and with text that is measured.

Lengths that a drawing chooses are written in units of a page 1600 wide and 900 high and multiplied
by `Canvas.unit`, so that it looks the same at 640x360 and at 3840x2160. Only type has a floor,
below which nobody could read it; layouts therefore measure their text instead of assuming how big
it is.

Coordinates are pixels, x to the right, y down, and may be fractions: (0, 0) is the top left corner
of the top left pixel. Pixels are red, green, blue.
"""

import math
from collections.abc import Iterable, Sequence
from copy import copy
from itertools import chain
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from studio.arrays import FloatArray, PixelArray
from studio.painter.boxes import Box, Point, check_size
from studio.painter.lettering import (
    ASCENT,
    CAPITAL_HEIGHT,
    DESCENT,
    ELLIPSIS,
    REGULAR,
    PlacedText,
    TypeScale,
    new_face,
    printable,
)
from studio.painter.pixels import FARTHEST, SHIFT, disc_coverage, fixed_point, pen, tinted
from studio.style.palette import Colour, Theme

_SMALLEST_SIZE, _LARGEST_SIDE = (640, 360), 8192  # of a canvas, px
_REFERENCE_WIDTH, _REFERENCE_HEIGHT = 1600, 900  # of the page whose unit is 1 px, px
_MARGIN, _GAP = 36, 36  # around a page, and between its columns, in units of the page
_TYPE_SIZES = (16, 18, 20, 34)  # in units of the page
_SMALLEST_TYPE = 8  # px


class Canvas:
    """A page to draw on.

    Args:
        width: px, 640 to 8192.
        height: px, 360 to 8192.
        theme: the ground and the colours that go with it.

    Attributes:
        pixels: [height, width, 3] uint8, red, green, blue.
        unit: of lengths on the page, px.
        type: sizes of type.
        texts: every text placed so far, in order.

    Raises:
        InputError: if the size is not allowed.
    """

    def __init__(self, width: int, height: int, theme: Theme) -> None:
        check_size((width, height), _SMALLEST_SIZE, _LARGEST_SIDE)
        self.pixels: PixelArray = np.empty((height, width, 3), np.uint8)
        self.pixels[:] = theme.ground
        self.theme = theme
        self.unit = min(width / _REFERENCE_WIDTH, height / _REFERENCE_HEIGHT)
        sizes = (max(_SMALLEST_TYPE, round(size * self.unit)) for size in _TYPE_SIZES)
        self.type = TypeScale(*sizes)
        self.texts: list[PlacedText] = []
        self._origin = (0, 0)
        # A face of its own: OpenCV's faces are not safe to share between threads.
        self._face = new_face()

    @property
    def hair(self) -> int:
        """Width of the finest line, px."""
        return max(1, round(self.unit))

    @property
    def box(self) -> Box:
        """The whole of what can be drawn on."""
        (left, top), (height, width) = self._origin, self.pixels.shape[:2]
        return Box(left, top, left + width, top + height)

    @property
    def page(self) -> Box:
        """What can be drawn on within the margin."""
        return self.box.inset(_MARGIN * self.unit)

    @property
    def gap(self) -> float:
        """Distance between columns of the page, px."""
        return _GAP * self.unit

    def clipped(self, box: Box) -> "Canvas":
        """The same page, the same coordinates, but nothing is drawn outside of the box."""
        left, top = max(round(box.left), 0), max(round(box.top), 0)
        x0, y0 = self._origin
        part = copy(self)
        part.pixels = self.pixels[
            top - y0 : round(box.bottom) - y0, left - x0 : round(box.right) - x0
        ]
        part._origin = (left, top)
        return part

    def copy(self) -> "Canvas":
        """A page of its own that looks the same."""
        twin = copy(self)
        twin.pixels = self.pixels.copy()
        twin.texts = list(self.texts)
        twin._face = new_face()
        return twin

    def restore(self, still: "Canvas", box: Box) -> None:
        """Make a box look as it does on another page of the same size."""
        self.clipped(box).pixels[:] = still.clipped(box).pixels

    def save(self, path: Path) -> None:
        """Write the canvas as a PNG file.

        Raises:
            OSError: if the file cannot be written.
        """
        _, encoded = cv2.imencode(".png", cv2.cvtColor(self.pixels, cv2.COLOR_RGB2BGR))
        path.write_bytes(encoded.tobytes())

    # Shapes

    def fill(self, box: Box, colour: Colour) -> None:
        """Fill a rectangle, its edges on whole pixels; it is never thinner than one."""
        x0, y0 = self._origin
        left, top = round(box.left - x0), round(box.top - y0)
        right, bottom = max(round(box.right - x0), left + 1), max(round(box.bottom - y0), top + 1)
        self.pixels[max(top, 0) : max(bottom, 0), max(left, 0) : max(right, 0)] = colour

    def rounded(self, box: Box, radius: float, colour: Colour) -> None:
        """Fill a rectangle with round corners."""
        radius = min(radius, box.width / 2, box.height / 2)
        core = box.inset(radius)
        x = np.array([core.right, core.left, core.left, core.right])[:, None]
        y = np.array([core.bottom, core.bottom, core.top, core.top])[:, None]
        starts = np.radians([0.0, 90.0, 180.0, 270.0])[:, None]
        angles = starts + np.radians(np.linspace(0.0, 90.0, 9))
        arcs = np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=-1)
        self.polygon(arcs.reshape(-1, 2), colour)

    def line(self, points: ArrayLike, colour: Colour, width: float = 1.0) -> None:
        """Draw through points [N, 2] with a pen of this width in px, at least one pixel."""
        cv2.polylines(
            self.pixels, [self._fixed(points)], False, colour, pen(width), cv2.LINE_AA, SHIFT
        )

    def lines(self, lines: FloatArray, colour: Colour, width: float = 1.0) -> None:
        """Draw several lines at once, each through as many points [K, N, 2]; see `line`."""
        if len(lines):
            fixed = list(self._fixed(lines))
            cv2.polylines(self.pixels, fixed, False, colour, pen(width), cv2.LINE_AA, SHIFT)

    def disc(self, centre: Point | FloatArray, radius: float, colour: Colour) -> None:
        """Draw a filled disc, radius in px."""
        # not cv2.circle, whose small discs come out as lozenges
        x, y = centre[0] - self._origin[0], centre[1] - self._origin[1]
        if not (abs(x) < FARTHEST and abs(y) < FARTHEST):
            return
        height, width = self.pixels.shape[:2]
        left, right = max(int(x - radius - 1), 0), min(int(x + radius + 2), width)
        top, bottom = max(int(y - radius - 1), 0), min(int(y + radius + 2), height)
        if left < right and top < bottom:
            shares = disc_coverage(x - left, y - top, radius, right - left, bottom - top)
            under = self.pixels[top:bottom, left:right]
            under[:] = tinted(under, colour, shares)

    def polygon(self, points: ArrayLike, colour: Colour) -> None:
        """Fill a polygon given by its corners [N, 2]."""
        cv2.fillPoly(self.pixels, [self._fixed(points)], colour, cv2.LINE_AA, SHIFT)

    # Text

    def measure(self, text: str, size: int, weight: int = REGULAR) -> float:
        """Width of the text when it is set in this size (px) and weight, px."""
        if not text:
            return 0.0
        return float(cv2.getTextSize((0, 0), text, (0, 0), self._face, size, weight)[2])

    def fitted(
        self, candidates: str | Sequence[str], width: float, size: int, weight: int = REGULAR
    ) -> str:
        """The first candidate that is no wider than `width`; failing all, the last one cut short.

        What is cut short ends in an ellipsis; it is empty if not even one letter fits.
        """
        options = [candidates] if isinstance(candidates, str) else candidates
        wordings = [printable(option) for option in options]
        last = wordings[-1]
        lengths = range(len(last) - 1, 0, -1)
        shorter = (last[:length].rstrip(" _·,") + ELLIPSIS for length in lengths)
        return self._first_fitting(chain(wordings, shorter), width, size, weight)

    def abbreviated(self, name: str, width: float, size: int, weight: int = REGULAR) -> str:
        """A name, cut in the middle if it is wider than `width`: long names differ at their ends.

        Returns:
            The name, perhaps with an ellipsis; empty if not even two letters fit.
        """
        name = printable(name)
        shorter = (
            name[: kept - kept // 3].rstrip() + ELLIPSIS + name[len(name) - kept // 3 :].lstrip()
            for kept in range(len(name) - 1, 1, -1)
        )
        return self._first_fitting(chain([name], shorter), width, size, weight)

    def _first_fitting(self, texts: Iterable[str], width: float, size: int, weight: int) -> str:
        return next((text for text in texts if self.measure(text, size, weight) <= width), "")

    def wrapped(self, sentences: Sequence[str], width: float, size: int) -> list[str]:
        """Sentences one after another, broken into lines that are no wider than this, px."""
        lines: list[str] = []
        for word in " ".join(sentences).split(" "):
            longer = f"{lines[-1]} {word}" if lines else word
            if lines and self.measure(longer, size) <= width:
                lines[-1] = longer
            else:
                lines.append(word)
        return lines

    def text_box(
        self,
        at: Point,
        text: str,
        size: int,
        weight: int = REGULAR,
        anchor: str = "left",
        line: str = "middle",
    ) -> Box:
        """The box that a text would take up; the arguments are those of `text`."""
        width = self.measure(text, size, weight)
        left = round(at[0] - {"left": 0.0, "centre": 0.5, "right": 1.0}[anchor] * width)
        below = {"base": 0.0, "middle": CAPITAL_HEIGHT / 2, "top": ASCENT}
        # a line set by its top must not reach over it by a rounding
        to_pixel = math.ceil if line == "top" else round
        baseline = to_pixel(at[1] + below[line] * size)
        return Box(left, baseline - ASCENT * size, left + width, baseline + DESCENT * size)

    def text(
        self,
        at: Point,
        text: str,
        size: int,
        colour: Colour,
        weight: int = REGULAR,
        anchor: str = "left",
        line: str = "middle",
        halo: Colour | None = None,
    ) -> Box:
        """Set a line of text.

        Args:
            at: the point that the text is set by, px.
            text: letters that the face lacks are replaced, see `printable`.
            size: of type, px.
            colour: of the letters.
            weight: of type, 100 to 1000.
            anchor: which part of the text lies at x: `left`, `centre` or `right`.
            line: which part of it lies at y: its baseline (`base`), the middle of its capitals
                (`middle`), or the `top` of its box.
            halo: colour of a rim around the letters that keeps them apart from what is below.

        Returns:
            The box that the text takes up, which is also added to `texts`.
        """
        text = printable(text)
        box = self.text_box(at, text, size, weight, anchor, line)
        if not text:
            return box
        # Centred and right alignment by OpenCV 5 are broken, so the text is measured and set from
        # the left.
        x0, y0 = self._origin
        origin = (round(box.left - x0), round(box.top + ASCENT * size - y0))
        if halo is not None:
            self._rim(origin, text, size, weight, halo)
        cv2.putText(self.pixels, text, origin, colour, self._face, size, weight)
        self.texts.append(PlacedText(text, box))
        return box

    def fit(
        self,
        at: Point,
        wordings: str | Sequence[str],
        room: float,
        size: int,
        colour: Colour,
        weight: int = REGULAR,
        anchor: str = "left",
        line: str = "middle",
    ) -> Box:
        """Set the first wording that is no wider than the room (px), or the last one cut short."""
        fitting = self.fitted(wordings, room, size, weight)
        return self.text(at, fitting, size, colour, weight, anchor, line)

    def _rim(self, origin: tuple[int, int], text: str, size: int, weight: int, rim: Colour) -> None:
        x, y = origin
        reach = max(2, round(size * 0.16))
        left, top = max(x - reach, 0), max(y - size - reach, 0)
        right = x + round(self.measure(text, size, weight)) + reach
        bottom = y + round(size * 0.3) + reach
        under = self.pixels[top : max(bottom, 0), left : max(right, 0)]
        if under.size:
            mask = np.zeros(under.shape[:2], np.uint8)
            cv2.putText(mask, text, (x - left, y - top), (255,), self._face, size, weight)
            brush = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
            shares = (cv2.blur(cv2.dilate(mask, brush), (3, 3)) / 255.0).astype(np.float32)
            under[:] = tinted(under, rim, shares)

    def _fixed(self, points: ArrayLike) -> NDArray[np.int32]:
        return fixed_point(np.asarray(points, dtype=np.float64) - np.array(self._origin))
