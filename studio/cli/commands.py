"""The commands, each of which parses, calls the orchestrator, and prints what came of it.

Everything heavy is imported where it is used, so that the help comes at once.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from studio.cli.failures import OneLineErrors
from studio.cli.options import (
    FORCE,
    OUT_FOLDER,
    PixelSize,
    SpanOption,
    file_options,
    read_names,
    read_sizes,
    scene_options,
    simulation_options,
    take_source,
)
from studio.errors import InputError

if TYPE_CHECKING:
    from studio.orchestrator import Studio


@click.group(cls=OneLineErrors)
@click.version_option(package_name="prospect-studio")
def main() -> None:
    """See what a robot risks among pedestrians, and what people make of it."""


@main.command()
@scene_options
@simulation_options
@file_options
def record(out: Path, no_png: bool, no_mp4: bool, **given: Any) -> None:
    """Simulate a scene; write its recording, picture and film.

    Writes OUT/NAME.rrd (open it with `studio view`), NAME.png and NAME.mp4. NAME tells the scene,
    its pattern, number and seed where they are not the usual ones, for example intersection-11.
    Files of something else are not replaced, unless by --force.
    """
    from studio.cli.reports import recorded_report

    source = take_source(given)
    recorded = _studio(out).record(source, png=not no_png, mp4=not no_mp4, **given)
    _print(recorded_report(recorded))


@main.command()
@click.argument("one")
@click.argument("other")
@click.option("--names", is_flag=True, help="Tell which action is where, and who values it how.")
@scene_options
@simulation_options
@file_options
def compare(one: str, other: str, out: Path, no_png: bool, no_mp4: bool, **given: Any) -> None:
    """Put two actions of a scene side by side: which would you rather the robot did?

    For example `studio compare --scene doorway forward slow_down`. Every outcome of both actions
    plays, one after the other, with the same people and the same luck on both sides. The seed
    chooses the sides, and nobody is told which action is where: not by OUT/NAME-compare-DIGEST.rrd,
    .png and .mp4, nor by the terminal. With --names, the actions stand in the picture, and the
    files are called NAME-ONE-OTHER.
    """
    from studio.cli.reports import compared_report

    source = take_source(given)
    compared = _studio(out).compare(source, one, other, png=not no_png, mp4=not no_mp4, **given)
    _print(compared_report(compared))


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
    from scenes import FAMILIES, busiest_frames, scene_to_toml
    from studio.cli.reports import families_report, frames_report
    from studio.scene.sources import is_file, numbered_scene

    if pattern is not None and name not in FAMILIES:
        raise InputError("--pattern: goes with the NAME of a family")
    if name is None:
        _print(families_report())
    elif name not in FAMILIES and is_file(name):
        _print(frames_report(busiest_frames(Path(name))))
    else:
        click.echo(scene_to_toml(numbered_scene(name, pattern, seed, number)), nl=False)


@main.command()
@click.option("--scenes", default=300, show_default=True, help="How many scenes.")
@click.option(
    "--families", callback=read_names, metavar="A,B", help="Families to draw from; all of them."
)
@click.option(
    "--patterns", callback=read_names, metavar="A,B", help="Patterns to draw from; all of them."
)
@simulation_options
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
    from studio.cli.reports import sampled_report

    wanted = BankPlan(**plan)
    _print(sampled_report(wanted, _studio().sample(out, wanted)))


@main.command()
@click.option(
    "--outcomes",
    type=click.Path(path_type=Path),
    help="The outcome bank; left out, the default bank is sampled to OUT/outcomes.parquet.",
)
@click.option(
    "--teachers", callback=read_names, default="eu,tk,strong", show_default=True, metavar="A,B"
)
@click.option(
    "--profile",
    "profiles",
    multiple=True,
    metavar="NAME=α,η,λ,γ,δ",
    help="A teacher of your own, for example cautious=0.9,0.9,4,0.6,0.7; repeatable.",
)
@click.option("--beta", type=float, help="How decided the teachers are; 20 if left out.")
@click.option("--learners", callback=read_names, default="eu,cpt", show_default=True, metavar="A,B")
@click.option(
    "--pairs",
    callback=read_sizes,
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
@OUT_FOLDER
@click.option("--name", default="learning", show_default=True, help="Name of the files.")
@FORCE
def learn(
    outcomes: Path | None,
    teachers: tuple[str, ...],
    profiles: tuple[str, ...],
    beta: float | None,
    learners: tuple[str, ...],
    pairs: tuple[int, ...],
    seeds: int,
    figure: Path | None,
    out: Path,
    name: str,
    force: bool,
) -> None:
    """Study how well learners recover what teachers want.

    Teachers choose between pairs of actions, learners are fitted to the choices and put to the test
    on scenes that were kept back. Writes OUT/learning.parquet, learning.png (the finding),
    learning-2.png (what was learned) and learning.rrd, and into OUT/scenes the recordings of the
    few scenes that learning.rrd links to; an interrupted study continues where it stopped. Fits of
    another study are not replaced, unless by --force.
    """
    from studio.cli.reports import learned_report
    from studio.study.teachers import read_teachers

    who = read_teachers(teachers, profiles, beta)
    learned = _studio(out).learn(
        outcomes, who, learners, pairs, seeds, figure, name=name, force=force
    )
    _print(learned_report(learned))


@main.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--png", type=click.Path(path_type=Path), help="The picture to write.")
@click.option("--mp4", type=click.Path(path_type=Path), help="The film to write.")
@click.option("--gif", type=click.Path(path_type=Path), help="The animated GIF to write.")
@click.option("--actions", callback=read_names, metavar="A,B", help="Only these, of a scene.")
@click.option("--size", type=PixelSize(), help="Width and height in pixels, for example 1280x720.")
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
@click.option("--from", "start", type=float, cls=SpanOption, help="Where to begin:")
@click.option("--to", "end", type=float, help="Where to end, in the same unit.")
@click.option("--page", default=1, show_default=True, help="Of the picture; a study has two.")
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
    page: int,
) -> None:
    """Paint pictures and films from a recording alone.

    Without --png, --mp4 and --gif, a picture and a film beside the recording, in place of those
    that are there. Nothing is simulated again, and recordings of older versions of the studio will
    do.
    """
    from studio.cli.reports import files_report
    from studio.recording import Excerpt, Look

    files = [named for named in (png, mp4, gif) if named is not None]
    for option, named in {".png": png, ".mp4": mp4, ".gif": gif}.items():
        if named is not None and named.suffix != option:
            raise InputError(f"--{option[1:]}: {named}: a name that ends in {option} is needed")
    look, excerpt = Look(size, fps, theme, codec), Excerpt(actions, start, end, page)
    _print(files_report(_studio().render(file, *files, look=look, excerpt=excerpt)))


@main.command()
@click.argument("file", type=click.Path(path_type=Path))
def view(file: Path) -> None:
    """Open a recording in the Rerun viewer."""
    _studio().view(file)


def _studio(out: str | Path = "recordings") -> Studio:
    """The studio that writes into this folder and tells a person how far the work is."""
    from studio.orchestrator import Studio
    from studio.progress import Terminal

    return Studio(out, Terminal())


def _print(lines: Iterable[str]) -> None:
    for line in lines:
        click.echo(line)
