"""The mistakes of one problem, ready to be recognised in results."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager

from msgspec.structs import replace

from judge.data.model import ProblemData
from judge.diagnose.answers import Behaviour, behaviour
from judge.diagnose.known import Progress, known_behaviours
from judge.diagnose.naming import Known, as_match, best_match, twins, wrong_answers
from judge.problem import Verdict
from judge.problem.solutions import Kind, Solution, read_solutions, usual_first
from judge.run.matrix import Matrix, kill_matrix
from judge.run.result import GroupResult, Pitfall, Result
from judge.run.settings import Settings

NAMED = (Verdict.WA, Verdict.RTE)  # the others do not come from wrong answers


class Namer:
    """Says which known mistake explains a result; the known-wrong programs are judged when first needed.

    `settings` say how they are judged, `workers` how many at once; `progress` opens a bar for it. Safe
    to use from several threads; `notes` are sentences for the person.
    """

    def __init__(
        self,
        data: ProblemData,
        seed: int | None,
        settings: Settings,
        workers: int,
        progress: Callable[[], AbstractContextManager[Progress | None]],
    ) -> None:
        self.notes: list[str] = []
        self._data = data
        self._seed = seed
        self._settings = replace(settings, workers=1, measured=False)
        self._workers = workers
        self._progress = progress
        self._lock = threading.Lock()
        self._known: tuple[list[Solution], list[Known]] | None = None

    def named(self, result: Result) -> Result:
        """The result with its pitfall, if its wrong answers are well explained by one or two mistakes.

        Raises JudgeError where the known-wrong programs cannot be judged.
        """
        if result.verdict not in NAMED or not any(group.wrong for group in result.groups):
            return result
        mistakes, known = self._programs()
        does = behaviour(result)
        match = best_match(does, known, self._data.groups, self._data.problem.answer)
        if match is None:
            places = twins(does, known)
            match = as_match(does, places, known)
        if match is None:
            return result.noting(_why_not(does, [mistakes[place] for place in places])) if places else result
        found = [mistakes[place] for place in match.places]
        names = tuple(mistake.name for mistake in found)
        advice = tuple(mistake.advice for mistake in found)
        return replace(result, pitfall=Pitfall(names, round(match.score, 3), advice))

    def matrix(self) -> Matrix:
        """Which group rejects which known-wrong program. Raises JudgeError where these cannot be judged."""
        mistakes, known = self._programs()
        sizes = {each.group.name: len(each.cases) for each in self._data.groups}
        return kill_matrix(
            self._data.problem.groups,
            [
                (f"wrong/{mistake.path.name}", mistake.name, _results(each.behaviour, sizes))
                for mistake, each in zip(mistakes, known, strict=True)
            ],
        )

    def _programs(self) -> tuple[list[Solution], list[Known]]:
        with self._lock:
            if self._known is None:
                programs, faults = read_solutions(self._data.problem, Kind.WRONG)
                self.notes += [f"a known mistake is left out: {fault}" for fault in faults]
                mistakes = usual_first(programs)
                with self._progress() as advance:
                    behaviours, note = known_behaviours(
                        self._data,
                        self._seed,
                        mistakes,
                        settings=self._settings,
                        workers=self._workers,
                        progress=advance,
                    )
                self.notes += [note] if note else []
                known = [Known(each.name, does) for each, does in zip(mistakes, behaviours, strict=True)]
                self._known = mistakes, known
            return self._known


def _why_not(does: Behaviour, alike: Sequence[Solution]) -> str:
    """Why a submission that answers exactly as known-wrong programs do is given no name."""
    files = ", ".join(f"wrong/{mistake.path.name}" for mistake in alike)
    if len({mistake.name for mistake in alike}) > 1:
        return f"the mistake is not named: {files} all answer as this does, and make different ones"
    count = wrong_answers(does)
    told = "1 wrong answer is" if count == 1 else f"{count} wrong answers are"
    return f"the mistake is not named: it answers as {files} does, but {told} too few to be sure"


def _results(does: Behaviour, sizes: Mapping[str, int]) -> list[GroupResult]:
    """What a behaviour says of the groups: how many cases of them were rejected, and which."""
    return [
        GroupResult(
            name,
            Verdict.WA if answers.wrong else Verdict.AC,
            sizes[name],
            sizes[name] - len(answers.wrong),
            None,
            0.0,
            wrong=answers.wrong,
        )
        for name, answers in does.items()
    ]
