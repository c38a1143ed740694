"""Many circles and many rays: the circle that each ray meets first, exactly, and the promise of every ray."""

from __future__ import annotations

from judge.topics.circles import Bands
from judge.topics.circles.cells import Cells
from judge.topics.circles.many import MANY, unsound_circle, unsound_ray
from judge.topics.circles.recipes import scenes

BUILDERS = scenes.RECIPES
TOPIC = MANY


def solve(circles, rays, *, bands):
    """For each ray (index, t) or None, and why the first ray that breaks the promise does."""
    broken = unsound_circle(circles) or next(filter(None, map(unsound_ray, rays)), None)
    if broken:
        return None, broken
    cells, widths, answers = Cells(circles), Bands.of(bands), []
    for number, ray in enumerate(rays):
        answer, why = cells.first(*ray, widths)
        answers.append(answer)
        if why and not broken:
            broken = f"ray {number}: {why}"
    return answers, broken
