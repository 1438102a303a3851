"""The scene in motion, as a film shows it: ghosts, trails, and one rollout in full."""

import math
from dataclasses import dataclass
from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from scenes import Rollouts
from scenes.features import gaps
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import FloatArray, PixelArray
from studio.painter.canvas import Canvas
from studio.painter.labels import Label, draw_labels
from studio.painter.lettering import SEMIBOLD
from studio.painter.paths import FaintPaths
from studio.painter.pixels import disc_coverage, tinted
from studio.painter.views import View
from studio.scene.measures import poses_at, touched_by
from studio.scene.picture.scenery import (
    draw_contacts,
    draw_groups,
    draw_people,
    draw_robot,
    draw_wall_contacts,
    overlap_opacity,
)
from studio.style.palette import Colour

_TOLD_IN_FULL = 0  # the rollout that is drawn in full


def between(values: FloatArray, step: float) -> FloatArray:
    """Values [K, T+1, ...] between two steps, on a straight line from one to the other."""
    before = min(int(step), values.shape[1] - 2)
    share = min(step - before, 1.0)
    between_them: FloatArray = (1.0 - share) * values[:, before] + share * values[:, before + 1]
    return between_them


class MovingScene:
    """The scene in motion: all rollouts of one action as ghosts with trails, one in full."""

    def __init__(self, canvas: Canvas, view: View, rollouts: Rollouts, index: int) -> None:
        self._canvas, self._view, self._scene = canvas, view, rollouts.scene
        self._colour = canvas.theme.action_colour(rollouts.names[index])
        self._poses = rollouts.robot[index]  # (K, T+1, 3), m and rad
        self._people = rollouts.pedestrians[index]  # (K, T+1, P, 2), m
        self._contact_step = rollouts.contact_step[index]
        self._contacts = [
            (steps[steps >= 0], poses_at(rollouts, index, steps), draw)
            for steps, draw in (
                (rollouts.wall_step[index], draw_wall_contacts),
                (rollouts.person_step[index], draw_contacts),
            )
        ]
        opacity = overlap_opacity(len(self._poses))
        self._corner = np.array([canvas.box.left, canvas.box.top])
        shape = canvas.pixels.shape[:2]
        self._trails = Trails(canvas, view.to_pixels(self._poses), self._colour, opacity)
        person, robot = PEDESTRIAN_RADIUS * view.scale, ROBOT_RADIUS * view.scale
        self._ghost_people = Ghosts(shape, person, 0.5 * opacity)
        self._ghost_robots = Ghosts(shape, robot, opacity)
        self._ghosts_in_contact = Ghosts(shape, robot, min(2.5 * opacity, 0.8))

    def draw(self, step: float) -> None:
        """Draw everybody where they are at a step, which must not go back."""
        canvas, view = self._canvas, self._view
        poses, people = between(self._poses, step), between(self._people, step)
        places = view.to_pixels(poses) - self._corner
        canvas.pixels[:] = self._trails.drawn_to(step)
        ghosts = np.arange(len(poses)) != _TOLD_IN_FULL
        touched = touched_by(self._contact_step, step)
        crowd = view.to_pixels(people[ghosts]).reshape(-1, 2) - self._corner
        self._ghost_people.draw(canvas.pixels, crowd, canvas.theme.pedestrian)
        self._ghost_robots.draw(canvas.pixels, places[ghosts & ~touched], self._colour)
        self._ghosts_in_contact.draw(canvas.pixels, places[ghosts & touched], canvas.theme.contact)
        draw_groups(canvas, view, self._scene, people[_TOLD_IN_FULL])
        draw_people(canvas, view, people[_TOLD_IN_FULL])
        colour = canvas.theme.contact if touched[_TOLD_IN_FULL] else self._colour
        draw_robot(canvas, view, poses[_TOLD_IN_FULL], colour)
        for steps, places_touched, draw in self._contacts:
            draw(canvas, view, places_touched[steps <= step], 5.5)

    def draw_first_contact(self, contact: "FirstContact") -> None:
        """Ring the place of the first contact of all rollouts, and say what was touched."""
        canvas, theme, size = self._canvas, self._canvas.theme, self._canvas.type.heading
        draw_people(canvas, self._view, contact.people)
        x, y = self._view.to_pixels(contact.place).tolist()
        angles = np.linspace(0.0, math.tau, 49)
        around = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        radius = max(ROBOT_RADIUS * self._view.scale, 6 * canvas.unit) + 6 * canvas.unit
        for colour, width in ((theme.ground, 7), (theme.contact, 3)):
            canvas.line((x, y) + radius * around, colour, width * canvas.unit)
        told = f"first contact: a {contact.thing}, {contact.time:.1f} s"
        label = Label(
            told, size, SEMIBOLD, theme.contact, (x, y), radius + 4 * canvas.unit, (0, -1)
        )
        draw_labels(canvas, [label], self._view.box.inset(4 * canvas.unit), theme.panel)


@dataclass(frozen=True)
class FirstContact:
    """The first moment of an action at which any robot touches anything."""

    time: float  # s
    thing: str  # person or wall
    place: FloatArray  # of the robot, [2], m
    people: FloatArray  # whom it touches, [N, 2], m

    @classmethod
    def of(cls, rollouts: Rollouts, index: int) -> "FirstContact | None":
        """The one under an action; None if nothing is touched."""
        steps = rollouts.contact_step[index]
        [touching] = np.nonzero(rollouts.touched[index])
        if not len(touching):
            return None
        first = int(touching[steps[touching].argmin()])
        step = int(steps[first])
        is_person = rollouts.person_step[index, first] == step
        pose, people = rollouts.robot[index, first, step], rollouts.pedestrians[index, first, step]
        touched = people[gaps(pose, people) < 0.0]
        return cls(step * rollouts.dt, "person" if is_person else "wall", pose[:2], touched)


class Ghosts:
    """Many equal translucent discs, drawn fast: stamped into a plane of counts, blended once."""

    _FINE = 4  # stamps a pixel, in each direction

    def __init__(self, shape: tuple[int, ...], radius: float, opacity: float) -> None:
        radius = max(radius, 1.5)
        self._reach = math.ceil(radius) + 1
        side = 2 * self._reach + 1
        # a byte counts how many discs lie on a pixel, up to as many as can be told apart; what room
        # it has left makes parts of a disc, which give it a soft rim
        darkest = int(math.log(0.01) / math.log1p(-opacity)) + 1
        levels = max(1, 255 // darkest)
        shifts = np.arange(self._FINE) / self._FINE
        self._stamps = [
            [
                np.rint(
                    levels * disc_coverage(self._reach + x, self._reach + y, radius, side, side)
                ).astype(np.uint8)
                for x in shifts
            ]
            for y in shifts
        ]
        self._plane = np.zeros((shape[0] + 2 * side, shape[1] + 2 * side), np.uint8)
        counts = np.arange(256) / levels
        self._shares = (1.0 - (1.0 - opacity) ** counts).astype(np.float32)

    def draw(self, pixels: PixelArray, centres: FloatArray, colour: Colour) -> None:
        """Draw discs around centres [N, 2], px from the corner of the pixels."""
        reach, side = self._reach, 2 * self._reach + 1
        height, width = pixels.shape[:2]
        inside = ((centres > -reach) & (centres < (width + reach, height + reach))).all(axis=-1)
        if not inside.any():
            return
        fine = np.floor((centres[inside] + side) * self._FINE).astype(np.int64)
        corners, shifts = fine // self._FINE - reach, fine % self._FINE
        (left, top), (right, bottom) = corners.min(axis=0), corners.max(axis=0) + side
        self._plane[top:bottom, left:right] = 0
        for (x, y), (shift_x, shift_y) in zip(corners.tolist(), shifts.tolist(), strict=True):
            part = self._plane[y : y + side, x : x + side]
            cv2.add(part, self._stamps[shift_y][shift_x], dst=part)
        left, top = max(left, side), max(top, side)
        right, bottom = min(right, side + width), min(bottom, side + height)
        if left >= right or top >= bottom:
            return
        under = pixels[top - side : bottom - side, left - side : right - side]
        plane = self._plane[top:bottom, left:right]
        shares = cast(NDArray[np.float32], cv2.LUT(plane, self._shares))
        under[:] = tinted(under, colour, shares)


class Trails:
    """Faint paths that grow with time."""

    def __init__(self, canvas: Canvas, paths: FloatArray, colour: Colour, opacity: float) -> None:
        """Take the whole paths [K, T+1, 2], px of the page."""
        self._ground, self._layer = canvas.pixels.copy(), canvas.pixels.copy()
        self._paths, self._step = paths, 0.0
        self._faint = FaintPaths(canvas, colour, 2 * canvas.unit, opacity)
        self._traces = self._faint.traces(paths)

    def drawn_to(self, step: float) -> PixelArray:
        """The ground with the paths up to a step, which must not go back."""
        if step > self._step:
            passed = range(math.floor(self._step) + 1, math.ceil(step))
            points = np.stack(
                [
                    between(self._paths, self._step),
                    *(self._paths[:, index] for index in passed),
                    between(self._paths, step),
                ],
                axis=1,
            )  # (K, points, 2)
            self._step = step
            part = self._faint.add(points, self._traces)
            self._layer[part] = self._faint.over(self._ground, part)
        return self._layer
