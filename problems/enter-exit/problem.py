"""Every hit of a ray with a list of circles: exactly, in order, those at one place in any order."""

from __future__ import annotations

from judge.topics.circles import HITS, Bands, Crowd, builders, circles_and_ray
from judge.topics.circles.recipes import crowds
from judge.values import Real, Run

BUILDERS = builders(crowds.RECIPES, adapter=circles_and_ray)
TOPIC = HITS
TAGS = {-1: "enter", 0: "touch", 1: "exit"}


def solve(circles, origin, direction, *, bands):
    """The hits with t >= 0; no two of them, and none and the origin, are nearly at one place."""
    crowd, widths = Crowd.of(circles, origin, direction), Bands.of(bands)
    every, unit = crowd.every_hit(widths), crowd.unit()
    answer = []
    for run in crowd.runs(crowd.ahead(every, widths), widths):
        found = [(Real(crowd.parameter(hit, widths), unit), hit.index, TAGS[hit.side]) for hit in run]
        answer.append(Run(found) if len(found) > 1 else found[0])
    return answer, crowd.broken(every, widths)
