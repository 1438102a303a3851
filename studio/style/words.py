"""Names, numbers and counts as people read them, in figures and in text."""

from collections.abc import Sequence

LONGEST_NAME = 22
"""Longer names of actions are cut in the middle in figures, in characters."""

TEACHER_NAMES = {"eu": "EU", "tk": "T&K", "strong": "Strong"}

LEARNER_NAMES = {
    "eu": "EU",
    "cpt": "CPT",
    "cpt-tied": "CPT tied",
    "cpt-reference": "CPT reference",
    "cpt-tied-reference": "CPT tied reference",
}


def teacher_name(teacher: str) -> str:
    """What people call a teacher."""
    return TEACHER_NAMES.get(teacher, teacher)


def learner_name(learner: str) -> str:
    """What people call a learner."""
    return LEARNER_NAMES.get(learner, learner)


def short_label(name: str) -> str:
    """An action's label that fits into a figure."""
    return short(action_label(name))


def short(name: str, longest: int = LONGEST_NAME) -> str:
    """A name of so many characters at most, cut in the middle: long names differ at their ends."""
    kept = (longest - 1) // 2
    return name if len(name) <= longest else f"{name[:kept].rstrip()}…{name[-kept:].lstrip()}"


def action_label(name: str) -> str:
    """What people read for the name of an action: `slow_down` is written "slow down"."""
    return name.replace("_", " ")


def number(value: float, form: str = "g") -> str:
    """A number with the minus sign that people write."""
    return format(value, form).replace("-", "−")


def rounded_number(value: float, decimals: int, form: str = "g") -> str:
    """A number without what is left over from rounding errors, and 0 without a sign."""
    return number(round(value, decimals) + 0.0, form)  # + 0.0 turns a −0 into a 0


def signed(value: float) -> str:
    """A number with two decimals and its sign; one that rounds to 0 has no sign."""
    text = number(value, "+.2f")
    return text if text.strip("+−0.") else "0.00"


def estimate_told(value: float, low: float, high: float) -> str:
    """An estimate with its 95 % interval, in three decimals: "0.142 [0.120, 0.161]"."""
    ends = (rounded_number(end, 3, ".3f") for end in (value, low, high))
    return "{} [{}, {}]".format(*ends)


def share_told(value: float, low: float, high: float) -> str:
    """A share in percent with its 95 % interval: "12 % [6, 24]", or "0.9 % [0.7, 1.2]"."""
    decimals = 0 if high - low >= 0.02 else 1
    share, *ends = (rounded_number(100.0 * end, decimals, ".15g") for end in (value, low, high))
    return f"{share} % [{ends[0]}, {ends[1]}]"


def alternatives(names: Sequence[str]) -> str:
    """Names of which one holds, it is open which: "forward", "forward or stop", "a, b or c"."""
    *others, last = names
    return f"{', '.join(others)} or {last}" if others else last


def listed(names: Sequence[str]) -> str:
    """Names that all hold: "EU", "EU and T&K", "a, b and c"."""
    *others, last = names
    return f"{', '.join(others)} and {last}" if others else last


def counted(count: int, thing: str) -> str:
    """A count with the thing that is counted: "1 pair", "2 pairs"."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def contacts_told(touched: int, ended: int, count: int) -> str:
    """In how many of `count` outcomes there was contact, in words; nothing before one has ended.

    Of these outcomes, `ended` have ended so far, and `touched` of those had contact.
    """
    if ended == count:
        return f"{touched} of {count} with contact"
    return f"{touched} of {ended} so far" if ended else ""
