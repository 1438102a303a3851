"""How a command ends that fails: in one line on standard error, with an exit code.

Exit codes: 0 done, 1 failed while running, 2 the user's input was wrong, 130 interrupted. Only a
fault of the program itself ends in a traceback.
"""

import signal
import sys
from typing import Any, NoReturn

import click

from studio.errors import RunError, input_errors


class Interruption(KeyboardInterrupt):
    """The user, or whoever ends processes, asked the command to stop.

    It has a type of its own because Python ends by the signal, whatever exit code it is told, once
    a plain KeyboardInterrupt has come out of an import.
    """


class OneLineErrors(click.Group):
    """A group of commands whose errors are one line and an exit code."""

    def main(self, *args: Any, **keywords: Any) -> NoReturn:
        """Run the command line, then leave the process."""
        try:
            signal.signal(signal.SIGTERM, _stop)
            # a process that was started to ignore interruptions goes on ignoring them
            if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
                signal.signal(signal.SIGINT, _stop)
            code = super().main(*args, **(keywords | {"standalone_mode": False}))
        except click.exceptions.NoArgsIsHelpError as error:
            click.echo(error.format_message())
            sys.exit(2)
        except click.ClickException as error:
            _leave(error.format_message(), error.exit_code)
        except (click.Abort, KeyboardInterrupt):
            _leave("interrupted", 130)
        except (RunError, OSError, MemoryError) as error:
            _leave(str(error) or "out of memory", 1)
        except ValueError as error:
            if not isinstance(error, input_errors()):
                raise
            _leave(str(error), 2)
        sys.exit(code if isinstance(code, int) else 0)


def _stop(_signal: int, _frame: object) -> NoReturn:
    """End as an interruption does, so that nothing half-written is left behind."""
    raise Interruption


def _leave(message: str, code: int) -> NoReturn:
    click.echo(f"studio: {' '.join(message.split())}", err=True)
    sys.exit(code)
