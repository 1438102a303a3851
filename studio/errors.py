"""What the studio raises; the command line turns each into one line and an exit code."""


class InputError(ValueError):
    """The user's input cannot be used (exit code 2).

    The message is one line that names the option, what was given and what is allowed.
    """


class RunError(RuntimeError):
    """The work failed while running, through no fault of the input (exit code 1)."""


def input_errors() -> tuple[type[Exception], ...]:
    """What any room raises for wrong input: scenes and learners know nothing of the studio's error.

    The rooms are loaded for this, which only one of them can have raised anyway.
    """
    from learners import InputError as OfLearners
    from scenes import InputError as OfScenes

    return InputError, OfLearners, OfScenes
