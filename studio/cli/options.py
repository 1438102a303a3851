"""The options that several commands share, and how what a person types into them is read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from studio.errors import InputError

if TYPE_CHECKING:
    from scenes import Noise
    from studio.scene.sources import Source

Command = Callable[..., None]


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


class PixelSize(click.ParamType[tuple[int, int]]):
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


def read_noise(_context: click.Context, _option: click.Parameter, given: tuple[str, ...]) -> Noise:
    """The noise whose settings are given as `NAME=NUMBER`; the others stay as usual."""
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


def read_names(
    _context: click.Context, _option: click.Parameter, given: str | None
) -> tuple[str, ...]:
    """The names that are given as `A,B`; none if the option is left out."""
    return tuple(name.strip() for name in given.split(",")) if given else ()


def read_sizes(context: click.Context, option: click.Parameter, given: str) -> tuple[int, ...]:
    """The whole numbers that are given as `N,M`."""
    names = read_names(context, option, given)
    try:
        return tuple(map(int, names))
    except ValueError:
        raise InputError(f"--pairs: {','.join(names)!r} are not whole numbers") from None


class SpanOption(click.Option):
    """An option whose help ends with what parts of recordings are counted in, kind by kind."""

    def get_help_record(self, context: click.Context) -> tuple[str, str] | None:
        """The option and its help, for which the kinds of recordings are asked only now."""
        from studio.kinds import spans

        record = super().get_help_record(context)
        return record and (record[0], f"{record[1]} {spans()}.")


OUT_FOLDER = click.option(
    "--out",
    type=click.Path(path_type=Path),
    default="recordings",
    show_default=True,
    help="Folder for the files.",
)


def simulation_options(command: Command) -> Command:
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
            callback=read_noise,
            help="Strength of one source of noise, for example acceleration=0.5; repeatable.",
        ),
    ]
    return _with(options, command)


_SCENE_OPTIONS = ("scene", "pattern", "number", "frame", "robot_start", "robot_goal")


def scene_options(command: Command) -> Command:
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


def take_source(given: dict[str, Any]) -> Source:
    """Take which scene is meant out of the options given."""
    from studio.scene.sources import Source

    return Source(seed=given["seed"], **{name: given.pop(name) for name in _SCENE_OPTIONS})


FORCE = click.option(
    "--force", is_flag=True, help="Replace files of something else that have these names."
)


def file_options(command: Command) -> Command:
    """The options that say what is written where."""
    options = [
        OUT_FOLDER,
        click.option(
            "--name", help="Name of the files, without an ending; the scene's if left out."
        ),
        FORCE,
        click.option("--no-png", is_flag=True, help="Write no picture."),
        click.option("--no-mp4", is_flag=True, help="Write no film."),
    ]
    return _with(options, command)


def _with(options: Sequence[Callable[[Command], Command]], command: Command) -> Command:
    """The command with options, listed in this order."""
    for option in reversed(options):
        command = option(command)
    return command
