"""A kind of recording that only the tests know: the number of frames of a grey film."""

from dataclasses import dataclass

import pyarrow as pa
import rerun as rr

from studio.painter.canvas import Canvas
from studio.painter.segments import Segment
from studio.recorder.contents import Contents
from studio.recording import Excerpt, Look, Recording, Size

APPLICATION, EDITION = "toy", 1
SPAN = "frames of a toy"


@dataclass(frozen=True)
class ToyRecording(Recording):
    """A film that is as long as its recording says, one step darker from frame to frame."""

    length: int

    size = (640, 360)
    still_is_cut = False

    def still(self, look: Look, excerpt: Excerpt) -> Canvas:
        """Draw the last frame of the excerpt."""
        excerpt.refuse_actions("a toy")
        return self.frame(look.size or self.size, look, self.length - 1)

    def moving(self, size: Size, look: Look, excerpt: Excerpt) -> list[Segment]:
        """One segment a frame."""
        first, last = excerpt.span(0, self.length - 1)
        frames = range(int(first), int(last) + 1)
        return [
            Segment(1, lambda number=number: [self.frame(size, look, number).pixels])
            for number in frames
        ]

    def to_arrow(self) -> pa.Table:
        """One row a frame."""
        return pa.table({"frame": range(self.length)})

    def frame(self, size: Size, look: Look, number: int) -> Canvas:
        canvas = Canvas(*size, look.colours)
        canvas.fill(canvas.box, (200 - 20 * number,) * 3)
        return canvas


def read(contents: Contents) -> ToyRecording:
    contents.check_edition("/toy", EDITION)
    return ToyRecording(int(contents.static("/toy", "length")[0]))


def write(path: str, length: int) -> None:
    """Write a recording of this kind."""
    with rr.RecordingStream(APPLICATION, recording_id="toy", send_properties=False) as stream:
        stream.save(path)
        stream.log("toy", rr.AnyValues(schema_version=EDITION, length=length), static=True)
