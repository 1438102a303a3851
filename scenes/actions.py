"""The robot commands that a person chooses between."""

import math
from dataclasses import dataclass

from scenes.errors import InputError


@dataclass(frozen=True)
class MetaAction:
    """One robot command, held over the whole horizon.

    Attributes:
        speed: commanded forward speed v in m/s.
        turn_rate: commanded turn rate ω in rad/s, positive to the left.

    Raises:
        InputError: if there is no name, the speed or turn rate is not finite, or the robot would
            drive backwards.
    """

    name: str
    speed: float
    turn_rate: float

    def __post_init__(self) -> None:
        if not self.name.strip():
            raise InputError(f"action {self.name!r}: a name is needed")
        if not (math.isfinite(self.speed) and 0.0 <= self.speed <= 3.0):
            raise InputError(
                f"action {self.name!r}: speed {self.speed!r} m/s is not allowed: 0 to 3 m/s"
            )
        if not (math.isfinite(self.turn_rate) and abs(self.turn_rate) <= 3.0):
            raise InputError(
                f"action {self.name!r}: turn rate {self.turn_rate!r} rad/s is not allowed: "
                "-3 to 3 rad/s"
            )


META_ACTIONS: tuple[MetaAction, ...] = (
    MetaAction("forward", 1.0, 0.0),
    MetaAction("slow_down", 0.5, 0.0),
    MetaAction("stop", 0.0, 0.0),
    MetaAction("turn_left", 0.4, 0.5),
    MetaAction("turn_right", 0.4, -0.5),
    MetaAction("forward_left", 0.9, 0.25),
    MetaAction("forward_right", 0.9, -0.25),
)
"""The seven commands that are tried unless others are given."""
