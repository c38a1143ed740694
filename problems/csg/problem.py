"""What of a ray is inside a solid made of discs: exact intervals, and the promise of every case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from judge.data.draw import Draw
from judge.problem import Case
from judge.topics.circles import SPANS, Bands, Crowd
from judge.topics.circles.recipes import crowds
from judge.topics.circles.recipes.solids import solid_builders
from judge.topics.circles.signature import circles_and_ray
from judge.topics.circles.solids import DIFFERENCE, UNION, inside_spans, program_fault
from judge.values import Real


def stacked(draw: Draw, *, count: Sequence[int], **scene: Any) -> Case:
    """All discs are put on the stack, and only then taken together: so many as `count` bounds."""
    figure = crowds.scene(draw, kinds=("overlap", "ahead", "ahead"), must=("ahead",), count=count, **scene)
    circles, origin, direction = circles_and_ray(figure)
    steps = [draw.choice((UNION, UNION, UNION, DIFFERENCE)) for _ in circles[1:]]
    return circles, origin, direction, (*range(len(circles)), *steps)


BUILDERS = {**solid_builders(crowds.RECIPES), "stacked": stacked}
TOPIC = SPANS


def solve(circles, origin, direction, program, *, bands):
    """The intervals of t >= 0 inside; the program is one, and no two ends are nearly at one place."""
    crowd, widths = Crowd.of(circles, origin, direction), Bands.of(bands)
    every, unit = crowd.every_hit(widths), crowd.unit()
    broken = program_fault(program, len(circles)) or crowd.broken(every, widths)
    if broken:
        return [], broken
    spans = inside_spans(crowd, every, program, widths)
    return [(Real(start, unit), Real(end, unit)) for start, end in spans], None
