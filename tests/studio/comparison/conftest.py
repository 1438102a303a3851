import pytest

from tests.studio.comparison.made_up import CASES, a_comparison


@pytest.fixture(scope="module", params=CASES)
def unusual(request):
    return a_comparison(**CASES[request.param])


@pytest.fixture(scope="module")
def comparison():
    return a_comparison(contact=((True, False, True, False, False), (False,) * 5))
