"""Naming the mistake: whose wrong answers are most like those of a submission.

The likeness of two programs is the larger of two figures, each between 0 and 1:

    by cases     Σ agreement over the cases that both answer wrongly / (cases that either does + ½)
    by groups    Σ min(share failed) / Σ max(share failed) over the groups, times the mean agreement

The first is Jaccard's index of the sets of failures, weighted by how alike the wrong answers are; its ½ keeps
a single case from saying much. The second is for mistakes that lose digits: which of a group's cases fail is
chance then, how many is not. Of a mistake whose programs fail nested sets of cases, such as a fixed epsilon
that may be smaller or larger, anything between two of the programs is like them too.

A mistake's score is its likeness to the power 0.7 + 0.3·(the next mistake's likeness)/(its own): between 0
and 1, and the larger the farther everything else is from explaining the same.

Two mistakes at once are tried as programs that fail wherever either of them fails. A program that gives one
answer whatever the case makes no mistake that has a name, so nothing that explains less than that is named.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations

from msgspec import Struct

from judge.compare import AnyTarget, CountTarget, ParameterTarget
from judge.compare.outline import Outline
from judge.data import GroupData
from judge.diagnose.agreement import agreement, wanted_numbers
from judge.diagnose.known import Answers, Behaviour

LEAST = 0.7  # the score below which nothing is named

_ALONE = 0.5  # added to the number of cases: one failing case is little evidence
_BETWEEN = 0.3  # of a case that one of two related programs fails and the submission does not
_RELATED = 0.3  # the least likeness of two programs of a mistake for something to be between them
_PAIR_LEAST = 0.75
_PAIR_LEFT = 0.6  # two mistakes must leave at most this part of what one leaves unexplained
_SHARE = 0.08  # of the failures that each of two mistakes must explain by itself
_MOST_IN_PAIRS = 12


class Known(Struct, frozen=True):
    """A known-wrong program: its mistake's name, and what it answers."""

    name: str
    behaviour: Behaviour


class Match(Struct, frozen=True):
    """A mistake, or two, by the places of the programs that are most like the submission."""

    places: tuple[int, ...]
    likeness: float
    score: float


def best_match(submission: Behaviour, known: Sequence[Known], groups: Sequence[GroupData]) -> Match | None:
    """What explains the submission's wrong answers, or None where nothing does well enough."""
    failures = sum(len(answers.wrong) for answers in submission.values())
    if not failures:
        return None
    compared = [_Comparison(submission, each.behaviour, groups) for each in known]
    single = _standing_out(list(_singles(compared, known)), known)
    doubles = _doubles(submission, compared, known, groups, failures)
    double = max(doubles, key=lambda match: match.score, default=_NO_MATCH)
    unexplained = _PAIR_LEFT * (1 - single.likeness)
    best = double if double.score >= _PAIR_LEAST and 1 - double.score <= unexplained else single
    plain = _Comparison(submission, _constant(submission, groups), groups).score()
    return best if best.score >= LEAST and best.likeness > plain else None


_NO_MATCH = Match((), 0.0, 0.0)


def _standing_out(matches: Sequence[Match], known: Sequence[Known]) -> Match:
    """The best match of all, its score raised by as much as it is ahead of every other mistake."""
    best = max(matches, key=lambda match: match.likeness, default=_NO_MATCH)
    if not best.likeness:
        return _NO_MATCH
    name = known[best.places[0]].name
    others = (match.likeness for match in matches if known[match.places[0]].name != name)
    next_best = max(others, default=0.0)
    return Match(best.places, best.likeness, best.likeness ** (0.7 + 0.3 * next_best / best.likeness))


class _Group(Struct, frozen=True):
    """One group of a comparison: the cases each side fails, how alike the answers are, and its size."""

    ours: frozenset[int]
    theirs: frozenset[int]
    alike: Mapping[int, float]
    size: int


class _Comparison:
    """Two programs' wrong answers on the cases where both are known."""

    def __init__(self, ours: Behaviour, theirs: Behaviour, groups: Sequence[GroupData]) -> None:
        self.theirs = theirs
        self.groups: dict[str, _Group] = {}
        for data in groups:
            name = data.group.name
            if name in ours and name in theirs:
                group = _compare(ours[name], theirs[name], data.targets)
                if group.ours or group.theirs:
                    self.groups[name] = group
        self.matched = sum(sum(group.alike.values()) for group in self.groups.values())

    def score(self) -> float:
        """The likeness of the two."""
        return max(self._by_cases(), self._by_groups())

    def _by_cases(self) -> float:
        either = sum(len(group.ours | group.theirs) for group in self.groups.values())
        return self.matched / (either + _ALONE)

    def _by_groups(self) -> float:
        common = sum(len(group.alike) for group in self.groups.values())
        if not common:
            return 0.0
        shares = [
            (len(group.ours) / group.size, len(group.theirs) / group.size) for group in self.groups.values()
        ]
        least = sum(min(pair) for pair in shares)
        weight = common / (common + _ALONE)
        return weight * self.matched / common * least / sum(max(pair) for pair in shares)

    def between(self, other: _Comparison) -> float:
        """The likeness to whatever lies between the program and another one of its mistake."""
        matched = total = core_size = hull_size = 0.0
        for name in self.groups.keys() | other.groups.keys():
            mine, yours = self.groups.get(name, _NOTHING), other.groups.get(name, _NOTHING)
            ours = mine.ours | yours.ours
            core, hull = mine.theirs & yours.theirs, mine.theirs | yours.theirs
            matched += sum(max(mine.alike.get(i, 0.0), yours.alike.get(i, 0.0)) for i in ours & hull)
            total += len(ours | core) + _BETWEEN * len(hull - core - ours)
            core_size += len(core)
            hull_size += len(hull)
        if not hull_size or core_size / hull_size < _RELATED:
            return 0.0
        return matched / (total + _ALONE)


_NOTHING = _Group(frozenset(), frozenset(), {}, 1)


def _compare(ours: Answers, theirs: Answers, targets: Sequence[AnyTarget]) -> _Group:
    mine = frozenset(case for case in ours.wrong if _decided(theirs, case))
    other = frozenset(case for case in theirs.wrong if _decided(ours, case))
    alike = {
        case: agreement(ours.wrong[case], theirs.wrong[case], targets[case])
        for case in mine & other
        if case < len(targets)
    }
    return _Group(mine, other, alike, len(targets))


def _decided(answers: Answers, case: int) -> bool:
    return case < answers.reached or case in answers.wrong


def _singles(compared: Sequence[_Comparison], known: Sequence[Known]) -> Iterable[Match]:
    """Every program by itself, and what lies between two of the same mistake."""
    scores = [comparison.score() for comparison in compared]
    for place, score in enumerate(scores):
        yield Match((place,), score, score)
    for one, other in combinations(range(len(known)), 2):
        if known[one].name == known[other].name:
            closer = max(one, other, key=lambda place: scores[place])
            between = compared[one].between(compared[other])
            yield Match((closer,), between, between)


def _doubles(
    submission: Behaviour,
    compared: Sequence[_Comparison],
    known: Sequence[Known],
    groups: Sequence[GroupData],
    failures: int,
) -> Iterable[Match]:
    """Two different mistakes at once, each of which explains something that the other does not."""
    least = _SHARE * failures
    promising = sorted(
        (place for place, each in enumerate(compared) if each.matched >= least),
        key=lambda place: -compared[place].matched,
    )
    promising = [place for place in promising if _mostly_shared(compared[place])][:_MOST_IN_PAIRS]
    for one, other in combinations(sorted(promising), 2):
        if known[one].name != known[other].name:
            together = _both(submission, compared[one], compared[other])
            joint = _Comparison(submission, together, groups)
            gain = joint.matched - max(compared[one].matched, compared[other].matched)
            if gain >= least:
                yield Match((one, other), joint.score(), joint.score())


def _mostly_shared(comparison: _Comparison) -> bool:
    """Whether most of what the known program fails is failed by the submission too."""
    theirs = sum(len(group.theirs) for group in comparison.groups.values())
    return comparison.matched >= 0.6 * theirs


def _both(submission: Behaviour, one: _Comparison, other: _Comparison) -> Behaviour:
    """What a program with both mistakes may answer: in a case that both spoil, whichever is nearer."""
    together: dict[str, Answers] = {}
    for name in one.theirs.keys() & other.theirs.keys() & submission.keys():
        first, second = one.theirs[name], other.theirs[name]
        wrong = {**second.wrong, **first.wrong}
        likeness = one.groups.get(name, _NOTHING).alike, other.groups.get(name, _NOTHING).alike
        for case, alike in likeness[1].items():
            if alike > likeness[0].get(case, 0.0):
                wrong[case] = second.wrong[case]
        together[name] = Answers(min(first.reached, second.reached), wrong)
    return together


def _constant(submission: Behaviour, groups: Sequence[GroupData]) -> Behaviour:
    """What a program answers that always gives the submission's most frequent wrong answer."""
    given = Counter(outline for answers in submission.values() for outline in answers.wrong.values())
    ((usual, _),) = given.most_common(1)
    return {
        data.group.name: Answers(
            len(data.targets),
            {case: usual for case, target in enumerate(data.targets) if _right(target) != usual},
        )
        for data in groups
    }


def _right(target: AnyTarget) -> Outline:
    """The outline of the right answer."""
    numbers = wanted_numbers(target)
    if isinstance(target, CountTarget | ParameterTarget):
        form = "count" if isinstance(target, CountTarget) else "number"
        return (form, numbers) if numbers else ("none", ())
    return (f"points {len(target.points)}", numbers)
