"""Draw the pictures of the README anew.

The recording is shown by the real Rerun viewer, headless; on a machine without a graphics card that
takes a software Vulkan driver (Debian: mesa-vulkan-drivers).
"""

import os
import shutil
import socket
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import av
import rerun_cli
from PIL import Image
from rerun.experimental import ViewerClient

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
        with viewer(recording) as client:
            client.set_time("sim_time", duration=2.5, play_state="paused")
            time.sleep(4.0)  # until everything is loaded and drawn
            (PICTURES / "recording.png").write_bytes(client.take_screenshot())
        _, curves, _ = Studio(folder).learn().files
        shutil.copy(curves, PICTURES / "learning.png")


def save_frame(film: Path, seconds: float, path: Path) -> None:
    """Save what a film shows at one moment."""
    with av.open(str(film)) as container:
        for frame in container.decode(video=0):
            if frame.time is not None and frame.time >= seconds:
                Image.fromarray(frame.to_ndarray(format="rgb24")).save(path, optimize=True)
                return


@contextmanager
def viewer(recording: Path) -> Iterator[ViewerClient]:
    """A headless Rerun viewer that has a recording open."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    program = Path(rerun_cli.__file__).with_name("rerun")
    arguments = ["--headless", "--bind", "127.0.0.1", "--port", port, "--hide-welcome-screen"]
    process = subprocess.Popen(
        [program, *arguments, "--window-size", "1600x1000", recording],
        env=os.environ | {"XDG_RUNTIME_DIR": tempfile.gettempdir()},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        yield connect(f"rerun+http://127.0.0.1:{port}/proxy")
    finally:
        process.terminate()
        process.wait(10)


def connect(address: str) -> ViewerClient:
    """The viewer at this address, once it has loaded its recording."""
    for _ in range(200):
        time.sleep(0.1)
        try:
            client = ViewerClient.connect(address)
            state = client.get_state()
        except Exception:  # it is not up yet
            continue
        if state.active_recording and not state.loading:
            return client
    raise TimeoutError("the viewer did not load the recording in 20 s")


if __name__ == "__main__":
    main()
