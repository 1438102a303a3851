"""The page about a recording of two actions, in Markdown."""

from studio.comparison.comparison import QUESTION, SIDES, Comparison
from studio.comparison.recording import entities
from studio.recorder.markdown import plain
from studio.scene.again import command_again, how_to_make_again
from studio.scene.judgements import Judgement
from studio.scene.recording.pages import outcome_table
from studio.style.words import action_label, counted, number


def comparison_page(comparison: Comparison, judgements: tuple[Judgement, ...]) -> str:
    """What one sees in a comparison, what came of it, and how it was made."""
    rollouts = comparison.rollouts
    sides = [
        f"* **{side}**: {plain(action_label(action.name))}, {number(action.speed)} m/s, "
        f"{number(action.turn_rate)} rad/s"
        for side, action in zip(SIDES, rollouts.actions, strict=True)
    ]
    command = command_again(["studio", "compare", *rollouts.names], rollouts)
    settings = [
        f"The seed also chooses the sides, here {comparison.seed}. All other settings are "
        "properties of the recording."
    ]
    return "\n".join(
        [
            f"# {rollouts.scene.name}",
            "",
            QUESTION,
            "",
            *sides,
            "",
            f"Each was simulated {counted(rollouts.count, 'time')} for {rollouts.horizon:g} s. The "
            "same outcome plays on both sides at once, with the same people and the same luck: the "
            "sides differ in nothing but the action. Which one is on the left is random.",
            "",
            "## What one sees",
            "",
            f"* Along the timeline `{entities.STORY}` one outcome plays after the other, much "
            "faster than in reality. Its path stays; a red cross marks where the robot touched "
            "somebody or a wall. Space stops the play and lets it go on.",
            "* Below, a dot joins the others when an outcome has ended: in the array of all "
            "outcomes, contacts from the left and the rest from the right; by how much closer the "
            "robot came to its goal; and by the smallest gap to a person, touching apart from "
            "however near a miss. Both sides have the same axes. Red is contact.",
            "* All at once: every outcome in the same world. Choose the timeline `sim_time` to "
            "see them move.",
            "",
            "## What the teachers make of it",
            "",
            *outcome_table(rollouts, judgements),
            "",
            *how_to_make_again(rollouts, command, settings),
        ]
    )
