"""Draw the pictures of the README anew.

The recording is shown by the real Rerun viewer, headless; on a machine without a graphics card that
takes a software Vulkan driver (Debian: mesa-vulkan-drivers).
"""

import shutil
import tempfile
from pathlib import Path

import av
from PIL import Image

from studio.headless import headless_viewer
from studio.orchestrator import Studio
from studio.sources import Source

PICTURES = Path(__file__).parent / "pictures"
HERO = Source("intersection", number=11)


def main() -> None:
    """Record the scene of the README and show it three ways; run the default study."""
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        recording, picture, film = Studio(folder).record(HERO).files
        shutil.copy(picture, PICTURES / "intersection.png")
        save_frame(film, 2.0, PICTURES / "film.png")
        with headless_viewer(recording) as viewer:
            viewer.client.set_time("sim_time", duration=2.5)
            (PICTURES / "recording.png").write_bytes(viewer.screenshot())
        _, curves, _ = Studio(folder).learn().files
        shutil.copy(curves, PICTURES / "learning.png")


def save_frame(film: Path, seconds: float, path: Path) -> None:
    """Save what a film shows at one moment."""
    with av.open(str(film)) as container:
        for frame in container.decode(video=0):
            if frame.time is not None and frame.time >= seconds:
                Image.fromarray(frame.to_ndarray(format="rgb24")).save(path, optimize=True)
                return


if __name__ == "__main__":
    main()
