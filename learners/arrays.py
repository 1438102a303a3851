"""From what callers hand in to checked float64 arrays: NumPy's, or tensors where tensors come in.

torch takes long to load, and callers without tensors do not need it. So every formula is written
once, with the functions that NumPy and torch both have, and finds them in the `namespace` of its
arguments. The few functions that differ between the two are here.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeGuard

import numpy as np
from numpy.typing import NDArray

from learners.errors import InputError

if TYPE_CHECKING:
    from torch import Tensor

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]

Numbers: TypeAlias = "float | NDArray[Any] | Sequence[Numbers]"
"""What callers may hand in where NumPy does the work."""

NumbersOrTensor: TypeAlias = "Numbers | Tensor"
"""What callers may hand in where torch does the work as soon as one argument is a tensor.

Numbers are both this and `Numbers`, so the overloads of a function for the one and for the other
overlap. Type checkers are told to allow it: the first overload that fits is that of `Numbers`.
"""

Array: TypeAlias = Any
"""What formulas work on: a `FloatArray` or a float64 `Tensor`; which, is known when they run."""

SUM_TOLERANCE = 1e-6
"""How far from 1 the sum of probabilities may be: float32 rounds, and they are normalised after."""


def is_tensor(given: object) -> TypeGuard[Tensor]:
    """Whether something is a tensor of torch, which is not loaded to find out."""
    return isinstance(given, getattr(sys.modules.get("torch"), "Tensor", ()))


def namespace(*given: object) -> ModuleType:
    """The module whose functions work on what is given: torch if a tensor is there, else NumPy."""
    return sys.modules["torch"] if any(map(is_tensor, given)) else np


def take_along(array: Array, places: Array) -> Array:
    """The entries at these places of the last axis; the array and the places may broadcast."""
    xp = namespace(array)
    shape = np.broadcast_shapes(array.shape, places.shape)
    take = np.take_along_axis if xp is np else xp.take_along_dim
    return take(xp.broadcast_to(array, shape), xp.broadcast_to(places, shape), -1)


def finite_array(field: str, given: NumbersOrTensor, xp: ModuleType) -> Array:
    """The given numbers as a float64 array of a namespace; a tensor keeps its gradient.

    Raises:
        InputError: if something is not a finite number.
    """
    if is_tensor(given):
        array: Array = given.to(xp.float64)
    else:
        try:
            array = np.asarray(given, dtype=np.float64)
        except (TypeError, ValueError) as error:
            raise InputError(
                f"{field} of type {type(given).__name__} is not allowed: an array of numbers"
            ) from error
        if xp is not np:
            # copied because torch can hold neither read-only nor reversed arrays
            array = xp.from_numpy(array.copy(order="C"))
    wrong = array[~xp.isfinite(array)]
    if len(wrong):
        raise InputError(f"{field} contains {wrong[0].item()}: only finite numbers are allowed")
    return array


def positive_array(field: str, given: NumbersOrTensor, xp: ModuleType) -> Array:
    """Like `finite_array`; raises `InputError` also if a number is not above 0."""
    array = finite_array(field, given, xp)
    lowest = array.min().item()
    if lowest <= 0.0:
        raise InputError(f"{field} {lowest} is not allowed: a finite number above 0")
    return array


def outcome_array(
    utilities: NumbersOrTensor, xp: ModuleType, reference: NumbersOrTensor = 0.0
) -> Array:
    """Utilities minus a reference, as a float64 array [..., K] of a namespace.

    A positive outcome is a gain, a negative one a loss.

    Raises:
        InputError: if there is no outcome, a number is not finite, or the shapes do not fit.
    """
    u = finite_array("utilities", utilities, xp)
    if u.ndim == 0 or u.shape[-1] == 0:
        raise InputError(
            f"utilities of shape {list(u.shape)} are not allowed: "
            "the last axis holds one or more outcomes"
        )
    r = finite_array("reference", reference, xp)
    shape = _common_shape(u, r)
    if shape is None or shape[-1] != u.shape[-1]:
        raise InputError(
            f"reference of shape {list(r.shape)} is not allowed: "
            f"a shape that broadcasts against utilities {list(u.shape)}"
        )
    return u - r


def probability_array(probabilities: NumbersOrTensor, outcomes: Array) -> Array:
    """Probabilities of outcomes [..., K] as an array of the same kind, normalised to sum to 1.

    Raises:
        InputError: if one is negative, they do not sum to 1, or the shapes do not fit.
    """
    p = finite_array("probabilities", probabilities, namespace(outcomes))
    fits = p.ndim > 0 and p.shape[-1] == outcomes.shape[-1]
    if not fits or _common_shape(p, outcomes) is None:
        raise InputError(
            f"probabilities of shape {list(p.shape)} are not allowed: a shape that broadcasts "
            f"against utilities {list(outcomes.shape)} and has the same last axis"
        )
    negative = p[p < 0.0]
    if len(negative):
        raise InputError(f"probabilities contain {negative[0].item()}: 0 to 1 is allowed")
    total = p.sum(-1, keepdims=True)
    wrong = total[abs(total - 1.0) > SUM_TOLERANCE]
    if len(wrong):
        raise InputError(f"probabilities sum to {wrong[0].item()}: they must sum to 1")
    return p / total


def _common_shape(one: Array, other: Array) -> tuple[int, ...] | None:
    try:
        return np.broadcast_shapes(one.shape, other.shape)
    except ValueError:
        return None
