import pytest

from learners import Study, find_learners, find_teachers, run_study


@pytest.fixture(scope="session")
def small():
    """The arguments of a small study."""
    return {"teachers": ["eu", "strong"], "learners": ["eu", "cpt"], "sizes": (10, 40), "seeds": 2}


@pytest.fixture(scope="session")
def plan():
    """A function from the arguments of `run_study` to the plan of that study."""

    def plan(prospects, teachers, learners, *rest, **more):
        return Study(prospects, find_teachers(teachers), find_learners(learners), *rest, **more)

    return plan


@pytest.fixture(scope="session")
def study(prospects, plan, small):
    return plan(prospects, **small)


@pytest.fixture(scope="session")
def table(prospects, small):
    return run_study(prospects, **small, workers=1)
