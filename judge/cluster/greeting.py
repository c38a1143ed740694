"""Whether a worker judges as this machine does: same judge, same Python, same problems, well contained.

What a worker is stands in the names of its resources, which the scheduler tells everybody and matches by
itself: a worker of another judge that comes later gets no task, without being asked.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from msgspec import Struct

from judge.batch.standard import standard_of
from judge.cluster.need import distributed
from judge.errors import UsageError
from judge.judging.job import Terms
from judge.problem import Problem
from judge.sandbox.boundary import LEVELS

SLOT = "judge"  # the resource of which a task takes one; the others only have to be there
_SAME = {
    "judge": "install the same judge on both",
    "python": "use the same Python on both",
    "distributed": "install the same version of distributed on both",
}


class Offer(Struct, frozen=True):
    """What decides a verdict on a machine: `facts` by the keys of `_SAME`, the versions of its problems by
    their ids, the levels of isolation that can be had.
    """

    facts: Mapping[str, str]
    problems: Mapping[str, str]
    levels: tuple[str, ...]

    def resources(self) -> dict[str, float]:
        """The names of resources that say this, one of each."""
        names = [f"{name} {value}" for name, value in self.facts.items()]
        names += [f"problem {name} {value}" for name, value in self.problems.items()]
        names += [f"isolation {level}" for level in self.levels]
        return dict.fromkeys([SLOT, *names], 1.0)

    @classmethod
    def of_resources(cls, names: Iterable[str]) -> Offer | None:
        """What a worker's resources say; None where `judge worker` has not started it."""
        names = list(names)
        if SLOT not in names:
            return None
        words = [name.split(" ", 1) for name in names if name != SLOT]
        facts = {kind: value for kind, value in words if kind in _SAME}
        problems = dict(value.rsplit(" ", 1) for kind, value in words if kind == "problem")
        levels = {value for kind, value in words if kind == "isolation"}
        return cls(facts, problems, tuple(level for level in LEVELS if level in levels))

    def wants(self, problem: str = "") -> dict[str, float]:
        """The resources that a worker must have for a task, of that problem or of none."""
        names = [SLOT, *(f"{name} {value}" for name, value in self.facts.items())]
        names += [f"isolation {level}" for level in self.levels]
        if problem in self.problems:
            names.append(f"problem {problem} {self.problems[problem]}")
        return dict.fromkeys(names, 1.0)

    def differs(self, there: Offer | None) -> tuple[str, str]:
        """In what a worker is not as it must be for this, and the remedy; empty where it is."""
        if there is None:
            what = f"was not started by 'judge worker' (it lacks the resource '{SLOT}')"
            return what, "start it with 'judge worker ADDRESS'"
        for name, remedy in _SAME.items():
            here, other = self.facts.get(name), there.facts.get(name)
            if here is not None and here != other:
                return f"has {name} {other}, and here is {here}", remedy
        for name, version in self.problems.items():
            if name not in there.problems:
                return f"has no problem '{name}'", "give it the pack, by --problems DIR or $JUDGE_PROBLEMS"
            if there.problems[name] != version:
                return f"has another version of the problem '{name}'", "bring its files to one version"
        missing = [level for level in self.levels if level not in there.levels]
        if missing:
            return f"has no isolation {missing[0]}", "see 'judge doctor' there"
        return "", ""


def offered(problems: Sequence[Problem], levels: tuple[str, ...]) -> Offer:
    """What this machine's judge and those problems are. Raises ProblemError."""
    facts = {"distributed": str(distributed().__version__)}
    versions = {}
    for each in problems:
        standard = standard_of(each, Terms(), "")
        versions[each.id] = standard.data
        facts |= {"judge": standard.judge, "python": standard.python}
    return Offer(facts, versions, levels)


def common_level(offers: Iterable[Offer]) -> str:
    """The best level of isolation that all workers have. Raises UsageError where there is none."""
    has = [set(offer.levels) for offer in offers]
    for level in LEVELS:
        if all(level in each for each in has):
            return level
    raise UsageError("the workers have no level of isolation in common", remedy="demand one with --isolation")
