"""What the studio says while it works: nothing, or lines and bars for a person to read."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer

Progress = Callable[[int, int], None]
"""Told how many steps are done, and of how many."""

PATIENCE = 4.0
"""How long a person is left without a word while waiting, s."""


class Quiet:
    """Says nothing; what Python callers get unless they ask for more."""

    @contextmanager
    def steps(self, what: str) -> Iterator[Progress]:  # noqa: ARG002
        """Work in steps; the block calls what it gets with the numbers of steps done and in all."""
        yield lambda _done, _total: None

    @contextmanager
    def waiting(self, note: str) -> Iterator[None]:  # noqa: ARG002
        """Work that may take long; a person who has to wait is told why by the note."""
        yield


class Terminal(Quiet):
    """Speaks to a person on standard error: bars on a terminal only, notes always."""

    @contextmanager
    def steps(self, what: str) -> Iterator[Progress]:
        """A bar that goes away when the work is done."""
        # rich is imported late: the command line has to start fast.
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
        from rich.progress import Progress as Bars

        console = Console(stderr=True)
        with Bars(
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
            console=console,
            transient=True,
            disable=not console.is_terminal,
        ) as bars:
            task = bars.add_task(what, total=None)
            yield lambda done, total: bars.update(task, completed=done, total=total)

    @contextmanager
    def waiting(self, note: str) -> Iterator[None]:
        """The note appears only if the work takes longer than `PATIENCE`."""
        import click

        timer = Timer(PATIENCE, lambda: click.echo(note, err=True))
        timer.daemon = True
        timer.start()
        try:
            yield
        finally:
            timer.cancel()
