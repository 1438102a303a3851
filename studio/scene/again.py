"""The command lines that make a simulation again, given its scene as a file."""

import shlex
from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields

from scenes import META_ACTIONS, Limits, Noise, Rollouts, scene_to_toml
from scenes.rollouts import DEFAULT_STEP


def record_command(rollouts: Rollouts) -> str | None:
    """The command that records a scene again; None if no command does."""
    has_all = rollouts.actions == META_ACTIONS
    return command_again(["studio", "record"], rollouts) if has_all else None


def command_again(words: Sequence[str], rollouts: Rollouts) -> str | None:
    """A command that begins with these words, and the options by which it simulates the same again.

    Commands simulate all of `META_ACTIONS`, whether or not all of them are in the rollouts.

    Returns:
        None if no options do: what is special about the simulation can only be said from Python.
    """
    is_usual = (
        set(rollouts.actions) <= set(META_ACTIONS)
        and rollouts.limits == Limits()
        and rollouts.wrap_angles
        and rollouts.dt == DEFAULT_STEP
    )
    if not is_usual:
        return None
    options = ["--scene", f"{rollouts.scene.name}.toml", "--seed", str(rollouts.seed)]
    options += ["--rollouts", str(rollouts.count), "--horizon", f"{rollouts.horizon:g}"]
    options += ["--model", rollouts.model, "--engine", rollouts.engine]
    for field in fields(Noise):
        given = getattr(rollouts.noise, field.name)
        if given != field.default:
            options += ["--noise", f"{field.name}={given!r}"]
    return shlex.join([*words, *options])


def how_to_make_again(
    rollouts: Rollouts, command: str | None, settings: Sequence[str]
) -> list[str]:
    """The lines of Markdown at the end of a page that say how its recording is made again.

    The command is None if no command does it; the settings are lines of Markdown as well.
    """
    name = rollouts.scene.name
    if command is None:
        told = [
            "No command does this: its actions, limits, step or angles are special. Simulate the "
            "scene below from Python with the settings that the properties of the recording hold."
        ]
    else:
        told = [f"Save the scene below as `{name}.toml`, then run", "", "```sh", command, "```"]
    scene = ["```toml", scene_to_toml(rollouts.scene).rstrip(), "```"]
    return ["## Make it again", "", *told, "", *settings, "", *scene]


def settings_of(rollouts: Rollouts, versions: Mapping[str, str]) -> list[tuple[str, str]]:
    """The settings of a simulation and the versions of what made it, by their names."""
    settings = {
        "seed": rollouts.seed,
        "rollouts": rollouts.count,
        "steps": f"{rollouts.steps} of {rollouts.dt:g} s",
        "model": rollouts.model,
        "engine": rollouts.engine,
        "wrap_angles": rollouts.wrap_angles,
        **{f"noise: {name}": given for name, given in asdict(rollouts.noise).items()},
        **{f"limits: {name}": given for name, given in asdict(rollouts.limits).items()},
        **{f"version: {name}": given for name, given in versions.items()},
    }
    return [(name, str(given)) for name, given in settings.items()]
