"""What of a ray is inside a solid that a program of set operations makes of discs.

A program is postfix: n >= 0 is the disc n, the three operations take the two solids before them. The ray is
cut at every place where it enters or leaves a disc. Of each piece it is known which discs hold it, so that a
solid is the set of its pieces, a bit each. Pieces of no length are none: hits at one place are one cut.
"""

from __future__ import annotations

from collections.abc import Sequence

from judge.exact.surd import Surd, make
from judge.topics.circles.bands import Bands
from judge.topics.circles.crowd import Crowd, Hit

UNION, INTERSECTION, DIFFERENCE = -1, -2, -3


def inside_spans(
    crowd: Crowd, every: Sequence[Hit], program: Sequence[int], bands: Bands
) -> list[tuple[Surd, Surd]]:
    """The longest intervals of t >= 0 inside the solid, in order. The program must be one."""
    runs = list(crowd.runs([hit for hit in crowd.ahead(every, bands) if hit.side], bands))
    cuts = [crowd.parameter(run[0], bands) for run in runs]
    first = 0
    if not cuts or cuts[0].sign():
        cuts, first = [make(0, 0, 0, 1), *cuts], 1
    starts = dict.fromkeys(range(len(crowd.lines)), 0)
    ends = dict(starts)
    for place, run in enumerate(runs, first):
        for hit in run:
            (starts if hit.side < 0 else ends)[hit.index] = place
    discs = [(1 << ends[at]) - (1 << starts[at]) if ends[at] > starts[at] else 0 for at in starts]
    return [(cuts[start], cuts[end]) for start, end in _pieces(_solid(program, discs))]


def _solid(program: Sequence[int], discs: Sequence[int]) -> int:
    """The pieces of the solid, a bit each."""
    stack: list[int] = []
    for step in program:
        if step >= 0:
            stack.append(discs[step])
            continue
        other = stack.pop()
        if step == UNION:
            stack[-1] |= other
        elif step == INTERSECTION:
            stack[-1] &= other
        else:
            stack[-1] &= ~other
    return stack[-1]


def _pieces(bits: int) -> list[tuple[int, int]]:
    """Each row of ones, from its first place to behind its last one."""
    found = []
    place = 0
    while bits:
        gap = (bits & -bits).bit_length() - 1
        bits, place = bits >> gap, place + gap
        length = (~bits & (bits + 1)).bit_length() - 1
        found.append((place, place + length))
        bits, place = bits >> length, place + length
    return found
