"""The scene in motion, as a film shows it: ghosts, trails, and one rollout in full."""

import math
from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import FloatArray, PixelArray
from studio.painter.canvas import Canvas, View, disc_coverage, tinted
from studio.scene.measures import touched_by
from studio.scene.picture.stage import draw_groups, draw_people, draw_robot, overlap_opacity
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
        opacity = overlap_opacity(len(self._poses))
        corner = np.array([canvas.box.left, canvas.box.top])
        self._corner = corner
        shape = canvas.pixels.shape[:2]
        self._trails = Trails(
            canvas.pixels,
            view.to_pixels(self._poses) - corner,
            self._colour,
            max(1, round(2 * canvas.unit)),
            opacity,
        )
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


class Ghosts:
    """Many equal translucent discs, drawn fast: stamped into a plane of counts, blended once."""

    _FINE = 4  # stamps a pixel, in each direction

    def __init__(self, shape: tuple[int, ...], radius: float, opacity: float) -> None:
        radius = max(radius, 1.5)
        self._reach = math.ceil(radius) + 1
        side = 2 * self._reach + 1
        # as many levels of grey at the rim as leave room for as many discs as can be told apart
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
    """Faint paths that grow; where n of them cross their opacity is 1 − (1 − opacity)^n."""

    def __init__(
        self,
        pixels: PixelArray,
        paths: FloatArray,
        colour: Colour,
        pen: int,
        opacity: float,
    ) -> None:
        self._ground, self._layer = pixels.copy(), pixels.copy()
        self._paths, self._colour, self._pen = paths, colour, pen
        self._strength = np.float32(math.log1p(-opacity) / 255.0)
        self._counts = np.zeros(pixels.shape[:2], np.float32)  # in 255ths of a path
        # what each path covers so far, so that a path that crosses itself counts once
        low, high = paths.min(axis=1) - pen - 1, paths.max(axis=1) + pen + 2
        limits = np.array(pixels.shape[1::-1])
        self._corners = np.clip(np.floor(low), 0, limits).astype(int)  # (K, 2)
        self._sides = np.clip(np.ceil(high), 0, limits).astype(int) - self._corners
        self._masks = [np.zeros((height, width), np.uint8) for width, height in self._sides]
        self._step = 0.0

    def drawn_to(self, step: float) -> PixelArray:
        """The ground with the paths up to a step, which must not go back."""
        if step <= self._step:
            return self._layer
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
        # the part of each path's mask that its new piece may touch
        low = np.floor(points.min(axis=1)).astype(int) - self._pen - 1
        high = np.ceil(points.max(axis=1)).astype(int) + self._pen + 2
        starts = np.minimum(np.maximum(low - self._corners, 0), self._sides)
        ends = np.minimum(np.maximum(high - self._corners, 0), self._sides)
        local = points - (self._corners + starts)[:, None] - 0.5
        fixed = np.rint(local * 16).astype(np.int32)
        parts = np.concatenate([starts, ends, self._corners], axis=-1).tolist()
        for mask, line, part in zip(self._masks, fixed, parts, strict=True):
            self._add(mask, line, part)
        self._blend(low.min(axis=0), high.max(axis=0))
        return self._layer

    def _add(self, mask: PixelArray, line: NDArray[np.int32], part: list[int]) -> None:
        """Add a piece of a path, within a part of its mask, to the counts."""
        left, top, right, bottom, x, y = part
        covered = mask[top:bottom, left:right]
        if covered.size:
            before = covered.copy()
            cv2.polylines(covered, [line], False, 255, self._pen, cv2.LINE_AA, 4)
            counts = self._counts[y + top : y + bottom, x + left : x + right]
            cv2.accumulate(cv2.subtract(covered, before), counts)

    def _blend(self, low: NDArray[np.int_], high: NDArray[np.int_]) -> None:
        limits = self._counts.shape[1::-1]
        (left, top), (right, bottom) = np.clip(low, 0, limits), np.clip(high, 0, limits)
        if left < right and top < bottom:
            kept = cv2.exp(self._counts[top:bottom, left:right] * self._strength)
            ground = self._ground[top:bottom, left:right]
            self._layer[top:bottom, left:right] = tinted(ground, self._colour, 1.0 - kept)
