"""Labels stand where they cost least, as if every dot of every line were counted for each place."""

from __future__ import annotations

import random

import pytest

from judge.drawing import labels
from judge.drawing.labels import Rectangle, place_labels

SIDE = 420


def cost(candidate, boxes, ink):
    """What a place costs, counted dot by dot."""
    radius, box = candidate
    covered = sum(box.meets(other) for other in boxes)
    return radius + labels._COVERING * covered + labels._CROSSING * sum(box.holds(*dot) for dot in ink)


@pytest.mark.parametrize("dots", [0, 7, 400])
def test_no_place_is_cheaper_and_of_equal_ones_it_is_the_first(dots):
    draw = random.Random(dots)

    def place():
        return draw.choice([draw.uniform(0, SIDE), draw.randrange(SIDE)])

    ink = [(place(), place()) for _ in range(dots)]
    boxes = [Rectangle(place(), place(), 8, 8) for _ in range(4)]
    wanted = [(place(), place(), "x" * draw.randrange(1, 30)) for _ in range(4)]
    for (x, y, text), found in zip(wanted, place_labels(wanted, SIDE, boxes, ink), strict=True):
        places = labels._candidates(x, y, text, SIDE)
        assert found.box == min(places, key=lambda each: cost(each, boxes, ink))[1]
        boxes.append(found.box)
