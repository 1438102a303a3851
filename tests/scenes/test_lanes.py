"""The arithmetic of the lanes against numpy."""

import numpy as np
from numba import njit

from scenes.lanes import angle_of, exp_of_negative


@njit  # type: ignore[untyped-decorator]
def _exp(x):  # type: ignore[no-untyped-def]
    return exp_of_negative(x)


@njit  # type: ignore[untyped-decorator]
def _angle(y, x):  # type: ignore[no-untyped-def]
    return angle_of(y, x)


def test_exp_agrees_with_numpy() -> None:
    x = -np.concatenate([np.linspace(0, 1, 1001), np.logspace(-12, np.log10(699), 2000)])
    np.testing.assert_allclose([_exp(value) for value in x], np.exp(x), rtol=1e-15)


def test_exp_of_what_nobody_feels_is_zero() -> None:
    assert _exp(-701.0) == 0.0
    assert _exp(-1e300) == 0.0
    assert _exp(-np.inf) == 0.0


def test_exp_of_zero_is_exactly_one() -> None:
    assert _exp(0.0) == 1.0
    assert _exp(-0.0) == 1.0


def test_angle_agrees_with_numpy_all_around() -> None:
    around = np.linspace(-np.pi, np.pi, 4001)
    for radius in (1e-150, 1e-3, 1.0, 1e9):
        y, x = radius * np.sin(around), radius * np.cos(around)
        np.testing.assert_allclose(
            [_angle(a, b) for a, b in zip(y, x, strict=True)], np.arctan2(y, x), atol=1e-15
        )


def test_angle_on_the_axes_is_exact() -> None:
    for y, x in [(0.0, 1.0), (0.0, -1.0), (-0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 0.0)]:
        assert _angle(y, x) == np.arctan2(y, x)
        assert np.signbit(_angle(y, x)) == np.signbit(np.arctan2(y, x))
