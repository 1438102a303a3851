"""What a study says in sentences, whoever shows it: pictures, recordings and figures for papers.

Where a function gives several wordings of one thing, the longest comes first, and a picture takes
the first that has room.
"""

import math

from learners import FEATURES, CptParameters, Teacher
from studio.study.results import Stage, StudyResults
from studio.style.words import counted, learner_name, listed, number, short, signed, teacher_name

NO_FITS = "no fits yet"


def teacher_called(teacher: Teacher) -> str:
    """A teacher as sentences call them, for example "T&K teacher"."""
    return f"{teacher_name(teacher.name)} teacher"


def learner_called(learner: str) -> str:
    """A learner as sentences call it, for example "CPT learner"."""
    return f"{learner_name(learner)} learner"


def short_teacher_name(teacher: Teacher) -> str:
    """A teacher's name that fits into a figure."""
    return short(teacher_name(teacher.name))


def parameters_told(teacher: Teacher) -> str:
    """A teacher's parameters in one line."""
    given = zip(CptParameters.SYMBOLS, teacher.parameters.numbers, strict=True)
    return "  ".join(f"{symbol} {number(value, '.3g')}" for symbol, value in given)


def feature_names(count: int) -> list[str]:
    """The names of the features whose worth the numbers of a θ of this length are."""
    if count == len(FEATURES):
        return list(FEATURES)
    return [f"feature {index + 1}" for index in range(count)]


# The picture


def study_titles(results: StudyResults) -> list[str]:
    """Wordings of what the picture is about."""
    rest = ["Learning what people prefer", "Preferences learnt"]
    if results.shaped and len(results.shaped) < len(results.learners):
        return ["Learning what people prefer, with and without their sense of risk", *rest]
    return rest


def findings_told(stage: Stage) -> list[str]:
    """Wordings of the result so far: which of two learners has less regret, and of whom.

    A teacher counts where the 95 % interval of the paired difference at the most pairs leaves no
    doubt. Without two learners it is a title that states no result.
    """
    results = stage.results
    if results.paired is None or not stage.sizes:
        return study_titles(results)
    pairs, (ours, theirs) = stage.sizes[-1], map(learner_name, results.paired)
    better, worse, undecided = list[str](), list[str](), list[str]()
    for teacher in results.taught:
        found = results.difference(teacher, *results.paired, pairs)
        if found is None:
            continue
        is_open = found.runs < 2 or found.low <= 0.0 <= found.high
        group = undecided if is_open else better if found.difference < 0.0 else worse
        group.append(teacher_name(teacher.name))
    groups = [(ours, theirs, better), (theirs, ours, worse)]
    if not better and not worse:
        whole = some = short = counts = f"whether {ours} has less regret than {theirs} is open"
    else:
        sure = [(f"{who} has less regret than {other} for ", of) for who, other, of in groups if of]
        # teachers are called so, since learners have the same names
        short = ", ".join(
            f"{claim}{'teacher' if len(names) == 1 else 'teachers'} {listed(names)}"
            for claim, names in sure
        )
        whole = short + (f", open for {listed(undecided)}" if undecided else "")
        some = short + (", the rest open" if undecided else "")
        everybody = counted(len(better) + len(worse) + len(undecided), "teacher")
        counts = ", ".join(f"{claim}{len(names)} of {everybody}" for claim, names in sure)
    return [
        f"After {counted(pairs, 'pair')}, {whole}",
        _capital(whole),
        _capital(some),
        f"After {counted(pairs, 'pair')}, {short}",
        _capital(short),
        _capital(counts),
        *study_titles(results),
    ]


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


def finding_notes(results: StudyResults) -> list[str]:
    """What the marks of the first page mean, in sentences."""
    if not results.fits:
        return []
    said = ["Regret on held-out scenes, in % of what a random action costs; both axes logarithmic"]
    if results.seeds > 1:
        said.append(
            f"Line: mean over {results.seeds} seeds, band: its 95 % bootstrap interval; "
            "dots: seeds; bars: interquartile mean with its 95 % interval"
        )
        if results.regrets.has_less:
            said.append("Small triangles: seeds whose regret is less than the axis shows")
        if results.paired:
            said.append("In the heads: paired difference at the most pairs with its 95 % interval")
    return [f"{note}." for note in said]


def study_subtitles(results: StudyResults, left_out: int) -> list[str]:
    """Wordings of what was studied as a whole, if this number of its teachers is left out."""
    if not results.fits:
        return [NO_FITS]
    fits = counted(len(results.fits), "fit")
    people = counted(len(results.teachers), "teacher")
    if left_out:
        people = f"{len(results.teachers)} of {len(results.teachers) + left_out} teachers"
    pairs = counted(results.sizes[-1], "pair")
    if len(results.sizes) > 1:
        pairs = f"{len(results.sizes)} sizes of {results.sizes[0]} to {pairs}"
    learners, seeds = counted(len(results.learners), "learner"), counted(results.seeds, "seed")
    end = f" · {results.unsettled} did not converge" if results.unsettled else ""
    if all(row["converged"] for row in results.fits):
        end = " · all converged"
    sure = results.certainty
    certain = "" if sure is None else f" · answers {round(100 * sure)} % certain"
    short_end = f" · {results.unsettled} not converged" if results.unsettled else ""
    everything = f"{fits}: {people} × {learners} × {pairs} × {seeds}"
    return [
        f"{everything} · tested on held-out scenes{certain}{end}",
        f"{everything}{certain}{end}",
        f"{everything}{short_end}",
        f"{fits}{short_end}",
    ]


def reached(stage: Stage) -> str:
    """How many pairs were learned from; nothing if nobody learned yet."""
    return counted(stage.sizes[-1], "pair") if stage.sizes else ""


def notes(stage: Stage) -> list[str]:
    """What the lines and marks of the second page mean, in sentences, but for errors."""
    if not stage.fits:
        return []
    results, most = stage.results, reached(stage)
    seeds = len({row["seed"] for row in stage.fits})
    said = []
    if seeds > 1:
        said.append(f"Picks: mean over {seeds} seeds, band: its 95 % bootstrap interval")
        if len(results.learners) > 1:
            said.append(f"[ ]: 95 % interval of the paired difference of regrets at {most}")
    if results.shaped:
        shades = ", ".join(map(str, stage.sharpening))
        said.append(
            f"Weights and value: {learner_name(results.shaped[0])}, a line a seed"
            + (f" after {shades} pairs" if len(stage.sharpening) > 1 else "")
            + ", dashed: teacher; x in the teacher's units"
        )
        said.append(
            "EU: expected utility, CPT: cumulative prospect theory; "
            "α, η: curvature of gains and losses, λ: loss aversion, "
            "γ, δ: weighting of gains' and losses' probabilities"
        )
    each = "a dot a seed, large: mean, " if seeds > 1 else ""
    numbers = "Reward and parameters" if results.shaped else "Reward"
    said.append(f"{numbers} at {most}: {each}bar: teacher")
    return [f"{note}." for note in said]


def error_notes(stage: Stage) -> list[str]:
    """What the lines of prediction errors mean, in sentences; none if there is but one kind."""
    if len(stage.sizes) < 2:
        return []
    return [f"Errors: bold {reached(stage)}, thin {stage.sizes[0]}."]


def verdicts(stage: Stage, teacher: Teacher) -> list[str]:
    """Wordings of how two learners' regrets differ at the most pairs so far; none if unknown."""
    results = stage.results
    if results.paired is None or not stage.sizes:
        return []
    found = results.difference(teacher, *results.paired, stage.sizes[-1])
    if found is None:
        return []
    ours, theirs = map(learner_name, results.paired)
    times = f"{ours}'s regret is {number(found.ratio, '.2f')} × {theirs}'s"
    brief = f"{ours} {number(found.ratio, '.2f')} × {theirs}"
    shift, low, high = map(signed, (found.difference, found.low, found.high))
    if not math.isfinite(found.ratio) or shift == signed(0.0):
        times, brief = f"{ours}'s regret − {theirs}'s", f"{ours} − {theirs}"
    interval = f" [{low}, {high}]" if found.runs > 1 else ""
    return [
        f"At {reached(stage)} {times}: {shift} percentage points{interval}",
        f"{times}: {shift} percentage points{interval}",
        f"{times}: {shift} % points{interval}",
        f"{brief}: {shift} % points{interval}",
        f"{brief}: {shift}{interval}",
        f"{brief}: {shift}",
    ]


# The recording


def lesson(results: StudyResults, teacher: Teacher) -> str:
    """Which learner has the least regret after the most pairs, and how sure that is.

    Empty if there are no two learners of this teacher.
    """
    pairs = results.sizes[-1]
    regrets = {
        curve.learner: spread.mean
        for curve in results.curves_of("regret_percent", teacher)
        if (spread := curve.at(pairs))
    }
    ranked = sorted(regrets, key=regrets.__getitem__)
    if len(ranked) < 2:
        return ""
    best, worst = ranked[0], ranked[-1]
    names = f"The {learner_called(best)} has less regret than the {learner_called(worst)}"
    found = results.difference(teacher, best, worst, pairs)
    if found is None:
        return f"{names} in the mean."
    shift, low, high = map(signed, (found.difference, found.low, found.high))
    if shift == signed(0.0):
        both = f"The {learner_called(best)} and the {learner_called(worst)}"
        return f"{both} have the same regret in the mean, to 0.01 percentage points."
    if found.runs == 1:
        return f"{names} in the one seed: {shift} percentage points."
    interval = f"{shift} percentage points [{low}, {high}]"
    if found.high < 0.0:
        return f"{names}: {interval}."
    return f"{names} in the mean, though not for sure: {interval}."


# The figure for a paper


def panel_titles(results: StudyResults) -> list[str]:
    """Titles of the panels of the figure, one a teacher."""
    # what cannot be printed would break lines, and is not allowed in an SVG's metadata
    names = [
        "".join(letter if letter.isprintable() else " " for letter in teacher_called(teacher))
        for teacher in results.teachers
    ]
    if len(names) == 1:
        return names
    return [f"({chr(ord('a') + index)}) {name}" for index, name in enumerate(names)]


def paper_caption(results: StudyResults) -> str:
    """What a reader of the figure needs to know beside it, in one line."""
    curves = results.curves("regret_percent")
    if not curves:
        return f"Held-out regret: {NO_FITS}."
    pairs = counted(results.sizes[-1], "preference pair")
    if len(results.sizes) > 1:
        pairs = f"{results.sizes[0]} to {pairs}"
    *others, last = panel_titles(results)
    panels = f"{', '.join(others)} and {last}" if others else last
    said = [f"Held-out regret, in % of a random action's, after {pairs}: {panels}"]
    runs = {int(count) for curve in curves for count in curve.runs}
    seeds = counted(max(runs), "seed")
    if max(runs) > 1:
        some = f"{min(runs)} to {seeds}" if len(runs) > 1 else seeds
        said.append(f"Marks: mean over {some}; bands: 95 % bootstrap interval of the mean")
    else:
        said.append(f"Marks: {seeds}")
    said.append("Logarithmic axes")
    if results.certainty is not None:
        said.append(f"Answers were {round(100 * results.certainty)} % certain on average")
    if results.unsettled:
        fits = counted(len(results.fits), "fit")
        said.append(f"{results.unsettled} of {fits} did not converge")
    return " ".join(f"{sentence}." for sentence in said)
