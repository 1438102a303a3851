"""Markdown for the pages of a recording: tables, and links to what the recording holds."""

import re
from collections.abc import Iterable, Sequence

_ALIGNMENTS = {"l": ":--", "r": "--:"}


def table(heads: Sequence[str], alignment: str, rows: Iterable[Sequence[str]]) -> list[str]:
    """The lines of a table.

    Args:
        heads: what stands above each column.
        alignment: one letter a column, `l` for left or `r` for right.
        rows: what stands in each cell, as Markdown.
    """
    rule = "|".join(_ALIGNMENTS[letter] for letter in alignment)
    return [_row(heads), f"|{rule}|", *map(_row, rows)]


def link(words: str, entity: str) -> str:
    """A link to an entity of the recording, which the viewer then selects.

    Args:
        words: what the link reads, as Markdown; see `plain` for words of a user's own.
        entity: path of the entity.
    """
    # a link ends at a space unless it is in angle brackets, and loses its backslashes
    target = entity.replace("\\", "\\\\")
    return f"[{words}](<recording://{target}>)"


def plain(words: str) -> str:
    """Words in which nothing is taken for Markdown."""
    return re.sub(r"([\\|\[\]*_`<])", r"\\\1", words)


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
