"""Which known programs may explain a submission, by the cases that fail alone: quick, before all else.

A program that makes one mistake fails about the cases that a known program of it fails; one that makes two
fails about those that either fails. All others are not worth comparing answer by answer.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from judge.data.model import GroupData
from judge.mistakes.answers import Behaviour
from judge.mistakes.naming import Known

_LIKE = 0.45  # of the cases that either fails, that both fail, for a program to be worth comparing
_BY_CHANCE = 0.2  # the same where chance decides which cases fail
_SINGLES = 36  # that are kept at most, the likeliest
_SAME = 0.98  # the same for a program that may answer as the submission does everywhere
_PAIR = 0.7  # the same for two programs together
_PAIRS = 16  # that are kept at most, the likeliest
_WITHIN = 0.6  # of a program's failures, that are the submission's as well, for it to be one of two


class Nearest(Struct, frozen=True):
    """The places of the programs that may answer as the submission does, and of those worth comparing.

    `pairs` are those of two mistakes that may do so together, the likeliest first.
    """

    same: tuple[int, ...]
    worth: tuple[int, ...]
    pairs: tuple[tuple[int, int], ...]


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
    worth = {*likely[:_SINGLES], *(place for place, mask in enumerate(masks) if mask in paired)}
    same = (place for place, share in enumerate(shares) if share >= _SAME)
    together = (
        (first, second)
        for share, one, other in pairs
        if share >= _SAME
        for first in _places(one, masks, known)
        for second in _places(other, masks, known)
        if known[first].name != known[second].name
    )
    return Nearest(tuple(same), tuple(sorted(worth)), tuple(together))


def _places(mask: int, masks: Sequence[int], known: Sequence[Known]) -> Sequence[int]:
    """Those of the programs that fail just these cases, one for each mistake."""
    firsts: dict[str, int] = {}
    for place, each in enumerate(masks):
        if each == mask:
            firsts.setdefault(known[place].name, place)
    return tuple(firsts.values())


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
