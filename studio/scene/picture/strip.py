"""The strip at the foot of a film: all actions, how they ended, and who would pick them."""

from collections.abc import Sequence

from scenes import Rollouts
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.judgements import Judgement
from studio.scene.picture.titles import joined
from studio.style.palette import Colour
from studio.style.words import action_label, listed


class ActionStrip:
    """All actions: those that were played, the one that is, and the rest."""

    def __init__(
        self,
        canvas: Canvas,
        cells: Sequence[Box],
        rollouts: Rollouts,
        judgements: Sequence[Judgement],
        index: int,
    ) -> None:
        colours = [canvas.theme.action_colour(name) for name in rollouts.names]
        self._canvas, self._cell, self._colour = canvas, cells[index], colours[index]
        kind, theme = canvas.type, canvas.theme
        for action, (cell, colour) in enumerate(zip(cells, colours, strict=True)):
            self._draw_bar(cell, theme.grid, 1.0)
            if action < index:
                self._draw_bar(cell, colour, 1.0)
            name = action_label(rollouts.names[action])
            ink = theme.legible(colour) if action <= index else theme.faint
            at = (cell.left, cell.top + 1.2 * kind.body)
            canvas.fit(at, name, cell.width, kind.body, ink, SEMIBOLD)
            picks = _picks(judgements, action)
            contacts = _contacts(rollouts, action) if action < index else [""]
            told = [*joined(*((contacts[0], pick) for pick in picks)), *contacts]
            is_red = action < index and rollouts.touched[action].any()
            at = (cell.left, cell.top + 2.4 * kind.body)
            canvas.fit(at, told, cell.width, kind.small, theme.contact if is_red else theme.faint)

    def draw(self, share: float) -> None:
        """Fill the bar of the action that is played up to this share."""
        self._draw_bar(self._cell, self._colour, share)

    def _draw_bar(self, cell: Box, colour: Colour, share: float) -> None:
        right = cell.left + share * cell.width
        self._canvas.fill(Box(cell.left, cell.top, right, cell.top + 4 * self._canvas.unit), colour)


def _picks(judgements: Sequence[Judgement], action: int) -> list[str]:
    """Which teachers pick an action, or may where it is open, the longest wording first."""
    those = [judgement for judgement in judgements if action in judgement.candidates]
    sure = [judgement.label for judgement in those if judgement.is_sure]
    unsure = [judgement.label for judgement in those if not judgement.is_sure]
    verb = "picks" if len(sure) == 1 else "pick"
    return joined(
        (f"{listed(sure)} {verb}" if sure else "", f"{listed(unsure)} may pick" if unsure else ""),
        (f"{', '.join(sure)} {verb}" if sure else "", f"{', '.join(unsure)}?" if unsure else ""),
        (", ".join([*sure, *(f"{label}?" for label in unsure)]),),
    )


def _contacts(rollouts: Rollouts, action: int) -> list[str]:
    """How often an action led to contact, with people and with walls, the longest wording first."""
    people = int((rollouts.person_step[action] >= 0).sum())
    walls = int(rollouts.wall_touched[action].sum())
    both = f"× {people} □ {walls}" if walls else f"× {people}"
    return [f"{both} of {rollouts.count}", both, f"{people + walls}"]
