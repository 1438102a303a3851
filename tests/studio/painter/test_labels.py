import itertools

import numpy as np

from studio.painter.boxes import Box
from studio.painter.labels import Label, distance, label_boxes
from tests.canvases import a_canvas

WHITE, BLACK = (255, 255, 255), (0, 0, 0)


def a_label(canvas, near, text="label", direction=(1.0, 0.0)):
    return Label(text, 16, 400, BLACK, near, 8.0, direction)


def test_labels_lie_near_their_things_apart_from_one_another_and_off_the_ink():
    canvas = a_canvas()
    canvas.fill(Box(310.0, 100.0, 640.0, 260.0), BLACK)
    labels = [a_label(canvas, (300.0, 180.0 + 3 * shift), f"label {shift}") for shift in range(6)]
    places = label_boxes(labels, canvas, canvas.box, WHITE)
    for first, second in itertools.combinations(places, 2):
        assert not first.overlaps(second)
    for label, box in zip(labels, places, strict=True):
        assert distance(box, label.near) < 130.0
        assert canvas.clipped(box).pixels.min() == 255


def test_labels_keep_off_the_points_that_are_to_be_seen():
    canvas = a_canvas()
    label, seen = a_label(canvas, (300.0, 180.0)), np.array([[320.0, 180.0]])
    (covering,) = label_boxes([label], canvas, canvas.box, WHITE)
    (aside,) = label_boxes([label], canvas, canvas.box, WHITE, seen)
    assert distance(covering, (320.0, 180.0)) == 0.0
    assert distance(aside, (320.0, 180.0)) > 0.0


def test_a_label_lies_where_its_thing_points_to_if_that_is_free():
    canvas = a_canvas()
    (right,) = label_boxes([a_label(canvas, (300.0, 180.0))], canvas, canvas.box, WHITE)
    (up,) = label_boxes(
        [a_label(canvas, (300.0, 180.0), "up", (0.0, -1.0))], canvas, canvas.box, WHITE
    )
    assert right.left > 300.0
    assert up.bottom < 180.0


def test_a_label_that_finds_no_room_is_left_out():
    canvas = a_canvas()
    assert label_boxes([a_label(canvas, (5.0, 5.0))], canvas, Box(0, 0, 20, 20), WHITE) == [None]
