"""Figures drawn from lines, for plots that Rerun has no view for.

Everything in a recording that has a name of its own costs about a kilobyte, however little it
holds. A figure therefore is a single set of lines; its texts are labels of lines without length.

A figure is drawn in metres, or on a page that is about 1 wide, and y counts upwards in it. Lengths
are in the figure's unit, be that the metre or the page, unless they are said to be pixels.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import rerun as rr
from numpy.typing import ArrayLike

from studio.arrays import FloatArray
from studio.recorder.views import y_upwards as y_upwards
from studio.style.palette import LIGHT, Colour

GROUND = "ground"
"""The entity that lies under everything else."""

OVERLAP = 1.6
"""Strokes that fill an area are this much wider than they are apart: less shows seams."""

PAGE_RESOLUTION = 1.0 / 512.0
"""Finer than can be seen on a page; places that are rounded to it pack into less of a file."""

DASH, DASH_GAP = 0.03, 0.02
"""Lengths of a dash and of the gap after it, on a page."""

_GROUND_REACH = 3000.0  # of the ground from the origin, farther than any place of a scene, m
_DOT_LENGTH = 1e-3  # a line of no length is not drawn, so dots are lines of this length


@dataclass(frozen=True)
class Drawing:
    """Lines and texts that become one entity.

    Texts are lifted above their places, because the viewer hangs a label below its line.
    """

    lift: float = 0.0  # how much higher than their places texts are put
    resolution: float = 0.0  # places are rounded to multiples of this; 0 leaves them
    lines: list[FloatArray] = field(default_factory=list)  # [N, 2] each
    colours: list[Colour] = field(default_factory=list)  # one a line
    radii: list[float] = field(default_factory=list)  # one a line; negative ones are in pixels
    texts: list[tuple[str, FloatArray]] = field(default_factory=list)  # and their middles

    def line(self, points: ArrayLike, colour: Colour, pixels: float = 1.4) -> None:
        """Draw a line through points [N, 2] that is as wide in pixels however near one looks."""
        self._add(points, colour, -pixels / 2.0)

    def stroke(self, points: ArrayLike, colour: Colour, width: float) -> None:
        """Draw a line through points [N, 2] whose width grows as one looks nearer."""
        self._add(points, colour, width / 2.0)

    def fill(self, x: FloatArray, low: FloatArray, high: FloatArray, colour: Colour) -> None:
        """Fill the area between two curves low(x) and high(x), [N] each, N > 1, evenly spaced.

        One line runs up and down through the area. It is wider than its turns are apart, and
        turns where its edge meets the curves.
        """
        radius = OVERLAP * (x[1] - x[0]) / 2.0
        ends = np.stack([low + radius, np.maximum(high - radius, low + radius)], axis=-1)
        ends[1::2] = ends[1::2, ::-1]  # every other turn runs down
        self.stroke(np.stack([np.repeat(x, 2), ends.ravel()], axis=-1), colour, 2.0 * radius)

    def dashes(self, points: FloatArray, colour: Colour, pixels: float = 1.4) -> None:
        """Draw a dashed line through points [N, 2] of a page."""
        along = np.append(0.0, np.hypot(*np.diff(points, axis=0).T).cumsum())
        for start in np.arange(0.0, along[-1], DASH + DASH_GAP):
            end = min(start + DASH, along[-1])
            stops = np.unique([start, *along[(along > start) & (along < end)], end])
            x, y = (np.interp(stops, along, points[:, axis]) for axis in (0, 1))
            self.line(np.stack([x, y], axis=-1), colour, pixels)

    def dot(self, place: Sequence[float], colour: Colour, pixels: float) -> None:
        """Draw a disc that is this many pixels wide however near one looks."""
        x, y = place
        self.line([(x - _DOT_LENGTH / 2, y), (x + _DOT_LENGTH / 2, y)], colour, pixels)

    def text(self, place: Sequence[float], words: str) -> None:
        """Write words centred on a place (x, y)."""
        x, y = place
        self.texts.append((words, np.array([x, y + self.lift])))

    def log(
        self,
        stream: rr.RecordingStream,
        path: str,
        draw_order: float | None = None,
        *,
        static: bool = True,
    ) -> None:
        """Add the drawing to a recording; what has a higher draw order lies above the rest.

        What is not static is there from the stream's time on, until it is drawn anew.
        """
        # labels belong to the first lines, and further lines have none; but Rerun would put a label
        # that is the only one in the middle of all lines, so a second, empty one goes with it
        labels = [words for words, _ in self.texts]
        labels += [""] if len(labels) == 1 else []
        anchors = [np.stack([place, place]) for _, place in self.texts]
        lines = rr.LineStrips2D(
            [*anchors, *self.lines],
            colors=[LIGHT.ink] * len(anchors) + self.colours,
            radii=[0.0] * len(anchors) + self.radii,
            labels=labels or None,
            show_labels=True if self.texts else None,
            draw_order=draw_order,
        )
        stream.log(path, lines, static=static)

    def _add(self, points: ArrayLike, colour: Colour, radius: float) -> None:
        places = np.asarray(points, dtype=np.float64)
        if self.resolution:
            places = np.round(places / self.resolution) * self.resolution
        self.lines.append(places)
        self.colours.append(colour)
        self.radii.append(radius)


def log_ground(stream: rr.RecordingStream) -> None:
    """Lay light ground under everything.

    One short line of enormous width: it is a fifth of the size of a background for every view.
    """
    ends = [(-_GROUND_REACH, 0.0), (_GROUND_REACH, 0.0)]
    ground = rr.LineStrips2D([ends], colors=LIGHT.panel, radii=_GROUND_REACH, draw_order=-100.0)
    stream.log(GROUND, ground, static=True)
