"""Known programs that answer as a submission does, nearly everywhere: they are told without any weighing.

Such a program makes the submission's mistake, if no other mistake leads to the same answers. Two mistakes at
once are found as well, by running the program that makes both.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import islice

from judge.data.model import GroupData
from judge.mistakes.answers import Behaviour
from judge.mistakes.evidence import Evidence
from judge.mistakes.likeness import NEEDED, Likeness
from judge.mistakes.naming import Cases, Joint, Known, Match, Rights, gather
from judge.values import Type, Usual

_SAME = 0.99  # of the wrong answers of either, that are the same in both; the rest is rounding
_APART = 0.1  # by how much less than that those of other mistakes must be
_MANY = 30  # wrong answers, from which on that says it all
_TRIED = 8  # programs of two mistakes that are run on a few cases …
_MOST = 0.8  # … most of which they have to answer as the submission does …
_RUN = 2  # … before so many of them are run on more, at most as many as these of each group
_SOME = 8
ENOUGH = 6  # wrong answers of twins; evidence.py has cases that are much alike count for as many at most


class Same:
    """The known programs held against one submission; `rights` are the outlines of all right answers."""

    def __init__(
        self,
        submission: Behaviour,
        known: Sequence[Known],
        groups: Sequence[GroupData],
        answer: Type,
        rights: Rights,
    ) -> None:
        self._submission = submission
        self._known = known
        self._groups = [data for data in groups if data.group.name in submission]
        self._answer = answer
        self._rights = rights

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

    def two(self, pairs: Sequence[tuple[int, int]], joint: Joint) -> Match | None:
        """The two mistakes of which the program that makes both answers as the submission does.

        `pairs` are tried in order, as long as they are few; a mistake that one of them does not need is none.
        """
        if not pairs or wrong_answers(self._submission) < _MANY:
            return None
        few, some = self._cases(1), self._cases(_SOME)
        found: dict[frozenset[str], tuple[float, tuple[int, int]]] = {}
        likely = (pair for pair in pairs[:_TRIED] if self._share(joint(*pair, few), few) >= _MOST)
        for pair in islice(likely, _RUN):
            share = self._share(joint(*pair, some), some)
            names = frozenset(self._known[place].name for place in pair)
            if share >= _SAME and share > found.get(names, (0.0, pair))[0] and self._needed(pair, share):
                found[names] = share, pair
            if share == 1.0:
                break
        if len(found) != 1:
            return None
        ((_, pair),) = found.values()
        return self._match(pair)

    def _cases(self, count: int) -> Cases:
        """Some cases of each group: of those that fail, and as many that may pass, evenly from all of it."""
        found = {}
        for data in self._groups:
            wrong, size = sorted(self._submission[data.group.name].wrong), len(data.cases)
            chosen = {*wrong[:: len(wrong) // count + 1]}
            if wrong and count > 1:
                chosen |= {*range(0, size, size // count + 1)}
            found[data.group.name] = sorted(chosen)
        return found

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
        """Whether neither program alone does nearly as well, in all cases: some may be those that differ."""
        return all(self._share(self._known[place].behaviour) < share - NEEDED for place in pair)

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
