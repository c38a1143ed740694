"""Where answers about circles along a ray turn: the figures of a circle and a ray, as a list of one."""

from __future__ import annotations

from msgspec.structs import replace

from judge.problem import Problem
from judge.problem.border import Border, Probe
from judge.topics.circles.borders import borders
from judge.topics.circles.part import Part

_RADIUS = 2  # its place among (cx, cy, r, O, D), and within a circle


def crowd_borders(part: Part, problem: Problem) -> tuple[Border, ...]:
    """Those of a problem with the bands `snap` and `clear`: of a touch, and of a hit at the origin.

    Of spans only a touch from inside turns the form of the answer.
    """
    program = ((0,),) if part is Part.SPANS else ()
    return tuple(
        replace(border, probes=tuple(_listed(probe, *program) for probe in border.probes))
        for border in borders(Part.RAY, problem)
        if not border.mistaken
        and all(probe.place == (_RADIUS,) for probe in border.probes)
        and (part is Part.HITS or border.about == "a tangency from inside")
    )


def _listed(probe: Probe, *others: tuple[int, ...]) -> Probe:
    cx, cy, r, origin, direction = probe.case
    case = ((cx, cy, r),), origin, direction, *others
    return replace(probe, case=case, place=(0, 0, _RADIUS), rest=0.0, step=0.0)
