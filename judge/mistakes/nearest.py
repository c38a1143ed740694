"""Which known programs may explain a submission, by the cases that fail alone: quick, before all else.

A program that makes one mistake fails about the cases that a known program of it fails; one that makes two
fails about those that either fails. All others are not worth comparing answer by answer.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from msgspec import Struct

from judge.data.model import GroupData
from judge.mistakes.answers import Behaviour
from judge.mistakes.naming import Known

_LIKE = 0.45  # of the cases that either fails, that both fail, for a program to be worth comparing
_BY_CHANCE = 0.2  # the same where chance decides which cases fail
_SINGLES = 36  # that are kept at most, the likeliest
_SAME = 0.98  # the same for a program that may answer as the submission does everywhere
_PAIR = 0.7  # the same for two programs together that are weighed, group by group
_PAIRS = 16  # that are kept at most, the likeliest
_WITHIN = 0.6  # of a program's failures, that are the submission's as well, for it to be one of two
_HARDLY = 0.4  # the same where the other one may set right what it spoils, …
_MUCH = 0.15  # … if that much of the submission's failures are among its own
_WHOLLY = 0.95  # the same where they are few
_PARTS = 90  # different sets of failures that are put together by two, at most
_TOGETHER = 0.6  # how well two programs may explain which cases fail, for both at once to be run
_BOTH, _NEITHER = 0.5, 0.5  # weights of the cases that both fail: which fail then, nobody knows before
_TRIED = 60  # pairs of sets that are looked at, the likeliest …
_NAMED_TWICE = 3  # … of which so many make the same two mistakes


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
    together = _together(masks, ours, known)
    return Nearest(tuple(same), tuple(sorted(worth)), tuple(together))


def _places(mask: int, masks: Sequence[int], known: Sequence[Known]) -> Sequence[int]:
    """Those of the programs that fail just these cases, one for each mistake."""
    firsts: dict[str, int] = {}
    for place, each in enumerate(masks):
        if each == mask:
            firsts.setdefault(known[place].name, place)
    return tuple(firsts.values())


def _together(masks: Sequence[int], ours: int, known: Sequence[Known]) -> Iterator[tuple[int, int]]:
    """Two programs of different mistakes which, both at once, may fail just these cases; the likeliest first.

    Where one of them fails alone, the submission has to fail as well. Where both do it need not, for one
    mistake may undo what the other one does.
    """
    rated = [each for each in _rated(_parts(masks, ours), ours) if each[0] >= _TOGETHER]
    met: Counter[frozenset[str]] = Counter()
    for _, one, other in sorted(rated, reverse=True)[:_TRIED]:
        for first in _places(one, masks, known):
            for second in _places(other, masks, known):
                names = frozenset((known[first].name, known[second].name))
                if len(names) == 2 and met[names] < _NAMED_TWICE:
                    met[names] += 1
                    yield first, second


def _parts(masks: Iterable[int], ours: int) -> list[int]:
    """The sets of failures that one of two mistakes may have."""
    found = {}
    size = ours.bit_count()
    for mask in set(masks):
        both, all_of_it = (mask & ours).bit_count(), mask.bit_count()
        if both and (both >= _WHOLLY * all_of_it or (both >= _HARDLY * all_of_it and both >= _MUCH * size)):
            found[mask] = both * both / all_of_it
    return sorted(found, key=lambda mask: -found[mask])[:_PARTS]


def _rated(parts: Sequence[int], ours: int) -> Iterator[tuple[float, int, int]]:
    """How well every two explain which cases fail."""
    for i, one in enumerate(parts):
        for other in parts[:i]:
            both, alone = one & other, one ^ other
            agreed = (ours & alone).bit_count() + _BOTH * (ours & both).bit_count()
            failed = (ours | alone).bit_count()  # by either, less those that both programs fail alone
            free = (both & ~ours).bit_count()
            known = failed - (1 - _BOTH) * (ours & both).bit_count()
            if known:
                yield agreed / (known + _NEITHER * free), one, other


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
