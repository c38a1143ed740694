"""Test groups that need wider integers than a language has.

`bits` of a group is how wide the integers are that a plain solution reads and computes. A submission in a
language whose own integers are narrower is judged on the groups that fit; if it passes them it is tried on
the others as well, and they count where it passes all of these: then it has brought wider integers itself.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from judge.problem import Verdict
from judge.run.group import GroupRun
from judge.run.runner import Runner

if TYPE_CHECKING:
    from judge.data.model import GroupData

Judging = Callable[[Sequence["GroupData"]], list[GroupRun]]


class Fitting(NamedTuple):
    """The runs of the groups that count, and why others do not; nothing where all do."""

    runs: list[GroupRun]
    why: str = ""


def judge_fitting(runner: Runner, groups: Sequence[GroupData], judging: Judging) -> Fitting:
    """Judge the groups that the submission's language can do, and the others if those are passed."""
    widest = _widest(runner, groups)
    wide = [group for group in groups if widest and (group.group.bits or 0) >= widest]
    fit = [group for group in groups if group not in wide]
    if not wide or not fit:  # groups that were asked for by name are judged
        return Fitting(judging(groups))
    runs = judging(fit)
    if all(run.verdict is Verdict.AC for run in runs):
        others = judging(wide)
        if all(run.verdict is Verdict.AC for run in others):
            by_name = {run.group.name: run for run in (*runs, *others)}
            return Fitting([by_name[group.group.name] for group in groups])
    need = f"{len(wide)} group{'s need' if len(wide) > 1 else ' needs'} wider ones"
    return Fitting(runs, f"{runner.language} has integers of {widest} bits, and {need}: not judged")


def _widest(runner: Runner, groups: Sequence[GroupData]) -> int:
    """The bits of the language's widest integer; 0 where they have any size, or it does not matter."""
    if not runner.language or not any(group.group.bits for group in groups):
        return 0
    from judge.languages.model import language_called  # only for other languages than Python

    language = language_called(runner.language)
    return language.integers if language else 0
