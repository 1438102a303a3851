"""The command lines that make things again."""

import shlex
from dataclasses import fields

from scenes import META_ACTIONS, Limits, Noise, Rollouts
from scenes.rollouts import DEFAULT_STEP


def simulation_options(rollouts: Rollouts) -> str | None:
    """The options with which a command simulates the same again, given the scene as a file.

    It simulates all of `META_ACTIONS`, whether or not all of them are in the rollouts.

    Returns:
        None if no command does: what is special about it can only be said from Python.
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
    return shlex.join(options)


def how_to_make_again(rollouts: Rollouts, command: str | None) -> list[str]:
    """Lines of Markdown that say how a recording is made again from its scene.

    Args:
        rollouts: what was simulated.
        command: the words before the options, for example `studio record`; None if no command
            has these actions.
    """
    options = simulation_options(rollouts)
    if command is None or options is None:
        return [
            "No command does this: its actions, limits, step or angles are special. Simulate the "
            "scene below from Python with the settings that the properties of the recording hold.",
        ]
    return [
        f"Save the scene below as `{rollouts.scene.name}.toml`, then run",
        "",
        "```sh",
        f"{command} {options}",
        "```",
    ]
