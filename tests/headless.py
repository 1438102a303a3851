"""The real Rerun viewer without a window: pictures of a recording, and what is wrong with it.

Needs no display; on a machine without a graphics card it takes a software Vulkan driver (Debian:
mesa-vulkan-drivers). The viewer has settings, cache and home of its own, which go when it ends: it
neither reads nor changes those of the user, and tells nobody how it is used.

Example:
    with headless_viewer("doorway.rrd") as viewer:
        viewer.client.set_time("sim_time", duration=2.5)
        for tab in viewer.tabs:
            viewer.show(tab)
            Path(f"{tab.name}.png").write_bytes(viewer.screenshot())
        print(viewer.problems())
"""

import os
import re
import socket
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, TypeVar
from urllib.parse import quote

from rerun.experimental import ViewerClient

from studio.errors import RunError
from studio.files import check_is_recording
from studio.recorder.viewer import VIEWER

Picture = TypeVar("Picture")

PATIENCE = 60.0
"""How long the viewer may take to start, or to come to rest, s; a busy machine needs a few."""


# What it says about a software driver would pop up over the views, for some seconds; and to ask for
# a view that it has not drawn yet is no fault of the recording.
_QUIET = ("egui_wgpu", "re_renderer::context", "re_viewer::app::command_handling")
_LOGGED = ",".join(["warn", *(f"{module}=error" for module in _QUIET)])


class NoGraphicsError(RunError):
    """The viewer found nothing to draw with."""


@dataclass(frozen=True)
class Tab:
    """A tab of a recording.

    Attributes:
        name: as the viewer shows it.
        choices: the container and its child to choose, for each container of tabs on the way to it.
    """

    name: str
    choices: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class ViewPicture:
    """A view as it is on screen.

    Attributes:
        name: as the viewer shows it.
        png: picture of the view alone.
    """

    name: str
    png: bytes


class HeadlessViewer:
    """A viewer that has a recording open, and stands still.

    Attributes:
        client: Rerun's own handle on the viewer, for everything that is not here.
        process: the viewer's, leader of a process group of its own.
        tabs: all tabs, from left to right; those within a tab follow it.
    """

    def __init__(self, client: ViewerClient, process: subprocess.Popen[bytes]) -> None:
        """Take a viewer that has loaded its recording."""
        self.client, self.process = client, process
        self.tabs = tuple(self._layout().tabs())
        # played, it would show something else at every look
        if any(recording.timelines for recording in client.get_state().recordings):
            client.set_time(play_state="paused")

    def show(self, tab: Tab) -> None:
        """Bring a tab to the front."""
        layout = self._layout()
        layout.choose(tab)
        self.client.set_blueprint(layout.blueprint, "recording")

    def screenshot(self) -> bytes:
        """The window as PNG, once everything is loaded and drawn.

        Raises:
            RunError: if the picture does not come to rest.
        """
        return self._at_rest(self.client.take_screenshot)

    def views(self) -> tuple[ViewPicture, ...]:
        """The views that are on screen, once everything is loaded and drawn.

        Raises:
            RunError: if the picture does not come to rest.
        """
        names = {view.view_id: view.name for view in self.client.get_state().views}
        shown = tuple(self._layout().views())

        def take() -> tuple[ViewPicture, ...]:
            # asked for at once, all are cut from one and the same picture
            with ThreadPoolExecutor(max(1, len(shown))) as askers:
                pictures = askers.map(self.client.take_screenshot, shown)
                return tuple(
                    ViewPicture(names[view], png) for view, png in zip(shown, pictures, strict=True)
                )

        return self._at_rest(take)

    def problems(self) -> tuple[str, ...]:
        """What the viewer has complained about so far: in its log, and of views it has shown."""
        views = tuple(
            f"{view.name}: {report.severity}: {report.summary} {report.details or ''}".strip()
            for view in self.client.get_state().views
            for report in view.reports
        )
        log = tuple(
            f"{entry.level}: {entry.message}"
            for entry in self.client.get_logs()
            if entry.level in ("WARN", "ERROR")
        )
        return views + log

    def _at_rest(self, take: Callable[[], Picture]) -> Picture:
        """A picture that is the same twice in a row."""
        before, until = None, time.monotonic() + PATIENCE
        while time.monotonic() < until:
            try:
                now = take()
            except ConnectionError:
                if self.process.poll() is None:  # a view has not been drawn yet
                    continue
                raise RunError("the Rerun viewer ended by itself") from None
            if now == before and not self.client.get_state().loading:
                return now
            before = now
        raise RunError(f"the picture in the Rerun viewer does not come to rest in {PATIENCE:g} s")

    def _layout(self) -> "_Layout":
        return _Layout(self.client.get_blueprint("recording").blueprint)


@dataclass(frozen=True)
class _Layout:
    """What holds what: containers and views, each named by its path.

    Attributes:
        blueprint: as the viewer gives it, fields by archetype by path.
    """

    blueprint: dict[str, Any]

    def tabs(self) -> Iterator[Tab]:
        """All tabs, those within a tab after it."""
        return self._tabs_below(self._root, ())

    def choose(self, tab: Tab) -> None:
        """Bring a tab to the front."""
        for container, child in tab.choices:
            self._container(container)["active_tab"] = child

    def views(self) -> Iterator[str]:
        """Identities of the views that are on screen."""
        return self._views_below(self._root)

    @property
    def _root(self) -> str:
        return f"container/{self.blueprint['/viewport']['ViewportBlueprint']['root_container']}"

    def _entry(self, path: str) -> dict[str, Any]:
        # a child's path may or may not begin with a slash
        entry: dict[str, Any] = self.blueprint[f"/{path.lstrip('/')}"]
        return entry

    def _container(self, path: str) -> dict[str, Any]:
        """What is said of a container; nothing for a view."""
        fields: dict[str, Any] = self._entry(path).get("ContainerBlueprint", {})
        return fields

    def _contents(self, path: str) -> list[str]:
        """Paths of what a container holds."""
        contents = self._container(path).get("contents", [])
        # a list of one comes as the one
        return [contents] if isinstance(contents, str) else contents

    def _name(self, path: str) -> str:
        """The name of a container or view, or what kind it is if it has none."""
        fields = self._container(path) or self._entry(path)["ViewBlueprint"]
        kind = fields.get("container_kind") or fields.get("class_identifier")
        return str(fields.get("display_name", kind))

    def _tabs_below(self, path: str, choices: tuple[tuple[str, str], ...]) -> Iterator[Tab]:
        container = self._container(path)
        for child in self._contents(path):
            way = choices
            if container["container_kind"] == "Tabs":
                way = (*choices, (path, child))
                yield Tab(self._name(child), way)
            yield from self._tabs_below(child, way)

    def _views_below(self, path: str) -> Iterator[str]:
        container = self._container(path)
        if not container:
            yield path.rsplit("/", 1)[-1]
            return
        shown = self._contents(path)
        if container["container_kind"] == "Tabs" and "active_tab" in container:
            shown = [container["active_tab"]]
        for child in shown:
            yield from self._views_below(child)


@contextmanager
def headless_viewer(
    recording: str | Path, size: tuple[int, int] = (1600, 1000)
) -> Iterator[HeadlessViewer]:
    """A viewer that has loaded a recording; it ends with the block.

    Args:
        recording: the `.rrd` file.
        size: width and height of its window, px.

    Raises:
        InputError: if the file is not a recording.
        NoGraphicsError: if there is nothing to draw with.
        RunError: if the viewer does not start or cannot load the file.
    """
    port = _free_port()
    window = f"--window-size={size[0]}x{size[1]}"
    options = ["--headless", "--hide-welcome-screen", f"--port={port}", window]
    with _running(Path(recording), options) as (process, output):
        yield HeadlessViewer(_connect(port, process, output), process)


@contextmanager
def web_viewer(recording: str | Path, theme: Literal["light", "dark"] = "dark") -> Iterator[str]:
    """The address, on this machine alone, of a web page that shows a recording, for a browser.

    A viewer without a window is always dark; the one on a web page is also light. The page takes
    a browser that draws with WebGL.

    Args:
        recording: the `.rrd` file.
        theme: of what surrounds the drawings.

    Raises:
        InputError: if the file is not a recording.
        RunError: if the page cannot be served.
    """
    page, data = _free_port(), _free_port()
    options = ["--serve-web", f"--web-viewer-port={page}", f"--port={data}"]
    with _running(Path(recording), options) as (process, output):
        for port in (page, data):
            _wait_for(port, process, output)
        source = quote(f"rerun+http://127.0.0.1:{data}/proxy", safe="")
        yield f"http://127.0.0.1:{page}/?url={source}&theme={theme}&renderer=webgl"


@contextmanager
def _running(recording: Path, options: list[str]) -> Iterator[tuple[subprocess.Popen[bytes], Path]]:
    """Rerun's program on a recording, and the file that it writes its output to."""
    check_is_recording(recording)
    with tempfile.TemporaryDirectory(prefix="studio-viewer-") as folder:
        home = Path(folder)
        environment = _environment(home)
        subprocess.run(
            [VIEWER, "analytics", "disable"], env=environment, check=True, capture_output=True
        )
        output = home / "output"
        with output.open("wb") as log:
            process = subprocess.Popen(
                [VIEWER, "--bind=127.0.0.1", *options, recording.absolute()],
                env=environment,
                stdout=log,
                stderr=log,
                start_new_session=True,
            )
        try:
            yield process, output
        finally:
            _end(process)


def _environment(home: Path) -> dict[str, str]:
    """Our environment, but with a home and folders of its own."""
    kinds = ("CONFIG_HOME", "DATA_HOME", "STATE_HOME", "CACHE_HOME", "RUNTIME_DIR")
    folders = {"HOME": str(home), **{f"XDG_{kind}": str(home / kind.lower()) for kind in kinds}}
    for folder in folders.values():
        Path(folder).mkdir(mode=0o700, exist_ok=True)
    return os.environ | folders | {"RUST_LOG": _LOGGED}


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def _connect(port: int, process: subprocess.Popen[bytes], output: Path) -> ViewerClient:
    """A handle on the viewer, once it has loaded its recording."""
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        try:
            client = ViewerClient.connect(f"rerun+http://127.0.0.1:{port}/proxy")
            state = client.get_state()
            errors = [entry.message for entry in client.get_logs() if entry.level == "ERROR"]
        except ConnectionError:
            _check_runs(process, output)
        else:
            if errors:
                first = errors[0].splitlines()[0]
                raise RunError(f"the Rerun viewer cannot load the recording: {first}")
            if state.active_recording and not state.loading:
                return client
        time.sleep(0.05)
    raise RunError(f"the Rerun viewer does not load the recording in {PATIENCE:g} s")


def _wait_for(port: int, process: subprocess.Popen[bytes], output: Path) -> None:
    """Wait until a port of this machine is listened to."""
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        with suppress(ConnectionError), socket.create_connection(("127.0.0.1", port)):
            return
        _check_runs(process, output)
        time.sleep(0.05)
    raise RunError(f"the Rerun viewer does not answer in {PATIENCE:g} s")


def _check_runs(process: subprocess.Popen[bytes], output: Path) -> None:
    """Say why the viewer ended by itself, if it did, from what it wrote."""
    if process.poll() is None:
        return
    written = output.read_text(errors="replace")
    if re.search("render context|graphics adapter", written):
        raise NoGraphicsError(
            "the Rerun viewer found nothing to draw with: a Vulkan driver is needed "
            "(without a graphics card, on Debian: apt-get install mesa-vulkan-drivers)"
        )
    last = written.strip().splitlines()[-1:] or ["it says nothing"]
    raise RunError(f"the Rerun viewer ended with exit code {process.returncode}: {last[0]}")


def _end(process: subprocess.Popen[bytes]) -> None:
    process.terminate()
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
