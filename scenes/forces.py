"""The social force model, one function for each formula.

Two force sets, as in pysocialforce 1.1.2, whose parameters these are:

`extended`, after Moussaïd et al., "Experimental study of the behavioural mechanisms underlying
self-organization in human crowds" (Proc. R. Soc. B, 2009) and "The walking behaviour of pedestrian
social groups" (PLoS ONE, 2010); and `helbing-molnar`, after Helbing and Molnár, "Social force model
for pedestrian dynamics" (Phys. Rev. E 51, 1995).

A force is an acceleration in m/s². Every formula takes and returns plain numbers and has only
branches that the compiler can turn into selections, because the engine calls it in a loop over
lanes.
"""

import math
from typing import NamedTuple

from scenes.lanes import angle_of, exp_of_negative, lane

Vector = tuple[float, float]


class Extended(NamedTuple):
    """Parameters of the `extended` force set.

    pysocialforce has one more, a distance to the goal within which people brake. It is less than
    `ARRIVAL_DISTANCE`, so whoever is as near as that stands already.
    """

    relaxation_time: float = 0.5  # in which a person takes up the desired velocity, s
    social_factor: float = 5.1  # strength of the force between people, m/s²
    velocity_weight: float = 2.0  # λ, how much relative velocity turns the interaction, s/m
    range_per_interaction: float = 0.35  # γ, range per length of the interaction vector, m
    angular_width: float = 3.0  # n', decay with angle of the part that brakes, 1/(m rad)
    angular_width_turn: float = 2.0  # n, decay with angle of the part that turns, 1/(m rad)
    wall_factor: float = 10.0  # strength of a wall point, m/s²
    wall_range: float = 0.2  # σ, decay of the wall force, m
    wall_threshold: float = 3.0  # a wall is felt up to a gap of this plus the body radius, m
    body_radius: float = 0.35  # at which a person meets a wall, m
    coherence_factor: float = 1.0  # strength of the pull to the group's centre, 1/s²
    repulsion_factor: float = 1.0  # strength of the push between members too close, 1/s²
    repulsion_threshold: float = 0.55  # within which members push one another, m
    gaze_factor: float = 1.0  # strength of the force that keeps the group in view, m/s²


class HelbingMolnar(NamedTuple):
    """Parameters of the `helbing-molnar` force set."""

    relaxation_time: float = 0.5  # τ, in which a person takes up the desired velocity, s
    pair_factor: float = 1.5  # strength of the force between people, dimensionless
    pair_potential: float = 2.1  # V⁰, height of the potential around a person, m²/s²
    pair_range: float = 0.3  # σ, decay of that potential, m
    sight_angle: float = math.radians(100.0)  # φ, half the angle of sight, rad
    out_of_sight: float = 0.5  # c, weight of forces from behind a person, dimensionless
    wall_potential: float = 10.0  # U⁰, height of the potential of a wall, m²/s²
    wall_range: float = 0.2  # R, decay of that potential, m


EXTENDED = Extended()
HELBING_MOLNAR = HelbingMolnar()

MAX_SPEED_FACTOR = 1.3
"""Greatest speed in units of the desired speed (Helbing and Molnár 1995, section III)."""

ARRIVAL_DISTANCE = 0.5
"""Distance to the goal within which a person has arrived and stands, m."""

SMALLEST_ANGLE = 1e-9
"""Angles below this count as 0, rad.

The turning force jumps with the sign of an angle. In a perfectly symmetric meeting that angle is
rounding error, and the last bit of a coordinate would choose the side on which people pass.
"""

DIFFERENCE_STEP = 1e-3
"""Step of pysocialforce's one-sided difference quotients, m."""


@lane
def unit(x: float, y: float) -> tuple[float, float, float]:
    """Direction and length of a vector; the zero vector has the zero direction."""
    length = math.sqrt(x * x + y * y)
    inverse = 1.0 / (length if length > 0.0 else 1.0)
    return x * inverse, y * inverse, length


@lane
def drive_to_goal(
    ex: float, ey: float, speed: float, vx: float, vy: float, relaxation_time: float
) -> Vector:
    """Pull towards the desired velocity, (ex, ey) being the direction to the goal.

    This is the driving term of Moussaïd et al. 2009, and of Helbing and Molnár 1995, eq. 2.
    """
    return (speed * ex - vx) / relaxation_time, (speed * ey - vy) / relaxation_time


@lane
def _turn_and_brake(
    tx: float, ty: float, angle: float, distance: float, reach: float, p: Extended
) -> Vector:
    """The two parts of the social force, along t and to its left.

    f_v = exp(-d/B - (n'Bθ)²) and f_θ = -sign(θ) exp(-d/B - (nBθ)²), Moussaïd et al. 2009.
    `reach` is B = γ‖D‖, m.
    """
    decay = distance / (reach if reach > 0.0 else 1e-30)
    brake_width = p.angular_width * reach * angle
    turn_width = p.angular_width_turn * reach * angle
    brake = exp_of_negative(-decay - brake_width * brake_width)
    turn = exp_of_negative(-decay - turn_width * turn_width)
    turn = -turn if angle > 0.0 else turn
    turn = 0.0 if angle == 0.0 else turn
    return brake * tx - turn * ty, brake * ty + turn * tx


@lane
def social(rx: float, ry: float, wx: float, wy: float, p: Extended) -> Vector:
    """Force from one other person (Moussaïd et al. 2009, the interaction law).

    It acts along the interaction vector D = λ(v_i - v_j) + e_ij, where e_ij points to the other
    person; like pysocialforce, the code computes -D. (rx, ry) is the own position minus the
    other's, and (wx, wy) the other's velocity minus the own. The angle from the line between the
    two to D comes from one cross and dot product, so it is the same whichever way the axes point.
    """
    ux, uy, distance = unit(rx, ry)
    tx, ty, length = unit(p.velocity_weight * wx + ux, p.velocity_weight * wy + uy)
    angle = angle_of(ux * ty - uy * tx, ux * tx + uy * ty)
    angle = angle if abs(angle) > SMALLEST_ANGLE else 0.0
    return _turn_and_brake(tx, ty, angle, distance, p.range_per_interaction * length, p)


@lane
def social_as_in_library(rx: float, ry: float, wx: float, wy: float, p: Extended) -> Vector:
    """`social` with pysocialforce's angle, a difference of two angles that is not wrapped.

    For two people in line along -x the difference jumps by 2π, and the force almost vanishes.
    """
    ux, uy, distance = unit(rx, ry)
    tx, ty, length = unit(p.velocity_weight * wx + ux, p.velocity_weight * wy + uy)
    angle = angle_of(ty, tx) - angle_of(uy, ux)
    return _turn_and_brake(tx, ty, angle, distance, p.range_per_interaction * length, p)


@lane
def wall_point(rx: float, ry: float, p: Extended) -> Vector:
    """Push of one point of a wall; (rx, ry) points from it to the person.

    It decays exponentially, like the walls of Moussaïd et al. 2009. The caller sums over the points
    of a wall, as pysocialforce does, and multiplies by exp(body radius/σ), which turns the decay
    with the distance into a decay with the gap.
    """
    ux, uy, distance = unit(rx, ry)
    gap = distance - p.body_radius
    felt = gap < p.wall_threshold + p.body_radius
    push = exp_of_negative(distance * -(1.0 / p.wall_range)) if felt else 0.0
    return push * ux, push * uy


@lane
def coherence(cx: float, cy: float, size: float) -> Vector:
    """Pull to the group's centre of mass, (cx, cy) away (Moussaïd et al. 2010, attraction).

    A hyperbolic tangent around the distance (size - 1)/2 softens it, as in pedsim_ros.
    """
    distance = math.sqrt(cx * cx + cy * cy)
    # (tanh(z) + 1)/2 = 1/(1 + exp(-2z)), written for an exponent that is never positive.
    z = 2.0 * (distance - (size - 1.0) / 2.0)
    e = exp_of_negative(-abs(z))
    soft = (1.0 if z > 0.0 else e) / (1.0 + e)
    return soft * cx, soft * cy


@lane
def coherence_as_in_library(cx: float, cy: float, size: float) -> Vector:
    """`coherence` softened as in pysocialforce, which takes every distance for 0 here."""
    e = math.exp(-(size - 1.0))
    soft = e / (1.0 + e)
    return soft * cx, soft * cy


@lane
def repulsion(rx: float, ry: float, p: Extended) -> Vector:
    """Push from a member who is too close; (rx, ry) is the own position minus the member's."""
    close = math.sqrt(rx * rx + ry * ry) <= p.repulsion_threshold
    return (rx if close else 0.0), (ry if close else 0.0)


@lane
def gaze(ex: float, ey: float, goal_distance: float, cx: float, cy: float) -> Vector:
    """Keep the others, whose centre is (cx, cy) away, in view.

    This slows a person who is ahead of the others and speeds up one who is behind (Moussaïd et al.
    2010, vision, in the form of pedsim_ros).
    """
    ahead = ex * cx + ey * cy
    pull = ahead / (goal_distance if goal_distance > 0.0 else 1e30)
    return pull * ex, pull * ey


@lane
def _semi_minor_axis(rx: float, ry: float, sx: float, sy: float) -> float:
    """Semi-minor axis b of the ellipse around another's next step s, m.

    2b = √((‖r‖ + ‖r - s‖)² - ‖s‖²) (Helbing and Molnár 1995, eq. 4).
    """
    qx, qy = rx - sx, ry - sy
    around = math.sqrt(rx * rx + ry * ry) + math.sqrt(qx * qx + qy * qy)
    square = around * around - (sx * sx + sy * sy)
    return 0.5 * math.sqrt(square if square > 0.0 else 0.0)


@lane
def pair(rx: float, ry: float, sx: float, sy: float, p: HelbingMolnar) -> Vector:
    """Negative gradient of the potential around another person (Helbing and Molnár 1995, eq. 3).

    (rx, ry) is the own position minus the other's, and (sx, sy) the other's next step Δt v e.
    """
    ux, uy, near = unit(rx, ry)
    wx, wy, far = unit(rx - sx, ry - sy)
    b = _semi_minor_axis(rx, ry, sx, sy)
    strength = p.pair_potential / p.pair_range * exp_of_negative(-b / p.pair_range)
    # ∇b = (‖r‖ + ‖r - s‖)/(4b) (r/‖r‖ + (r - s)/‖r - s‖); on the step itself b = 0 and the two
    # directions cancel, so the floor only prevents 0/0.
    slope = strength * (near + far) / (4.0 * (b if b > 1e-9 else 1e-9))
    return slope * (ux + wx), slope * (uy + wy)


@lane
def pair_as_in_library(rx: float, ry: float, sx: float, sy: float, p: HelbingMolnar) -> Vector:
    """`pair` with pysocialforce's gradient, which it takes by one-sided differences."""
    here = exp_of_negative(-_semi_minor_axis(rx, ry, sx, sy) / p.pair_range)
    right = exp_of_negative(-_semi_minor_axis(rx + DIFFERENCE_STEP, ry, sx, sy) / p.pair_range)
    above = exp_of_negative(-_semi_minor_axis(rx, ry + DIFFERENCE_STEP, sx, sy) / p.pair_range)
    strength = -p.pair_potential / DIFFERENCE_STEP
    return strength * (right - here), strength * (above - here)


@lane
def in_sight(ex: float, ey: float, fx: float, fy: float, p: HelbingMolnar) -> Vector:
    """The force (fx, fy) as it is felt, weaker from behind (Helbing and Molnár 1995, eq. 7)."""
    along = -(ex * fx + ey * fy)
    seen = along > math.sqrt(fx * fx + fy * fy) * math.cos(p.sight_angle)
    weight = 1.0 if seen else p.out_of_sight
    return weight * fx, weight * fy


@lane
def wall_gradient(rx: float, ry: float, p: HelbingMolnar) -> Vector:
    """Negative gradient of a wall's potential (Helbing and Molnár 1995, eq. 5).

    (rx, ry) points from the wall's nearest point to the person.
    """
    ux, uy, distance = unit(rx, ry)
    push = p.wall_potential / p.wall_range * exp_of_negative(-distance / p.wall_range)
    return push * ux, push * uy


@lane
def wall_gradient_as_in_library(rx: float, ry: float, p: HelbingMolnar) -> Vector:
    """`wall_gradient` with pysocialforce's gradient, which it takes by one-sided differences."""
    _, _, distance = unit(rx, ry)
    _, _, right = unit(rx + DIFFERENCE_STEP, ry)
    _, _, above = unit(rx, ry + DIFFERENCE_STEP)
    here = exp_of_negative(-distance / p.wall_range)
    strength = -p.wall_potential / DIFFERENCE_STEP
    return (
        strength * (exp_of_negative(-right / p.wall_range) - here),
        strength * (exp_of_negative(-above / p.wall_range) - here),
    )
