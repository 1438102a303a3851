import pytest

from learners import CptParameters, Teacher
from studio.errors import InputError
from studio.study.teachers import read_teachers


def test_profiles_are_read_in_the_order_of_the_letters() -> None:
    [mine] = read_teachers((), ("mine=0.9,0.8,4,0.6,0.7",), beta=None)
    assert mine == Teacher("mine", CptParameters(0.9, 0.8, 4.0, 0.6, 0.7))
    assert all(teacher.beta == 5.0 for teacher in read_teachers(("eu", "tk"), (), beta=5.0))
    with pytest.raises(InputError, match=r"--profile: 'mine=1,2' is not a profile: NAME="):
        read_teachers((), ("mine=1,2",), beta=None)
