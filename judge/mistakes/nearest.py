"""Which known programs may explain a submission, by the cases that fail alone: quick, before all else.

A program that makes one mistake fails about the cases that a known program of it fails; one that makes two
fails about those that either fails. All others are not worth comparing answer by answer.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import isclose

from msgspec import Struct

from judge.data.model import GroupData
from judge.mistakes.naming import Known
from judge.run.result import Behaviour
from judge.values.outline import Outline

_LIKE = 0.45  # of the cases that either fails, that both fail, for a program to be worth comparing
_BY_CHANCE = 0.2  # the same where chance decides which cases fail
_SINGLES = 24  # that are kept at most, the likeliest
_SAME = 0.98  # the same for a program that may answer as the submission does everywhere
_PAIR = 0.7  # the same for two programs together that are weighed, group by group
_PAIRS = 8  # that are kept at most, the likeliest
_WITHIN = 0.6  # of a program's failures, that are the submission's as well, for it to be one of two
_SAMPLE = 100  # cases that it fails, and as many others, by which two programs at once are rated
_DIGITS = 1e-6  # to which two answers are the same then
_HARDLY = 0.3  # of a program's failures, that are the submission's as well, for it to be one of two
_UNLIKE = 0.5  # weight of a failure of one of two, in which the other one may change the answer further
_PARTS = 100  # such programs, at most
_TOGETHER = 0.6  # how well two have to explain the answers


class Nearest(Struct, frozen=True):
    """The places of the programs that may answer as the submission does, and of those worth comparing.

    `pairs` are those of two mistakes that may do so together, the likeliest first.
    """

    same: tuple[int, ...]
    worth: tuple[int, ...]
    pairs: Iterator[tuple[int, int]]


def nearest(submission: Behaviour, known: Sequence[Known], groups: Sequence[GroupData]) -> Nearest:
    """The known programs that fail nearly the submission's cases, alone or two together."""
    sizes = [(data.group.name, len(data.cases)) for data in groups if data.group.name in submission]
    ours = _failing(submission, sizes)
    masks = [_failing(each.behaviour, sizes) for each in known]
    shares = [_share(mask, ours) for mask in masks]
    likely = sorted(
        (
            place
            for place, each in enumerate(known)
            if shares[place] >= (_BY_CHANCE if each.chance else _LIKE)
        ),
        key=lambda place: -shares[place],
    )
    within = {mask for mask in masks if mask and (mask & ours).bit_count() >= _WITHIN * mask.bit_count()}
    pairs = _pairs(sorted(within), ours)
    paired = {mask for _, *two in pairs for mask in two}
    firsts: dict[tuple[int, str], int] = {}  # of a mistake's that fail the same cases
    for place, mask in enumerate(masks):
        if mask in paired:
            firsts.setdefault((mask, known[place].name), place)
    worth = {*likely[:_SINGLES], *firsts.values()}
    same = (place for place, share in enumerate(shares) if share >= _SAME)
    together = _together(submission, known, groups)
    return Nearest(tuple(same), tuple(sorted(worth)), together)


def _together(
    submission: Behaviour, known: Sequence[Known], groups: Sequence[GroupData]
) -> Iterator[tuple[int, int]]:
    """Two programs of different mistakes which, both at once, may answer as it does; likeliest first."""
    fails, passes = _sampled(submission, groups)
    heavy = passes.weight / fails.weight
    parts = _parts([_part(place, each, fails, passes) for place, each in enumerate(known)], heavy)
    rated = [
        (score, one.place, other.place)
        for i, one in enumerate(parts)
        for other in parts[:i]
        if (score := one.beside(other, len(fails.cases), heavy)) >= _TOGETHER
    ]
    for _, first, second in sorted(rated, reverse=True):
        if known[first].name != known[second].name:
            yield first, second


class _Sample(Struct, frozen=True):
    """Some cases, for each of which stand so many as `weight` says, with the submission's answers."""

    cases: Sequence[tuple[str, int, Outline | None]]
    weight: float


def _sampled(submission: Behaviour, groups: Sequence[GroupData]) -> tuple[_Sample, _Sample]:
    """Of the cases that it fails, and of those that it passes."""
    fails: list[tuple[str, int, Outline | None]] = []
    passes: list[tuple[str, int, Outline | None]] = []
    for name in (data.group.name for data in groups if data.group.name in submission):
        answers = submission[name]
        fails += [(name, case, answers.wrong[case]) for case in sorted(answers.wrong)]
        passes += [(name, case, None) for case in range(answers.reached) if case not in answers.wrong]
    return _some(fails), _some(passes)


def _some(cases: Sequence[tuple[str, int, Outline | None]]) -> _Sample:
    step = max(1, -(-len(cases) // _SAMPLE))
    return _Sample(cases[::step], float(step))


class _Part(Struct, frozen=True):
    """A program as one of two mistakes: the sampled cases that it fails, as bits.

    `fails` and `passes` are those that the submission does; `same` those in which both answer the same.
    """

    place: int
    fails: int
    same: int
    passes: int

    def beside(self, other: _Part, size: int, heavy: float) -> float:
        """How well both explain the answers. Where both fail nobody knows before what they answer together:
        one may undo what the other one does."""
        free, spared = (self.fails & other.fails).bit_count(), (self.passes & other.passes).bit_count()
        alike = ((self.same & ~other.fails) | (other.same & ~self.fails)).bit_count()
        unlike = (self.fails ^ other.fails).bit_count() - alike
        alone = (self.passes ^ other.passes).bit_count()
        return (alike + free / 2 + _UNLIKE * unlike) / (size - free / 2 + heavy * (alone + spared / 2))


def _part(place: int, known: Known, fails: _Sample, passes: _Sample) -> _Part:
    failed = same = passed = 0
    for i, (name, case, ours) in enumerate(fails.cases):
        answers = known.behaviour.get(name)
        if ours is not None and answers is not None and case in answers.wrong:
            failed |= 1 << i
            same |= _close(ours, answers.wrong[case]) << i
    for i, (name, case, _) in enumerate(passes.cases):
        answers = known.behaviour.get(name)
        passed |= (answers is not None and case in answers.wrong) << i
    return _Part(place, failed, same, passed)


def _close(ours: Outline, theirs: Outline) -> bool:
    """Whether two answers may be the same; quickly."""
    if ours == theirs:
        return True
    return (
        ours[0] == theirs[0]
        and len(ours[1]) == len(theirs[1])
        and all(isclose(a, b, rel_tol=_DIGITS) for a, b in zip(ours[1], theirs[1], strict=True))
    )


def _parts(parts: Iterable[_Part], heavy: float) -> list[_Part]:
    """Those that may be one of two mistakes, the likeliest."""
    found = []
    for each in parts:
        failed, same = each.fails.bit_count(), each.same.bit_count()
        share = failed / (failed + heavy * each.passes.bit_count() or 1)
        if share >= _HARDLY:
            found.append((share * (same + _UNLIKE * (failed - same)), each))
    return [each for _, each in sorted(found, key=lambda each: -each[0])[:_PARTS]]


def _pairs(parts: Sequence[int], ours: int) -> list[tuple[float, int, int]]:
    """The likeliest two together, and how likely they are."""
    pairs = []
    for i, one in enumerate(parts):
        for other in parts[:i]:
            both = one | other
            if both not in (one, other) and (share := _share(both, ours)) >= _PAIR:
                pairs.append((share, one, other))
    return sorted(pairs, reverse=True)[:_PAIRS]


def _share(one: int, other: int) -> float:
    either = (one | other).bit_count()
    return (one & other).bit_count() / either if either else 0.0


def _failing(does: Behaviour, sizes: Sequence[tuple[str, int]]) -> int:
    """The cases that fail, as the bits of a number."""
    parts = []
    for name, size in sizes:
        digits = bytearray(b"0") * size
        answers = does.get(name)
        for case in answers.wrong if answers else ():
            digits[case] = 49  # a 1
        parts.append(digits)
    return int(b"".join(parts) or b"0", 2)
