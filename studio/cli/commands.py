"""The command line: it parses, calls the orchestrator, and prints.

Exit codes: 0 done, 1 failed while running, 2 the user's input was wrong, 130 interrupted. What
goes wrong ends in one line on standard error; only a fault of the program itself ends in a
traceback.
"""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from studio.errors import InputError, RunError

if TYPE_CHECKING:
    from scenes import Noise
    from studio.orchestrator import Compared, Learned, Recorded
    from studio.scene.sources import Source


class OneLineErrors(click.Group):
    """A group of commands whose errors are one line and an exit code."""

    def main(self, *args: Any, **keywords: Any) -> NoReturn:
        """Run the command line, then leave the process."""
        try:
            signal.signal(signal.SIGTERM, _stop)
            code = super().main(*args, **(keywords | {"standalone_mode": False}))
        except click.exceptions.NoArgsIsHelpError as error:
            click.echo(error.format_message())
            sys.exit(2)
        except click.ClickException as error:
            _leave(error.format_message(), error.exit_code)
        except (click.Abort, KeyboardInterrupt):
            _leave("interrupted", 130)
        except InputError as error:
            _leave(str(error), 2)
        except (RunError, OSError, MemoryError) as error:
            _leave(str(error) or "out of memory", 1)
        except ValueError as error:
            if not isinstance(error, _input_errors()):
                raise
            _leave(str(error), 2)
        sys.exit(code if isinstance(code, int) else 0)


def _input_errors() -> tuple[type[Exception], ...]:
    """What the rooms raise for wrong input; only a room that is loaded can have raised it."""
    rooms = (sys.modules.get(name) for name in ("scenes.errors", "learners.errors"))
    return tuple(room.InputError for room in rooms if room is not None)


def _stop(_signal: int, _frame: object) -> NoReturn:
    """End as an interruption does, so that nothing half-written is left behind."""
    raise KeyboardInterrupt


def _leave(message: str, code: int) -> NoReturn:
    click.echo(f"studio: {' '.join(message.split())}", err=True)
    sys.exit(code)


class Place(click.ParamType[tuple[float, float]]):
    """A place in the plane, written `x,y`, in metres."""

    name = "x,y"

    def convert(
        self, value: Any, param: click.Parameter | None, context: click.Context | None
    ) -> tuple[float, float]:
        """Read `3.5,-1` as (3.5, -1.0)."""
        try:
            x, y = (float(part) for part in str(value).split(","))
        except ValueError:
            self.fail(f"{value!r} is not a place: two numbers in metres, x,y", param, context)
        return x, y


class Size(click.ParamType[tuple[int, int]]):
    """Width and height of a picture, written `WxH`, in pixels."""

    name = "WxH"

    def convert(
        self, value: Any, param: click.Parameter | None, context: click.Context | None
    ) -> tuple[int, int]:
        """Read `1280x720` as (1280, 720)."""
        try:
            width, height = (int(part) for part in str(value).lower().split("x"))
        except ValueError:
            self.fail(f"{value!r} is not a size: two whole numbers, WxH", param, context)
        return width, height


def _read_noise(_context: click.Context, _option: click.Parameter, given: tuple[str, ...]) -> Noise:
    from dataclasses import fields, replace

    from scenes import Noise

    noise, names = Noise(), [field.name for field in fields(Noise)]
    for setting in given:
        name, _, number = setting.partition("=")
        if name not in names:
            raise InputError(f"--noise: {name!r} is not known: {', '.join(names)}")
        try:
            value = float(number)
        except ValueError:
            raise InputError(f"--noise: {setting!r} is not a setting: {name}=NUMBER") from None
        noise = replace(noise, **{name: value})
    return noise


def _read_names(
    _context: click.Context, _option: click.Parameter, given: str | None
) -> tuple[str, ...]:
    return tuple(name.strip() for name in given.split(",")) if given else ()


Command = Callable[..., None]


_OUT_FOLDER = click.option(
    "--out",
    type=click.Path(path_type=Path),
    default="recordings",
    show_default=True,
    help="Folder for the files.",
)


def _simulation_options(command: Command) -> Command:
    """The options of everything that simulates."""
    options = [
        click.option("--seed", default=0, show_default=True, help="Seed of scene and noise."),
        click.option("--rollouts", default=50, show_default=True, help="Rollouts of each action."),
        click.option("--horizon", default=4.0, show_default=True, help="Simulated time in s."),
        click.option(
            "--model",
            type=click.Choice(["extended", "helbing-molnar"]),
            default="extended",
            show_default=True,
            help="Force set of the social force model.",
        ),
        click.option(
            "--engine",
            type=click.Choice(["batched", "pysocialforce"]),
            default="batched",
            show_default=True,
            help="Compiled engine, or the slow reference.",
        ),
        click.option(
            "--noise",
            multiple=True,
            metavar="NAME=NUMBER",
            callback=_read_noise,
            help="Strength of one source of noise, for example acceleration=0.5; repeatable.",
        ),
    ]
    return _with(options, command)


_SCENE = ("scene", "pattern", "number", "frame", "robot_start", "robot_goal")


def _scene_options(command: Command) -> Command:
    """The options that say which scene is meant."""
    options = [
        click.option(
            "--scene",
            required=True,
            metavar="NAME|FILE.toml|TRACKS",
            help="A family (see `studio scenes`), a scene file, or the obsmat.txt of tracks.",
        ),
        click.option("--pattern", help="How people meet, for a family."),
        click.option("--number", type=int, help="Which scene of the seed's series, for a family."),
        click.option("--frame", type=int, help="Which frame, for tracks; the busiest if left out."),
        click.option("--robot-start", type=Place(), help="Where the robot starts, for tracks."),
        click.option("--robot-goal", type=Place(), help="Where the robot is headed, for tracks."),
    ]
    return _with(options, command)


def _take_source(given: dict[str, Any]) -> Source:
    """Take which scene is meant out of the options given."""
    from studio.scene.sources import Source

    return Source(seed=given["seed"], **{name: given.pop(name) for name in _SCENE})


def _file_options(command: Command) -> Command:
    """The options that say what is written where."""
    options = [
        _OUT_FOLDER,
        click.option("--no-png", is_flag=True, help="Write no picture."),
        click.option("--no-mp4", is_flag=True, help="Write no film."),
    ]
    return _with(options, command)


def _with(options: Sequence[Callable[[Command], Command]], command: Command) -> Command:
    """The command with options, listed in this order."""
    for option in reversed(options):
        command = option(command)
    return command


@click.group(cls=OneLineErrors)
@click.version_option(package_name="prospect-studio")
def main() -> None:
    """See what a robot risks among pedestrians, and what people make of it."""


@main.command()
@_scene_options
@_simulation_options
@_file_options
def record(out: Path, no_png: bool, no_mp4: bool, **given: Any) -> None:
    """Simulate a scene; write its recording, picture and film.

    Writes OUT/NAME.rrd (open it with `studio view`), NAME.png and NAME.mp4.
    """
    from studio.orchestrator import Studio
    from studio.progress import Terminal

    source = _take_source(given)
    studio = Studio(out, Terminal())
    _print_recorded(studio.record(source, png=not no_png, mp4=not no_mp4, **given))


@main.command()
@click.argument("one")
@click.argument("other")
@_scene_options
@_simulation_options
@_file_options
def compare(one: str, other: str, out: Path, no_png: bool, no_mp4: bool, **given: Any) -> None:
    """Put two actions of a scene side by side: which would you rather the robot did?

    For example `studio compare --scene doorway forward slow_down`. Writes OUT/NAME-ONE-OTHER.rrd,
    .png and .mp4, in which every outcome of both actions plays, one after the other, with the same
    people and the same luck on both sides. The seed chooses the sides.
    """
    from studio.orchestrator import Studio
    from studio.progress import Terminal

    source = _take_source(given)
    studio = Studio(out, Terminal())
    _print_compared(studio.compare(source, one, other, png=not no_png, mp4=not no_mp4, **given))


@main.command()
@click.argument("name", required=False)
@click.option("--pattern", help="How people meet.")
@click.option("--seed", default=0, show_default=True, help="Seed of the series.")
@click.option("--number", default=0, show_default=True, help="Which scene of the series.")
def scenes(name: str | None, pattern: str | None, seed: int, number: int) -> None:
    """List the scenes there are, or print one.

    Without NAME: the families and patterns. With a family's NAME: one scene of it as TOML, ready
    to edit and to record. With the obsmat.txt of recorded tracks: the busiest frames.
    """
    from dataclasses import replace

    from scenes import FAMILIES, busiest_frames, load_scene, scene_to_toml
    from studio.scene.sources import is_file

    if pattern is not None and name not in FAMILIES:
        raise InputError("--pattern: goes with the NAME of a family")
    if name is None:
        _print_families()
    elif name not in FAMILIES and is_file(name):
        lines = [f"{frame:<7} {people}" for frame, people in busiest_frames(Path(name))]
        click.echo("\n".join(["frame   people", *lines]))
    else:
        scene = load_scene(name, pattern, seed, number)
        # A name of its own: recorded, it does not replace the family's own recording.
        click.echo(scene_to_toml(replace(scene, name=f"{name}-{seed}-{number}")), nl=False)


@main.command()
@click.option("--scenes", default=300, show_default=True, help="How many scenes.")
@click.option(
    "--families", callback=_read_names, metavar="A,B", help="Families to draw from; all of them."
)
@click.option(
    "--patterns", callback=_read_names, metavar="A,B", help="Patterns to draw from; all of them."
)
@_simulation_options
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    default="outcomes.parquet",
    show_default=True,
    help="The Parquet file to write.",
)
def sample(out: Path, **plan: Any) -> None:
    """Simulate many scenes; write their outcomes as one Parquet file.

    One row a rollout: scene, family, pattern, action, rollout, the five features.
    """
    from scenes.bank import BankPlan
    from studio.orchestrator import Studio
    from studio.progress import Terminal

    wanted = BankPlan(**plan)
    written = Studio(progress=Terminal()).sample(out, wanted)
    rows = wanted.scenes * len(wanted.actions) * wanted.rollouts
    click.echo(f"{written}  {rows:,} outcomes of {wanted.scenes} scenes, {_size(written)}")


@main.command()
@click.option(
    "--outcomes",
    type=click.Path(path_type=Path),
    help="The outcome bank; left out, the default bank is sampled to OUT/outcomes.parquet.",
)
@click.option(
    "--teachers", callback=_read_names, default="eu,tk,strong", show_default=True, metavar="A,B"
)
@click.option(
    "--profile",
    "profiles",
    multiple=True,
    metavar="NAME=α,η,λ,γ,δ",
    help="A teacher of your own, for example cautious=0.9,0.9,4,0.6,0.7; repeatable.",
)
@click.option("--beta", type=float, help="How decided the teachers are; 20 if left out.")
@click.option(
    "--learners", callback=_read_names, default="eu,cpt", show_default=True, metavar="A,B"
)
@click.option(
    "--pairs",
    callback=_read_names,
    default="25,50,100,200,500,1000,2000",
    show_default=True,
    metavar="N,M",
    help="Numbers of pairs to learn from.",
)
@click.option("--seeds", default=5, show_default=True, help="Repetitions.")
@click.option(
    "--figure",
    type=click.Path(path_type=Path),
    metavar="FILE.pdf|FILE.svg",
    help="Also write the figure for a paper; needs the package's extra `figures`.",
)
@_OUT_FOLDER
def learn(
    outcomes: Path | None,
    teachers: tuple[str, ...],
    profiles: tuple[str, ...],
    beta: float | None,
    learners: tuple[str, ...],
    pairs: tuple[str, ...],
    seeds: int,
    figure: Path | None,
    out: Path,
) -> None:
    """Study how well learners recover what teachers want.

    Teachers choose between pairs of actions, learners are fitted to the choices and put to the test
    on scenes that were kept back. Writes OUT/learning.parquet, learning.png and learning.rrd, and
    into OUT/scenes the recordings of the few scenes that learning.rrd links to; an interrupted
    study continues where it stopped.
    """
    from studio.orchestrator import Studio
    from studio.progress import Terminal
    from studio.study.teachers import read_teachers

    try:
        sizes = [int(size) for size in pairs]
    except ValueError:
        raise InputError(f"--pairs: {','.join(pairs)!r} are not whole numbers") from None
    who = read_teachers(teachers, profiles, beta)
    studio = Studio(out, Terminal())
    learned = studio.learn(outcomes, who, learners, sizes, seeds, figure=figure)
    _print_learned(learned)


@main.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--png", type=click.Path(path_type=Path), help="The picture to write.")
@click.option("--mp4", type=click.Path(path_type=Path), help="The film to write.")
@click.option("--gif", type=click.Path(path_type=Path), help="The animated GIF to write.")
@click.option("--actions", callback=_read_names, metavar="A,B", help="Only these, of a scene.")
@click.option("--size", type=Size(), help="Width and height in pixels, for example 1280x720.")
@click.option("--fps", default=30, show_default=True, help="Frames per second of films.")
@click.option(
    "--theme",
    type=click.Choice(["light", "dark"]),
    default="light",
    show_default=True,
    help="Ground of pictures and films.",
)
@click.option(
    "--codec",
    type=click.Choice(["h264", "av1"]),
    default="h264",
    show_default=True,
    help="Of the MP4.",
)
@click.option(
    "--from",
    "start",
    type=float,
    help="Where to begin: s of a scene, outcomes of a comparison, pairs of a study.",
)
@click.option("--to", "end", type=float, help="Where to end, likewise.")
def render(
    file: Path,
    png: Path | None,
    mp4: Path | None,
    gif: Path | None,
    actions: tuple[str, ...],
    size: tuple[int, int] | None,
    fps: int,
    theme: str,
    codec: str,
    start: float | None,
    end: float | None,
) -> None:
    """Paint pictures and films from a recording alone.

    Without --png, --mp4 and --gif, a picture and a film beside the recording, in place of those
    that are there. Nothing is simulated again, and recordings of older versions of the studio will
    do.
    """
    from studio.orchestrator import Studio
    from studio.progress import Terminal
    from studio.recording import Excerpt, Look

    files = [named for named in (png, mp4, gif) if named is not None]
    for option, named in {".png": png, ".mp4": mp4, ".gif": gif}.items():
        if named is not None and named.suffix != option:
            raise InputError(f"--{option[1:]}: {named}: a name that ends in {option} is needed")
    look, excerpt = Look(size, fps, theme, codec), Excerpt(actions, start, end)
    for written in Studio(progress=Terminal()).render(file, *files, look=look, excerpt=excerpt):
        click.echo(f"{written}  {_size(written)}")


@main.command()
@click.argument("file", type=click.Path(path_type=Path))
def view(file: Path) -> None:
    """Open a recording in the Rerun viewer."""
    from studio.orchestrator import Studio

    Studio().view(file)


def _print_families() -> None:
    from scenes import FAMILIES, PATTERNS

    click.echo("families")
    for name, family in FAMILIES.items():
        click.echo(f"  {name:<15} {family.description} ({', '.join(family.patterns)})")
    click.echo("patterns")
    for name, description in PATTERNS.items():
        click.echo(f"  {name:<15} {description}")


def _print_recorded(recorded: Recorded) -> None:
    rollouts, judgements = recorded.rollouts, recorded.judgements
    tries = rollouts.features.shape[1]
    heads = "".join(f"{'V ' + judgement.teacher:>10} " for judgement in judgements)
    click.echo(f"{'action':<16}{'contact':>10} {heads}")
    for index, action in enumerate(rollouts.actions):
        touched = int(rollouts.touched[index].sum())
        values = "".join(
            f"{judgement.values[index]:>10.3f}{'*' if judgement.best == index else ' '}"
            for judgement in judgements
        )
        click.echo(f"{action.name:<16}{f'{touched} of {tries}':>10} {values}")
    click.echo("* the action that this teacher would pick")
    for file in recorded.files:
        click.echo(f"{file}  {_size(file)}")


def _print_compared(compared: Compared) -> None:
    from studio.comparison.comparison import SIDES

    rollouts = compared.comparison.rollouts
    tries = rollouts.features.shape[1]
    for index, (side, action) in enumerate(zip(SIDES, rollouts.actions, strict=True)):
        touched = int(rollouts.touched[index].sum())
        click.echo(f"{side}  {action.name:<16}{touched} of {tries} with contact")
    for file in compared.files:
        click.echo(f"{file}  {_size(file)}")


def _print_learned(learned: Learned) -> None:
    from learners import learning_curves

    curves = learning_curves(learned.table)
    sizes = sorted({int(size) for curve in curves for size in curve.pairs})
    click.echo("regret on held-out scenes, in % of a random action's, mean over seeds")
    click.echo(f"{'teacher':<12}{'learner':<16}" + "".join(f"{size:>8}" for size in sizes))
    for curve in curves:
        means = "".join(f"{mean:>8.2f}" for mean in curve.mean)
        click.echo(f"{curve.teacher:<12}{curve.learner:<16}{means}")
    repeated = max(learned.table["repeated"].to_pylist())
    if repeated:
        click.echo(f"there are fewer pairs than wanted: up to {repeated} were asked again")
    unsettled = sum(not converged for converged in learned.table["converged"].to_pylist())
    if unsettled:
        click.echo(f"{unsettled} of {learned.table.num_rows} fits did not converge")
    if learned.caption:
        click.echo(f"caption: {learned.caption}")
    for file in learned.files:
        click.echo(f"{file}  {_size(file)}")


def _size(file: Path) -> str:
    count = file.stat().st_size
    return f"{count / 1e6:.1f} MB" if count >= 5e4 else f"{count / 1e3:.0f} kB"
