"""What the studio raises; the command line turns each into one line and an exit code."""


class InputError(ValueError):
    """The user's input cannot be used (exit code 2).

    The message is one line that names the option, what was given and what is allowed.
    """


class RunError(RuntimeError):
    """The work failed while running, through no fault of the input (exit code 1)."""


def input_errors() -> tuple[type[Exception], ...]:
    """What any room raises for wrong input: scenes and learners know nothing of the studio's error.

    This is called only once an error is there, so that loading the rooms costs nobody time.
    """
    from learners import InputError as OfLearners
    from scenes import InputError as OfScenes

    return InputError, OfLearners, OfScenes
