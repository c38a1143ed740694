"""Many circles and beams from one place: the circle that each beam meets first, exactly, and the promise."""

from __future__ import annotations

from judge.topics.circles import Bands
from judge.topics.circles.cells import Cells
from judge.topics.circles.many import MANY, unsound_beams, unsound_circle
from judge.topics.circles.recipes import beams

BUILDERS = beams.RECIPES
TOPIC = MANY


def solve(circles, origin, ways, *, bands):
    """For each direction (index, t) or None, and why the first that breaks the promise does."""
    broken = unsound_circle(circles) or unsound_beams(circles, origin, ways)
    if broken:
        return None, broken
    cells, widths, answers = Cells(circles), Bands.of(bands), []
    for number, way in enumerate(ways):
        answer, why = cells.first(origin, way, widths)
        answers.append(answer)
        if why and not broken:
            broken = f"direction {number}: {why}"
    return answers, broken
