"""Naming the mistake: which known one explains a submission's wrong answers best.

Each hypothesis is that the submission does what a known-wrong program does, what lies between two programs of
a mistake (an epsilon larger than the one's and smaller than the other's), or what two programs do together.
Its evidence is the sum over the test groups of `judge.mistakes.evidence`. Against all of them stand the
hypotheses that nothing known explains it, and that it gives one answer to everything.

The score is the probability of the best hypothesis beside those that contradict it, less where it leaves a
part of the failures unexplained, or fails more than the submission does.

No group counts for more than a hundred to one, so that nothing is ever likely enough where only a few
groups can fail. Such a problem's own wrong programs, and whatever answers as one of them in every case, are
`twins`.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from judge.data.model import GroupData
from judge.mistakes.evidence import Evidence, log_sum
from judge.mistakes.likeness import BOTH, IN_PART, NEEDED, Likeness
from judge.run.result import Answers, Behaviour
from judge.values import outline
from judge.values.atoms import Type
from judge.values.outline import Outline, Usual

LEAST = 0.7  # the score below which nothing is named

_UNKNOWN = 6.0  # the evidence that a mistake must have to be as likely as one that nobody knows
_SECOND = 6.0  # the evidence that a second mistake must add
_TWIN = 1.5  # the evidence that a second program of the same mistake must add
_CLEAR = 2.0  # the evidence with which a group speaks for two mistakes, or against one of them alone
_EXPLAINED = 0.95  # a hypothesis that explains less of the failures loses in score
_BY_ITSELF = 2.0  # the evidence that a group is given for being explained, before it is asked
_ALIKE = 0.9  # of its and the submission's wrong answers are the same, for a mistake to be told from others
_APART = 0.1  # and by how much more than with any of those
_NEARLY = 3.0  # the evidence by which a mistake must lead, or another one is told beside it
_LEADING = 3  # mistakes that are tried together with others
_PARTNERS = 10  # programs that each of them is tried with


Rights = Mapping[str, Sequence[Outline]]  # of the right answers, by the group's name


# how much of what two programs at once answer is what the submission answers; None where nobody knows
Fits = Callable[[int, int], float | None]

_CHECKED = 2  # hypotheses of two mistakes whose program is run


class Known(Struct, frozen=True):
    """A known-wrong program: its mistake's name, its answers, and whether chance decides where it fails."""

    name: str
    behaviour: Behaviour
    chance: bool = True


class Match(Struct, frozen=True):
    """A mistake, or two, by the places of the programs that are most like the submission.

    `explained` is how much of the failures they explain, of 1. `perhaps` are those of a mistake that explains
    them nearly as well, none or one.
    """

    places: tuple[int, ...]
    explained: float
    score: float
    perhaps: tuple[int, ...] = ()

    def at(self, places: Sequence[int]) -> Match:
        """The same with `places` of another list for those of the one that was searched."""
        moved = tuple(places[place] for place in self.places), tuple(places[place] for place in self.perhaps)
        return replace(self, places=moved[0], perhaps=moved[1])


def best_match(
    submission: Behaviour,
    known: Sequence[Known],
    groups: Sequence[GroupData],
    answer: Type,
    fits: Fits | None = None,
    rights: Rights | None = None,
) -> Match | None:
    """What explains the submission's wrong answers, or None where nothing does well enough.

    Two mistakes at once fail where either does, unless `fits` knows better. `rights` are found where they are
    not given.
    """
    if not known or not any(answers.wrong for answers in submission.values()):
        return None
    if rights is None:
        rights = {
            data.group.name: [outline.right(answer, target) for target in data.targets] for data in groups
        }
    usual = Usual.of(right for outlines in rights.values() for right in outlines)
    groups = [data for data in groups if data.group.name in submission]
    evidence = gather(submission, known, groups, rights, answer, usual)
    found = sorted(_hypotheses(evidence, known), key=lambda each: -each.total)
    found = _told_apart(_checked(found, evidence, known, fits) if fits else found, evidence)
    against = [_UNKNOWN, _of_one_answer(submission, groups, evidence, rights)]
    for best in found:
        if best.total <= max(against):
            return None
        rivals = [each.total for each in found if each is best or not best.names <= each.names]
        probability = math.exp(best.total - log_sum(rivals + against))
        explained = _explained(best, evidence)
        score = probability * min(1.0, explained / _EXPLAINED)
        if score >= LEAST and _alike(best, score, evidence, known):
            return Match(best.named, explained, score, _close(best, found))
        if len(best.names) == 1:
            return None  # two mistakes may be too much to say where one of them is not
    return None


def _told_apart(found: list[_Hypothesis], evidence: Sequence[Evidence]) -> list[_Hypothesis]:
    """Without single mistakes that are as likely as another one which alone answers as the submission does.

    A group speaks for no mistake with more than a hundred to one, so that several reach that bound together.
    """
    close = [each for each in found if found[0].total - each.total < _NEARLY]
    if len(close) < 2 or any(len(each.names) > 1 for each in close):
        return found
    alike = {each.places: _likeness(each.places[0], evidence) for each in close}
    first, second, *_ = sorted(close, key=lambda each: -alike[each.places])
    if alike[first.places] < _ALIKE or alike[first.places] - alike[second.places] < _APART:
        return found
    return [first, *(each for each in found if each not in close)]


def _likeness(place: int, evidence: Sequence[Evidence]) -> float:
    """Of the cases that either fails, the share in which both give the same wrong answer."""
    return Likeness.of(each.overlap(place) for each in evidence).share


def _alike(best: _Hypothesis, score: float, evidence: Sequence[Evidence], known: Sequence[Known]) -> bool:
    """Whether what the hypothesis does is what the submission does, case by case."""
    one, *others = best.places
    found = [Likeness.of(each.overlap(place) for each in evidence) for place in best.places]
    if others:
        found.append(Likeness.of(each.both(one, *others) for each in evidence))
        if len(best.names) == 1:
            found.append(Likeness.of(each.midway(one, *others) for each in evidence))
        else:
            found = found[-1:]
    chances = [known[place].chance for place in best.named]
    if best.fits is not None:
        return True
    if len(best.names) == 2 and found[0].share < _alone(best, evidence) + NEEDED:
        return False
    return any(each.enough(chances, score) for each in found)


def _alone(best: _Hypothesis, evidence: Sequence[Evidence]) -> float:
    """How alike the better one of its programs is by itself."""
    return max(_likeness(place, evidence) for place in best.places)


def _close(best: _Hypothesis, found: Iterable[_Hypothesis]) -> tuple[int, ...]:
    """The place of another mistake that is nearly as likely as the one that is named."""
    for each in found:
        if len(best.names) == len(each.names) == 1 and each is not best:
            return each.named if best.total - each.total < _NEARLY else ()
    return ()


class _Hypothesis(Struct, frozen=True):
    """Programs, by their places, with the evidence of each group; `total` is less what they cost."""

    names: frozenset[str]
    places: tuple[int, ...]
    ratios: Sequence[float]
    total: float
    fits: float | None = None  # how well the program of two mistakes does, where it has been run

    @property
    def named(self) -> tuple[int, ...]:
        """One program for each mistake."""
        return self.places[: len(self.names)]


def gather(
    submission: Behaviour,
    known: Sequence[Known],
    groups: Sequence[GroupData],
    rights: Rights,
    answer: Type,
    usual: Usual,
) -> list[Evidence]:
    """The evidence of each group."""
    programs = Counter(each.name for each in known)
    weights = [1 / programs[each.name] for each in known]
    chance = [each.chance for each in known]
    return [
        Evidence(
            submission[data.group.name],
            [each.behaviour.get(data.group.name) for each in known],
            weights,
            rights[data.group.name],
            answer,
            usual,
            chance,
        )
        for data in groups
    ]


def _hypotheses(evidence: Sequence[Evidence], known: Sequence[Known]) -> Iterable[_Hypothesis]:
    """The best one of each mistake, and of each two."""
    best: dict[frozenset[str], _Hypothesis] = {}

    def consider(places: tuple[int, ...], ratios: Sequence[float], cost: float) -> None:
        names = frozenset(known[place].name for place in places)
        total = math.fsum(ratios) - cost
        if names not in best or total > best[names].total:
            best[names] = _Hypothesis(names, places, ratios, total)

    for place in range(len(known)):
        consider((place,), [each.ratios[place] for each in evidence], 0.0)
    leading = sorted(best.values(), key=lambda each: -each.total)[:_LEADING]
    for first in (each.places[0] for each in leading):
        for second in _partners(first, evidence, known):
            twins = known[first].name == known[second].name
            joint = [each.union(first, second) for each in evidence]
            if twins or _both_needed(first, second, joint, evidence):
                consider((first, second), joint, _TWIN if twins else _SECOND)
            if twins:
                consider((first, second), [each.between(first, second) for each in evidence], _TWIN)
    return best.values()


def _checked(
    found: Sequence[_Hypothesis], evidence: Sequence[Evidence], known: Sequence[Known], fits: Fits
) -> list[_Hypothesis]:
    """Without those of two mistakes that the program which makes both does not bear out."""
    checked, run = [], 0
    for each in found:
        share = None
        if len(each.names) == 2 and each.total > found[0].total - _SECOND and run < _CHECKED:
            share = fits(*each.places)
        if share is not None:
            run += 1
            least = IN_PART if any(known[place].chance for place in each.places) else BOTH
            if share < max(least, _alone(each, evidence) + NEEDED):
                continue
            each = replace(each, fits=share)
        checked.append(each)
    return checked


def _partners(place: int, evidence: Sequence[Evidence], known: Sequence[Known]) -> list[int]:
    """The programs that explain most of what the one at `place` does not."""
    failing = [each.ratios for each in evidence if each.failed_share]
    gains = []
    for other, program in enumerate(known):
        cost = _TWIN if program.name == known[place].name else _SECOND
        gain = math.fsum(max(ratios[other] - ratios[place], 0.0) for ratios in failing) - cost
        if other != place and gain > 0.0:
            gains.append((gain, other))
    return [other for _, other in sorted(gains, reverse=True)[:_PARTNERS]]


def _both_needed(one: int, other: int, joint: Sequence[float], evidence: Sequence[Evidence]) -> bool:
    """Whether each of two programs explains a group that speaks against the other one."""
    return all(
        any(
            each.ratios[place] < -_CLEAR and ratio > _CLEAR
            for each, ratio in zip(evidence, joint, strict=True)
        )
        for place in (one, other)
    )


def _explained(best: _Hypothesis, evidence: Sequence[Evidence]) -> float:
    """How much of the failures of both sides the hypothesis explains, group by group."""
    explained = total = 0.0
    for each, ratio in zip(evidence, best.ratios, strict=True):
        share = max(each.failed_share, *(each.shares[place] for place in best.places))
        total += math.sqrt(share)
        explained += math.sqrt(share) / (1 + math.exp(-ratio - _BY_ITSELF))
    return explained / total if total else 0.0


def _of_one_answer(
    submission: Behaviour, groups: Sequence[GroupData], evidence: Sequence[Evidence], rights: Rights
) -> float:
    """The evidence that the submission always gives its most frequent wrong answer."""
    given = Counter(outline for answers in submission.values() for outline in answers.wrong.values())
    ((usual, _),) = given.most_common(1)
    return sum(
        each.against(Answers(len(data.targets), _wrong_by(usual, rights[data.group.name])))
        for data, each in zip(groups, evidence, strict=True)
    )


def _wrong_by(answer: Outline, rights: Sequence[Outline]) -> dict[int, Outline]:
    """What is wrong if `answer` is given to everything."""
    return {case: answer for case, right in enumerate(rights) if right != answer}
