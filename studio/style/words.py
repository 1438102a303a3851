"""What people call things, in figures and in text."""

LONGEST_NAME = 22
"""Longer names of actions are cut in figures, in characters."""

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


def short(name: str) -> str:
    """A name that fits into a figure."""
    return name if len(name) <= LONGEST_NAME else f"{name[: LONGEST_NAME - 1]}…"


def action_label(name: str) -> str:
    """What people read for the name of an action: `slow_down` is written "slow down"."""
    return name.replace("_", " ")


def number(value: float, form: str = "g") -> str:
    """A number with the minus sign that people write."""
    return format(value, form).replace("-", "−")


def counted(count: int, thing: str) -> str:
    """So many of a thing."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"
