"""What makes one person's judgement of risk differ from another's."""

import math
from dataclasses import asdict, astuple, dataclass
from numbers import Real
from typing import ClassVar, Protocol, TypeVar

from learners.errors import InputError

Parameter = TypeVar("Parameter", covariant=True)


class CptLike(Protocol[Parameter]):
    """Anything that bears the five parameters of cumulative prospect theory.

    The value functions ask for no more than this. `CptParameters` is one such thing; in others the
    parameters may be arrays, or tensors to differentiate with respect to. Each is a single number,
    or a batch whose last axis is 1 and that broadcasts against [..., K].
    """

    @property
    def alpha(self) -> Parameter:
        """Exponent of gains, α."""

    @property
    def eta(self) -> Parameter:
        """Exponent of losses, η."""

    @property
    def loss_aversion(self) -> Parameter:
        """How much heavier a loss weighs than a gain, λ."""

    @property
    def gamma(self) -> Parameter:
        """Curvature of the weighting of gains' probabilities, γ."""

    @property
    def delta(self) -> Parameter:
        """Curvature of the weighting of losses' probabilities, δ."""


@dataclass(frozen=True)
class CptParameters:
    """The five parameters of cumulative prospect theory, all without unit, all above 0.

    All ones is expected utility.

    Attributes:
        alpha: exponent α of gains; below 1, twice the gain is less than twice as good.
        eta: exponent η of losses; below 1, twice the loss is less than twice as bad.
        loss_aversion: λ, how many times heavier a loss weighs than a gain of the same size.
        gamma: curvature γ of the probability weighting of gains; below 1, rare gains are
            overweighted.
        delta: the same of losses, δ.

    Raises:
        InputError: if a parameter is not a finite number above 0.
    """

    alpha: float
    eta: float
    loss_aversion: float
    gamma: float
    delta: float

    SYMBOLS: ClassVar[tuple[str, ...]] = ("α", "η", "λ", "γ", "δ")
    """What the parameters are called in formulas, in the order of the fields."""

    @property
    def numbers(self) -> tuple[float, ...]:
        """α, η, λ, γ, δ, in the order of `SYMBOLS`."""
        return astuple(self)

    def __post_init__(self) -> None:
        for name, given in asdict(self).items():
            if not (isinstance(given, Real) and math.isfinite(given) and float(given) > 0.0):
                raise InputError(f"{name} {given!r} is not allowed: a finite number above 0")


PROFILES: dict[str, CptParameters] = {
    "eu": CptParameters(alpha=1.0, eta=1.0, loss_aversion=1.0, gamma=1.0, delta=1.0),
    "tk": CptParameters(alpha=0.88, eta=0.88, loss_aversion=2.25, gamma=0.61, delta=0.69),
    "strong": CptParameters(alpha=0.80, eta=0.80, loss_aversion=3.00, gamma=0.50, delta=0.50),
}
"""The three teachers: expected utility; the median person of Tversky and Kahneman, "Advances in
Prospect Theory", J. Risk and Uncertainty 5 (1992), section 2; and a more extreme person."""

REWARD = (0.10, -0.20, 0.30, 0.05, -0.25)
"""The true reward θ*: what clearance, deviation, progress, smoothness and collisions are worth."""
