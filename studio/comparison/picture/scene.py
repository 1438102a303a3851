"""One side's scene in a comparison: outcomes move one at a time and leave faint paths behind.

Shown one at a time they can be counted without being told to (Hullman et al., "Hypothetical outcome
plots outperform error bars and violin plots", PLoS ONE 2015); paths instead of a hull keep rare
ones visible and the area between them empty (Padilla et al., "Effects of ensemble and summary
displays on interpretations of geospatial uncertainty data", Cognitive Research 2017).
"""

import cv2
import numpy as np

from scenes import Rollouts
from studio.arrays import FloatArray
from studio.painter.canvas import Canvas
from studio.painter.paths import FaintPaths
from studio.painter.views import View
from studio.scene.measures import touched_by
from studio.scene.picture.crowd import between
from studio.scene.picture.scenery import (
    draw_contacts,
    draw_goal,
    draw_groups,
    draw_people,
    draw_robot,
    draw_wall_contacts,
    overlap_opacity,
)
from studio.style.palette import Colour

_FILM_FRINGE = (0.0, 2.0)  # see `FaintPaths`: what these films have always shown
_FADED = 0.4  # how opaque paths are that have stepped back
_MARK_OF_ONE = 5.5  # radius of the mark of contact of the outcome that plays, in units of the page


class OutcomeScene:
    """The scene under one action, with the paths of the outcomes so far.

    Args:
        canvas: clipped to the scene, with everything drawn that never changes.
        view: of the scene.
        rollouts: of the scene, whose paths are all kept.
        side: index of the action.
    """

    def __init__(self, canvas: Canvas, view: View, rollouts: Rollouts, side: int) -> None:
        self._canvas, self._view, self._scene = canvas, view, rollouts.scene
        self._colour = canvas.theme.action_colour(rollouts.names[side])
        self._poses = rollouts.robot[side]  # (K, T+1, 3), m and rad
        self._people = rollouts.pedestrians[side]  # (K, T+1, P, 2), m
        self._contact_step = rollouts.contact_step[side]
        self._marked = (
            (rollouts.wall_step[side], draw_wall_contacts),
            (rollouts.person_step[side], draw_contacts),
        )
        opacity = overlap_opacity(len(self._poses))
        pen = 2 * canvas.unit
        self._robots = FaintPaths(canvas, self._colour, pen, opacity, _FILM_FRINGE)
        self._crowd = FaintPaths(canvas, canvas.theme.pedestrian, pen, 0.35 * opacity, _FILM_FRINGE)
        self._ground = canvas.pixels.copy()
        self._seen = 0
        self._layer = self._ground

    def keep(self, count: int) -> None:
        """Leave the paths and contacts of the first `count` outcomes behind, never fewer."""
        new = slice(self._seen, count)
        self._robots.add(self._view.to_pixels(self._poses[new]))
        for people in self._people[new].swapaxes(1, 2):  # (P, T+1, 2)
            self._crowd.add(self._view.to_pixels(people))
        self._seen = count
        canvas = self._canvas
        canvas.pixels[:] = self._robots.over(self._crowd.over(self._ground))
        for steps, draw in self._marked:
            [touching] = np.nonzero(steps[:count] >= 0)
            draw(canvas, self._view, self._poses[touching, steps[touching]])
        self._layer = canvas.pixels.copy()

    def fade(self) -> None:
        """Let what was left behind step back, for one outcome to be seen before it."""
        cv2.addWeighted(self._layer, _FADED, self._ground, 1.0 - _FADED, 0.0, dst=self._layer)

    def draw_at_rest(self) -> None:
        """Draw what was left behind, and everybody where the scene has them at the start."""
        robot = self._scene.robot
        self._canvas.pixels[:] = self._layer
        pose = np.array([*robot.start, robot.start_heading])
        self._draw_everybody(pose, self._scene.starts, self._colour)

    def draw_outcome(self, outcome: int, step: float) -> None:
        """Draw what was left behind, and one outcome at a step with the robot's way so far."""
        canvas, view, one = self._canvas, self._view, slice(outcome, outcome + 1)
        [pose], [people] = between(self._poses[one], step), between(self._people[one], step)
        canvas.pixels[:] = self._layer
        way = np.concatenate([self._poses[outcome, : int(step) + 1], [pose]])
        canvas.line(view.to_pixels(way), self._colour, 3 * canvas.unit)
        touched = touched_by(self._contact_step[outcome], step)
        self._draw_everybody(pose, people, canvas.theme.contact if touched else self._colour)
        for steps, draw in self._marked:
            if touched_by(steps[outcome], step):
                draw(canvas, view, self._poses[one, steps[outcome]], _MARK_OF_ONE)

    def _draw_everybody(self, pose: FloatArray, people: FloatArray, colour: Colour) -> None:
        draw_groups(self._canvas, self._view, self._scene, people)
        draw_people(self._canvas, self._view, people)
        # above people: who stands on the goal must not hide it
        draw_goal(self._canvas, self._view, self._scene.robot.goal)
        draw_robot(self._canvas, self._view, pose, colour)
