"""From what callers hand in to checked float64 tensors."""

import numpy as np
import torch
from numpy.typing import ArrayLike
from torch import Tensor

from learners.errors import InputError

SUM_TOLERANCE = 1e-6
"""How far from 1 probabilities may sum: the rounding of float32, which is then normalised away."""


def finite_tensor(field: str, given: Tensor | ArrayLike) -> Tensor:
    """The given numbers as a float64 tensor, which keeps the gradient of a tensor.

    Raises:
        InputError: if something in it is not a finite number.
    """
    if isinstance(given, Tensor):
        tensor = given.to(torch.float64)
    else:
        try:
            # copied because torch can hold neither read-only nor reversed arrays
            tensor = torch.from_numpy(np.array(given, dtype=np.float64, order="C"))
        except (TypeError, ValueError) as error:
            raise InputError(
                f"{field} of type {type(given).__name__} is not allowed: an array of numbers"
            ) from error
    wrong = tensor.detach()[~torch.isfinite(tensor)]
    if wrong.numel():
        raise InputError(f"{field} contains {wrong[0].item()}: only finite numbers are allowed")
    return tensor


def positive_tensor(field: str, given: Tensor | float) -> Tensor:
    """The given parameter as a float64 tensor.

    Raises:
        InputError: if it is not finite and above 0.
    """
    tensor = finite_tensor(field, given)
    lowest = tensor.detach().min().item()
    if lowest <= 0.0:
        raise InputError(f"{field} {lowest} is not allowed: a finite number above 0")
    return tensor


def outcome_tensor(utilities: Tensor | ArrayLike, reference: Tensor | ArrayLike = 0.0) -> Tensor:
    """Utilities above (gain) or below (loss) a reference, as a float64 tensor [..., K].

    Raises:
        InputError: if there is no outcome, a number is not finite, or the shapes do not fit.
    """
    u = finite_tensor("utilities", utilities)
    if u.ndim == 0 or u.shape[-1] == 0:
        raise InputError(
            f"utilities of shape {list(u.shape)} are not allowed: "
            "the last axis holds one or more outcomes"
        )
    r = finite_tensor("reference", reference)
    shape = _common_shape(u, r)
    if shape is None or shape[-1] != u.shape[-1]:
        raise InputError(
            f"reference of shape {list(r.shape)} is not allowed: "
            f"a shape that broadcasts against utilities {list(u.shape)}"
        )
    return u - r


def probability_tensor(probabilities: Tensor | ArrayLike, outcomes: Tensor) -> Tensor:
    """Probabilities of outcomes [..., K] as a float64 tensor, normalised to sum to 1.

    Raises:
        InputError: if one is negative, they do not sum to 1, or the shapes do not fit.
    """
    p = finite_tensor("probabilities", probabilities)
    fits = p.ndim > 0 and p.shape[-1] == outcomes.shape[-1]
    if not fits or _common_shape(p, outcomes) is None:
        raise InputError(
            f"probabilities of shape {list(p.shape)} are not allowed: a shape that broadcasts "
            f"against utilities {list(outcomes.shape)} and has the same last axis"
        )
    negative = p.detach()[p < 0.0]
    if negative.numel():
        raise InputError(f"probabilities contain {negative[0].item()}: 0 to 1 is allowed")
    total = p.sum(-1, keepdim=True)
    wrong = total.detach()[(total - 1.0).abs() > SUM_TOLERANCE]
    if wrong.numel():
        raise InputError(f"probabilities sum to {wrong[0].item()}: they must sum to 1")
    return p / total


def _common_shape(one: Tensor, other: Tensor) -> tuple[int, ...] | None:
    try:
        return np.broadcast_shapes(one.shape, other.shape)
    except ValueError:
        return None
