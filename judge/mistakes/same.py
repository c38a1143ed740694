"""Known programs that answer as a submission does, nearly everywhere: they are told without any weighing.

Such a program makes the submission's mistake, if no other mistake leads to the same answers. Two mistakes at
once are found as well, by running the program that makes both.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from itertools import islice

from judge.data.model import GroupData
from judge.mistakes.evidence import Evidence
from judge.mistakes.likeness import NEEDED, Likeness
from judge.mistakes.naming import Known, Match, Rights, gather
from judge.run.result import Answers, Behaviour
from judge.values.atoms import Type
from judge.values.outline import Usual

Cases = Mapping[str, Sequence[int]]  # by the group's name
# what the program answers that makes two known mistakes, in some cases; None where nobody can write it
Joint = Callable[[int, int, Cases], Behaviour | None]

_SAME = 0.99  # of the wrong answers of either, that are the same in both; the rest is rounding
_APART = 0.1  # by how much less than that those of other mistakes must be
_MANY = 30  # wrong answers, from which on that says it all
_TRIED = 16  # programs of two mistakes that are run on a few cases …
_NAMED_TWICE = 3  # … of which so many make the same two mistakes, of so many likely ones …
_LOOKED_AT = 150
_MOST = 0.7  # … most of which they have to answer as the submission does …
_RUN = 3  # … before so many of them are run on some
_FEW, _SOME = 12, 45  # of the cases that it fails; and of the others
_MISSED = 0.08  # of those, that may be different, and in the end of all …
_MISSED_BY_CHANCE = 0.12, 0.04  # … where chance decides for one of the two, and for both
_CLEARLY = 1.5  # and so many times as many have to be with other mistakes
ENOUGH = 6  # wrong answers of twins; evidence.py has cases that are much alike count for as many at most


class Same:
    """The known programs held against one submission; `rights` are the outlines of all right answers.

    `joint` runs the program that makes two of the mistakes.
    """

    def __init__(
        self,
        submission: Behaviour,
        known: Sequence[Known],
        groups: Sequence[GroupData],
        answer: Type,
        rights: Rights,
        joint: Joint | None = None,
    ) -> None:
        self._submission = submission
        self._known = known
        self._groups = [data for data in groups if data.group.name in submission]
        self._answer = answer
        self._rights = rights
        self._joint = joint
        self._known_shares: dict[tuple[tuple[int, int], bool], float] = {}

    def one(self, places: Sequence[int]) -> Match | None:
        """The one mistake of a program, of those at `places`, that answers as the submission does."""
        if not places or wrong_answers(self._submission) < _MANY:
            return None
        shares = [self._share(self._known[place].behaviour) for place in places]
        most = max(shares)
        like = {
            self._known[place].name
            for place, share in zip(places, shares, strict=True)
            if share > most - _APART
        }
        if most < _SAME or len(like) > 1:
            return None
        return self._match((places[shares.index(most)],))

    def two(self, pairs: Iterable[tuple[int, int]]) -> Match | None:
        """The two mistakes of which the program that makes both answers as the submission does.

        `pairs` are tried in order, as long as they are few. Where others do nearly as well, or one of the two
        does alone, none is told.
        """
        if self._joint is None or wrong_answers(self._submission) < _MANY:
            return None
        tried: list[tuple[float, tuple[int, int]]] = []
        met: Counter[frozenset[str]] = Counter()
        for pair in islice(pairs, _LOOKED_AT):
            names = frozenset(self._known[place].name for place in pair)
            share = self._of_both(pair, self._few) if met[names] < _NAMED_TWICE else None
            met[names] += share is not None
            if share is not None and share >= _MOST:
                tried.append((share, pair))
            if len(self._known_shares) == _TRIED:
                break
        found: dict[frozenset[str], tuple[float, tuple[int, int]]] = {}
        for _, pair in sorted(tried, key=lambda each: -each[0]):
            names = frozenset(self._known[place].name for place in pair)
            if names not in found:
                found[names] = self.fits(*pair) or 0.0, pair
            if len(found) == _RUN:
                break
        if not found:
            return None
        best, *others = self._told_apart(sorted(found.values(), reverse=True))
        missed = 1 - best[0]
        if missed > self._allowed(best[1]) or any(1 - share <= _CLEARLY * missed for share, _ in others):
            return None
        if not self._needed(best[1], best[0]) or 1 - self._everywhere(best[1]) > _MISSED:
            return None
        return self._match(best[1])

    def _everywhere(self, pair: tuple[int, int]) -> float:
        """What `fits` says of some cases, of all."""
        every = {data.group.name: range(self._submission[data.group.name].reached) for data in self._groups}
        return self._share(self._joint(*pair, every) if self._joint else None)

    def _told_apart(self, found: list[tuple[float, tuple[int, int]]]) -> list[tuple[float, tuple[int, int]]]:
        """The same, where the first two do as well by what they answer where they differ."""
        if len(found) < 2 or (1 - found[1][0]) > _CLEARLY * (1 - found[0][0]):
            return found
        (_, first), (_, second) = found[:2]
        wrong = [
            {(name, case) for place in pair for name, each in self._behaves(place) for case in each.wrong}
            for pair in (first, second)
        ]
        differ = sorted(wrong[0] ^ wrong[1])
        only: dict[str, list[int]] = {data.group.name: [] for data in self._groups}
        for name, case in differ[:: -(-len(differ) // _SOME) or 1]:
            if name in only:
                only[name].append(case)
        told = [
            (self._share(self._joint(*pair, only) if self._joint else None, only), pair)
            for pair in (first, second)
        ]
        if told[0][0] == told[1][0]:
            return found
        best = max(told)[1]
        other, share = (second if best == first else first), min(each for each, _ in told)
        return [(found[0][0], best), (min(share, found[1][0]), other), *found[2:]]

    def _behaves(self, place: int) -> Iterable[tuple[str, Answers]]:
        return self._known[place].behaviour.items()

    def _allowed(self, pair: Sequence[int]) -> float:
        """The share of the cases in which the program that makes both may answer something else."""
        chances = sum(self._known[place].chance for place in pair)
        return _MISSED_BY_CHANCE[chances - 1] if chances else _MISSED

    def fits(self, one: int, other: int) -> float | None:
        """How much the program that makes both mistakes answers as the submission does, of 1, in some cases.

        None where nobody can write it.
        """
        return self._of_both((one, other), self._some)

    def _of_both(self, pair: tuple[int, int], only: Cases) -> float | None:
        key = pair, only is self._some
        if key not in self._known_shares:
            does = self._joint(*pair, only) if self._joint else None
            if does is None:
                return None
            self._known_shares[key] = self._share(does, only)
        return self._known_shares[key]

    @cached_property
    def _few(self) -> Cases:
        return self._cases(_FEW, 0)

    @cached_property
    def _some(self) -> Cases:
        return self._cases(_SOME, _SOME)

    def _cases(self, wrong: int, right: int) -> Cases:
        """At most so many of the cases that it fails and passes, evenly from all of them."""
        fails = [(name, case) for name, each in self._submission.items() for case in sorted(each.wrong)]
        passes = [
            (name, case)
            for name, each in self._submission.items()
            for case in range(each.reached)
            if case not in each.wrong
        ]
        found: dict[str, list[int]] = {data.group.name: [] for data in self._groups}
        for cases, most in ((fails, wrong), (passes, right)):
            for name, case in cases[:: -(-len(cases) // most) or 1] if most else ():
                if name in found:
                    found[name].append(case)
        return {name: sorted(cases) for name, cases in found.items()}

    def _share(self, does: Behaviour | None, only: Cases | None = None) -> float:
        """Of the wrong answers of either, how many are the same in both; in all cases, or in some."""
        if does is None:
            return 0.0
        overlaps = []
        for name, each in self._evidence.items():
            beside = each.beside(does.get(name))
            overlaps.append(beside.within(only[name]) if only is not None and beside else beside)
        return Likeness.of(overlaps).share

    def _needed(self, pair: Sequence[int], share: float) -> bool:
        """Whether neither program alone does nearly as well, in some cases and in all."""
        known = [self._known[place].behaviour for place in pair]
        return all(
            self._share(each, self._some) < share - NEEDED and self._share(each) < 1 - NEEDED
            for each in known
        )

    @cached_property
    def _evidence(self) -> Mapping[str, Evidence]:
        usual = Usual.of(right for outlines in self._rights.values() for right in outlines)
        found = gather(self._submission, [], self._groups, self._rights, self._answer, usual)
        return {data.group.name: each for data, each in zip(self._groups, found, strict=True)}

    def _match(self, places: tuple[int, ...]) -> Match:
        return Match(places, 1.0, 1 - 1 / (1 + wrong_answers(self._submission)))


def twins(submission: Behaviour, known: Sequence[Known]) -> list[int]:
    """The places of the programs that answer as the submission does, right or wrong, in all its groups."""
    return [place for place, each in enumerate(known) if _answers_alike(submission, each.behaviour)]


def as_match(submission: Behaviour, places: Sequence[int], known: Sequence[Known]) -> Match | None:
    """The mistake that the twins make, if all make the same one and enough answers of it are wrong."""
    if len({known[place].name for place in places}) != 1 or wrong_answers(submission) < ENOUGH:
        return None
    return Match((places[0],), 1.0, 1 - 1 / (1 + wrong_answers(submission)))


def wrong_answers(submission: Behaviour) -> int:
    """In how many cases it is wrong."""
    return sum(len(answers.wrong) for answers in submission.values())


def _answers_alike(submission: Behaviour, other: Mapping[str, object]) -> bool:
    return all(other.get(name) == answers for name, answers in submission.items())
