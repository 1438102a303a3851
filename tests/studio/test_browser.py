"""Films and recordings in a real browser: Chromium, without a window."""

import base64
import json
import os
import select
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from scenes import META_ACTIONS
from studio.orchestrator import Studio
from studio.painter.mp4 import write_mp4
from studio.painter.segments import Segment
from studio.scene.picture.film import compose_film
from studio.style.palette import ACTION_COLOURS, LIGHT, Colour, learner_colour
from tests.headless import web_viewer

PATIENCE = 60.0

FLAGS = (
    "--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update", "--disable-breakpad",
    "--disable-dev-shm-usage",  # containers have little of it
    "--force-color-profile=srgb", "--remote-debugging-pipe",
)  # fmt: skip
NO_GPU = ("--disable-gpu",)
WEBGL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--window-size=900,700")

# Chromium reads commands from file 3 and writes answers to file 4.
LAUNCH = """
import fcntl, os, sys
ends = [fcntl.fcntl(int(end), fcntl.F_DUPFD, 10) for end in sys.argv[1:3]]
os.dup2(ends[0], 3)
os.dup2(ends[1], 4)
os.execv(sys.argv[3], sys.argv[3:])
"""


class Browser:
    """A page of a browser, steered by the Chrome DevTools Protocol."""

    def __init__(self, commands: int, answers: int) -> None:
        self._commands, self._answers, self._unread, self._count = commands, answers, b"", 0
        self._session: dict[str, str] = {}
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        self._session = {"sessionId": attached["sessionId"]}

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """What the browser answers to a command."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": parameters, **self._session}
        unsent = json.dumps(message).encode() + b"\0"
        while unsent:
            unsent = unsent[os.write(self._commands, unsent) :]
        answer = self._wait_for("id", self._count)
        assert "error" not in answer, answer
        return answer["result"]

    def open(self, address: str) -> None:
        """Go to an address, and wait until the page there is loaded."""
        self.call("Page.enable")
        self.call("Page.navigate", url=address)
        self._wait_for("method", "Page.loadEventFired")

    def run(self, script: str) -> Any:
        """What a script, the body of an asynchronous function, returns."""
        expression = f"(async () => {{ {script} }})()"
        answer = self.call(
            "Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True
        )
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    def screenshot(self) -> np.ndarray:
        """What the page looks like, [height, width, 3] in red, green, blue."""
        return decoded(self.call("Page.captureScreenshot")["data"])

    def _wait_for(self, key: str, value: Any) -> dict[str, Any]:
        """The next message that has this value under this key."""
        while True:
            message = json.loads(self._read())
            if message.get(key) == value:
                return message

    def _read(self) -> bytes:
        until = time.monotonic() + PATIENCE
        while b"\0" not in self._unread:
            ready = select.select([self._answers], [], [], until - time.monotonic())[0]
            assert ready, "the browser does not answer"
            read = os.read(self._answers, 1 << 20)
            assert read, "the browser has ended"
            self._unread += read
        message, _, self._unread = self._unread.partition(b"\0")
        return message


@pytest.fixture
def browser(missing, tmp_path, left_running):
    """Opens a browser that is gone, with all its processes, after the block."""
    program = shutil.which("chromium")
    if program is None:
        missing("chromium")

    @contextmanager
    def opened(*flags: str) -> Iterator[Browser]:
        home = tmp_path / "home"
        home.mkdir()
        (their_commands, commands), (answers, their_answers) = os.pipe(), os.pipe()
        process = subprocess.Popen(
            [
                *(sys.executable, "-c", LAUNCH, str(their_commands), str(their_answers)),
                *(program, *FLAGS, *flags, f"--user-data-dir={home}"),
            ],
            pass_fds=(their_commands, their_answers),
            env=os.environ | {"HOME": str(home), "XDG_CONFIG_HOME": str(home)},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        for end in (their_commands, their_answers):
            os.close(end)
        try:
            yield Browser(commands, answers)
        finally:
            for end in (commands, answers):
                os.close(end)
            # asked to close, it takes its time
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            until = time.monotonic() + PATIENCE
            while left_running(process.pid) and time.monotonic() < until:
                time.sleep(0.05)
        assert left_running(process.pid) == []

    return opened


def decoded(png: str) -> np.ndarray:
    return cv2.imdecode(np.frombuffer(base64.b64decode(png), np.uint8), cv2.IMREAD_COLOR_RGB)


PLAY = """
    const data = await (await fetch("data:video/mp4;base64,%s")).blob();
    const video = document.createElement("video");
    const shown = () =>
        new Promise(done => video.requestVideoFrameCallback((now, frame) => done(frame)));
    video.muted = true;
    video.src = URL.createObjectURL(data);
    const first = shown();
    await video.play();
    await first;
    video.pause();
    const canvas = document.createElement("canvas");
    canvas.width = video.videoWidth;
    canvas.height = video.videoHeight;
    const pictures = [];
    for (const seconds of %s) {
        let late, frame = shown();
        video.currentTime = seconds;
        // what was shown before may come once more
        while (late = seconds - (await frame).mediaTime, late < 0 || late > 1 / %d) frame = shown();
        canvas.getContext("2d").drawImage(video, 0, 0);
        pictures.push(canvas.toDataURL("image/png").split(",")[1]);
    }
    return {duration: video.duration, pictures};
"""
RATE = 30


def play(page: Browser, film: Path, frames: list[int]) -> tuple[float, list[np.ndarray]]:
    """Play a film: how long it takes, s, and what is shown in the middle of some frames' time."""
    data = base64.b64encode(film.read_bytes()).decode()
    times = [(frame + 0.5) / RATE for frame in frames]
    played = page.run(PLAY % (data, times, RATE))
    return played["duration"], [decoded(png) for png in played["pictures"]]


FLAT = 3
"""How far a channel of a flat colour may be off, of 255.

A colour is stored as brightness and two differences of colour, in whole numbers of which 219 and
224 are used: rounding them by a half each moves red by 1.4, green by 1.2 and blue by 1.6, rounding
the result by 0.5 more. One is left for the encoder. Taken for those of BT.709, the colours of the
palette move by up to 18.
"""

PATCH = 80
COLOURS = np.array(
    [*ACTION_COLOURS, LIGHT.contact, LIGHT.pedestrian, LIGHT.ground, LIGHT.panel, LIGHT.ink],
    np.uint8,
)


def patches(turn: int) -> np.ndarray:
    """Colours of the palette as flat patches in a row, shifted by some places."""
    row = np.repeat(np.roll(COLOURS, turn, axis=0), PATCH, axis=0)
    return np.repeat(row[None], PATCH, axis=0)


def test_a_browser_shows_the_colours_that_were_drawn(browser, tmp_path):
    film, turns, frames = tmp_path / "film.mp4", (0, 5, 9), 10
    segments = [Segment(frames, lambda turn=turn: [patches(turn)] * frames) for turn in turns]
    write_mp4(film, segments, (PATCH * len(COLOURS), PATCH), RATE)
    with browser(*NO_GPU) as page:
        # each segment's first and last frame, so that none is taken for its neighbour
        duration, shown = play(page, film, [0, 9, 10, 19, 20, 29])
    assert duration == pytest.approx(1.0, abs=0.01)
    middles = slice(PATCH // 2, None, PATCH)
    for turn, frame in zip(np.repeat(turns, 2), shown, strict=True):
        away = frame[PATCH // 2, middles].astype(int) - patches(turn)[PATCH // 2, middles]
        assert np.abs(away).max() <= FLAT


def test_a_browser_shows_the_film_that_was_drawn(browser, tmp_path):
    recorded = Studio(tmp_path).record(
        "doorway", actions=META_ACTIONS[:2], rollouts=5, horizon=1.0, png=False
    )
    film = compose_film(recorded.rollouts, recorded.judgements, (1280, 720), RATE)
    # in the midst of each action, and the very last
    places, looked_at, drawn, before = (15, 15, film[-1].length - 1), [], [], 0
    for segment, place in zip(film, places, strict=True):
        looked_at.append(before + place)
        drawn.append(next(islice(segment.frames(), place, None)).astype(int))
        before += segment.length
    with browser(*NO_GPU) as page:
        duration, shown = play(page, recorded.files[-1], looked_at)
    assert duration == pytest.approx(before / RATE, abs=0.01)
    for index, frame in enumerate(shown):
        away = [np.abs(frame - other) for other in drawn]
        # edges differ, since colours are stored for blocks of 2x2 pixels; the rest does not
        assert (away[index].max(axis=-1) <= FLAT).mean() > 0.9
        assert min(range(len(drawn)), key=lambda other: away[other].mean()) == index


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "colours"),
    [
        ("scene_recording", ACTION_COLOURS),
        ("study_recording", [learner_colour("eu"), learner_colour("cpt")]),
    ],
)
def test_a_light_page_shows_a_recording(browser, kind, colours, request):
    with web_viewer(request.getfixturevalue(kind), "light") as address, browser(*WEBGL) as page:
        page.open(address)
        until = time.monotonic() + PATIENCE
        picture = page.screenshot()
        while unseen(colours, picture) and time.monotonic() < until:
            time.sleep(1.0)
            picture = page.screenshot()
    assert unseen(colours, picture) == []
    bar = picture[:8]
    assert np.median(bar) > 200


def unseen(colours: Iterable[Colour], picture: np.ndarray) -> list[Colour]:
    """The colours that are not in a picture, or in hardly a spot."""
    pixels = picture.astype(int)
    return [
        colour for colour in colours if (np.abs(pixels - colour).max(axis=-1) <= FLAT).sum() < 50
    ]
