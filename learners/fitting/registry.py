"""The learners that can be asked for by name."""

from collections.abc import Iterable

from learners.fitting.cpt import CptLearner
from learners.fitting.eu import EuLearner
from learners.fitting.fits import Learner
from learners.names import find

LEARNERS: dict[str, Learner] = {
    learner.name: learner
    for learner in (
        EuLearner(),
        CptLearner(),
        CptLearner(tied=True),
        CptLearner(learns_reference=True),
        CptLearner(tied=True, learns_reference=True),
    )
}


def find_learners(names: Iterable[Learner | str]) -> tuple[Learner, ...]:
    """The learners of these names, see `find`."""
    return find("learner", names, LEARNERS)
