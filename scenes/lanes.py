"""Arithmetic that a compiler can run in lanes.

The engine keeps the rollouts of a scene side by side, one in each lane of a vector register. That
works only if every operation is plain arithmetic: a single call of the C library's `exp` or `atan2`
makes the compiler fall back to one rollout at a time. So both functions are written here as
polynomials without branches, accurate to about 1e-15 (relative for exp, absolute for the angle).
"""

import math
from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np
from numba import njit

Formula = TypeVar("Formula", bound=Callable[..., Any])


def lane(function: Formula) -> Formula:
    """Compile a formula so that it becomes part of the loop over lanes that calls it.

    It is inlined whatever its size, because a call inside the loop keeps the loop from being
    vectorised. Under numpy's error model a division by zero gives inf; raising an error instead
    would be a branch.
    """
    return cast(Formula, njit(error_model="numpy", inline="always")(function))


_LOWEST = -700.0
_LOG2_E = math.log2(math.e)
_LN2_HIGH = float.fromhex("0x1.62e42fee00000p-1")
_LN2_LOW = float.fromhex("0x1.a39ef35793c76p-33")
_TO_INTEGER = 1.5 * 2.0**52  # adding it rounds to an integer in the low bits
_EXPONENT_BITS = np.int64(52)
_EXPONENT_BIAS = np.int64(1023)
_E2, _E3, _E4, _E5, _E6, _E7, _E8, _E9, _E10, _E11, _E12 = (
    1.0 / math.factorial(n) for n in range(2, 13)
)


@lane
def exp_of_negative(x: float) -> float:
    """exp(x) for x ≤ 0; exactly 0 below -700, where no force is felt.

    exp(x) = 2^k exp(r) with r = x - k ln 2 and |r| ≤ ln(2)/2: exp(r) is a Taylor polynomial, and k
    is added to the exponent bits.
    """
    felt = x > _LOWEST
    y = x if felt else 0.0
    shifted = y * _LOG2_E + _TO_INTEGER
    k = shifted - _TO_INTEGER
    r = (y - k * _LN2_HIGH) - k * _LN2_LOW
    p = _E8 + r * (_E9 + r * (_E10 + r * (_E11 + r * _E12)))
    p = _E3 + r * (_E4 + r * (_E5 + r * (_E6 + r * (_E7 + r * p))))
    p = 1.0 + r * (1.0 + r * (_E2 + r * p))
    bits = (np.float64(shifted).view(np.int64) + _EXPONENT_BIAS) << _EXPONENT_BITS
    return p * np.int64(bits).view(np.float64) if felt else 0.0


_TAN_EIGHTH = math.tan(math.pi / 8)


def _arctangent_polynomial() -> list[float]:
    """Eleven coefficients of atan(t)/t as a polynomial in t² on |t| ≤ tan(π/8), Chebyshev's fit."""

    def ratio(square: np.ndarray[Any, np.dtype[np.float64]]) -> Any:
        t = np.sqrt(np.maximum(square, 1e-300))
        return np.arctan(t) / t

    fit = np.polynomial.Chebyshev.interpolate(ratio, 10, domain=[0.0, _TAN_EIGHTH**2])
    return list(map(float, fit.convert(kind=np.polynomial.Polynomial).coef))


_A0, _A1, _A2, _A3, _A4, _A5, _A6, _A7, _A8, _A9, _A10 = _arctangent_polynomial()


@lane
def angle_of(y: float, x: float) -> float:
    """atan2(y, x) in [-π, π]; 0 for the zero vector.

    The ratio of the smaller to the larger component is folded once more at tan(π/8). That leaves
    |t| ≤ tan(π/8), where a polynomial of eleven terms suffices; then the folds are undone.
    """
    across, along = abs(y), abs(x)
    steep = across > along
    larger = across if steep else along
    smaller = along if steep else across
    ratio = smaller / (larger if larger > 0.0 else 1.0)
    beyond = ratio > _TAN_EIGHTH
    t = (ratio - 1.0) / (ratio + 1.0) if beyond else ratio
    s = t * t
    p = _A6 + s * (_A7 + s * (_A8 + s * (_A9 + s * _A10)))
    p = _A1 + s * (_A2 + s * (_A3 + s * (_A4 + s * (_A5 + s * p))))
    angle = t * (_A0 + s * p)
    angle = angle + math.pi / 4 if beyond else angle
    angle = math.pi / 2 - angle if steep else angle
    angle = math.pi - angle if x < 0.0 else angle
    return math.copysign(angle, y)
