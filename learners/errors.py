"""What is raised when the caller's input is wrong."""


class InputError(ValueError):
    """The caller gave something that cannot be used.

    The message is one line that names the field, what was given and what is allowed.
    """
