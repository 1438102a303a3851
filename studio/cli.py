"""The command line: it parses, calls the orchestrator, and prints.

Exit codes: 0 done, 1 failed while running, 2 the user's input was wrong, 130 interrupted. What
goes wrong ends in one line on standard error; only a fault of the program itself ends in a
traceback.
"""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from studio.errors import InputError, RunError

if TYPE_CHECKING:
    from scenes import Noise
    from studio.orchestrator import Learned, Recorded


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
    """The options that `record` and `sample` share."""
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
    for option in reversed(options):
        command = option(command)
    return command


@click.group(cls=OneLineErrors)
@click.version_option(package_name="prospect-studio")
def main() -> None:
    """See what a robot risks among pedestrians, and what people make of it."""


@main.command()
@click.option(
    "--scene",
    required=True,
    metavar="NAME|FILE.toml|TRACKS",
    help="A family (see `studio scenes`), a scene file, or the obsmat.txt of recorded tracks.",
)
@click.option("--pattern", help="How people meet, for a family.")
@click.option("--number", type=int, help="Which scene of the seed's series, for a family.")
@click.option("--frame", type=int, help="Which frame, for tracks; the busiest if left out.")
@click.option("--robot-start", type=Place(), help="Where the robot starts, for tracks.")
@click.option("--robot-goal", type=Place(), help="Where the robot is headed, for tracks.")
@_simulation_options
@_OUT_FOLDER
@click.option("--no-png", is_flag=True, help="Write no picture.")
@click.option("--no-mp4", is_flag=True, help="Write no film.")
def record(
    scene: str,
    pattern: str | None,
    number: int | None,
    frame: int | None,
    robot_start: tuple[float, float] | None,
    robot_goal: tuple[float, float] | None,
    seed: int,
    out: Path,
    no_png: bool,
    no_mp4: bool,
    **settings: Any,
) -> None:
    """Simulate a scene; write its recording, picture and film.

    Writes OUT/NAME.rrd (open it with `studio view`), NAME.png and NAME.mp4.
    """
    from studio.orchestrator import Studio
    from studio.progress import Terminal
    from studio.sources import Source

    source = Source(scene, pattern, seed, number, frame, robot_start, robot_goal)
    studio = Studio(out, Terminal())
    _print_recorded(studio.record(source, seed, png=not no_png, mp4=not no_mp4, **settings))


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
    from studio.sources import is_file

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
    from studio.teachers import read_teachers

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
        touched = int((rollouts.contact_step[index] >= 0).sum())
        values = "".join(
            f"{judgement.values[index]:>10.3f}{'*' if judgement.best == index else ' '}"
            for judgement in judgements
        )
        click.echo(f"{action.name:<16}{f'{touched} of {tries}':>10} {values}")
    click.echo("* the action that this teacher would pick")
    for file in recorded.files:
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
