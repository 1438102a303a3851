"""The page about a recording of two actions, in Markdown; nobody is to read it before choosing."""

from studio.comparison.comparison import QUESTION, SIDES, Comparison
from studio.comparison.recording import entities
from studio.recorder.markdown import plain
from studio.scene.again import command_again, how_to_make_again
from studio.scene.judgements import Judgement
from studio.scene.recording.pages import outcome_table, picks_told
from studio.scene.words import bias_told, draws_told
from studio.style.words import action_label, counted, number


def comparison_page(comparison: Comparison, judgements: tuple[Judgement, ...]) -> str:
    """What one sees in a comparison, what came of it, and how it was made."""
    rollouts, shown = comparison.rollouts, comparison.shown
    sides = [
        f"* **{side}**: {plain(action_label(action.name))}, {number(action.speed)} m/s, "
        f"{number(action.turn_rate)} rad/s"
        for side, action in zip(SIDES, rollouts.actions, strict=True)
    ]
    words = ["studio", "compare", *rollouts.names, *(["--names"] if comparison.named else [])]
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
            f"Each was simulated {counted(rollouts.count, 'time')} for {rollouts.horizon:g} s with "
            "the same people and the same luck. Which one is on the left is random.",
            "",
            "## What one sees",
            "",
            f"* Along the timeline `{entities.STORY}` one of {rollouts.paths} outcomes plays after "
            "the other, the first three slowly. Its path stays, and an icon and a dot on each axis "
            "appear. A red × says that a person was touched, a red square that a wall was.",
            "* All at once: all paths, and histograms, red where a person was touched. Choose the "
            "timeline `sim_time` to see all move, or `rollout` for one after the other.",
            "* Outcomes: all numbers, a row an outcome; the first outcome is rollout 0.",
            "* Whatever is hovered or selected tells what came of its outcome.",
            "",
            "## What the teachers make of it",
            "",
            *outcome_table(shown, judgements),
            "",
            *picks_told(shown, judgements),
            "",
            *(draws_told(judgements, rollouts.count) for _ in judgements[:1]),
            bias_told(judgements, shown.names, rollouts.count),
            "",
            *how_to_make_again(rollouts, command_again(words, rollouts), settings),
        ]
    )
