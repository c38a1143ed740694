"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge watch`."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import nullcontext
from functools import partial
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from judge.cli.containment import Containment
from judge.cli.diagnosis import Diagnosis
from judge.cli.naming import Naming
from judge.cli.options import chosen_groups
from judge.cli.picture import Drawing
from judge.cli.recording import Recording
from judge.cli.submissions import Submission
from judge.data import ProblemData, load_data
from judge.errors import JudgeError, UsageError, shortage
from judge.report.progress import progress
from judge.report.screen import note
from judge.run import Result, Settings, judge_fault, run_submission
from judge.run.parallel import in_order
from judge.spec import Problem, Verdict
from judge.spec.find import find_problem


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is to be done about those that fail."""

    groups: tuple[str, ...] = ()  # all of them where none is named
    seed: int | None = None
    jobs: int = 1
    level: str | None = None  # of isolation, demanded
    had: str | None = None  # the level of isolation that the command has had before
    diagnosed: bool = True  # look for the smallest failing case
    named: bool = True  # look for the mistake
    regression: Path | None = None
    kept: bool = True  # in the history
    db: Path | None = None


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    Close it, so that what was started for the rest ends. Raises JudgeError.
    """
    chosen = {group.name for group in chosen_groups(problem, wish.groups)} if wish.groups else None
    jobs = min(wish.jobs, len(submissions) * len(chosen or problem.groups))
    with (
        Containment(problem, wish.level, jobs, wish.had) as containment,
        Recording(wish.db, wanted=wish.kept) as recording,
    ):
        containment.boot(submissions[0].source, submissions[0].name)
        recording.open()  # while the boxes boot
        data = _data(problem, wish.seed)
        settings = containment.settings(submissions=len(submissions))
        judge = partial(
            _judge,
            problem,
            data,
            Diagnosis(data, containment.open_box, wish.regression) if wish.diagnosed else None,
            groups=chosen,
            settings=settings,
            bar=containment.jobs == 1,
            naming=Naming(data, wish.seed, settings, containment.jobs) if wish.named else None,
        )
        results = in_order(submissions, containment.jobs, judge)
        for submission, result in zip(submissions, results, strict=True):
            if result.verdict is not Verdict.JE:  # it was not held at any level, perhaps
                containment.warn_of(result.isolation)
            recording.add(submission, result)
            yield Drawing(problem, data, result)


def named_problem(name: str, folders: Sequence[Path]) -> Problem:
    """The problem of that name. Raises UsageError, which says so where the name is a file's."""
    try:
        return find_problem(name, folders)
    except UsageError as fault:
        if name.endswith(".py"):
            remedy = "the problem comes first: judge run PROBLEM FILE"
            raise UsageError(f"{name!r} is no problem's name", remedy=remedy) from fault
        if "/" in name:
            remedy = "give its id, and the folder it is in with --problems"
            raise UsageError(f"{name!r} is no problem's name", remedy=remedy) from fault
        raise


def _data(problem: Problem, seed: int | None) -> ProblemData:
    with progress(f"building {problem.id}") as advance:
        data = load_data(problem, seed=seed, progress=advance)
    for text in data.notes:
        note(text)
    return data


def _judge(
    problem: Problem,
    data: ProblemData,
    diagnosis: Diagnosis | None,
    submission: Submission,
    *,
    groups: set[str] | None,
    settings: Settings,
    bar: bool,
    naming: Naming | None,
) -> Result:
    source, name = submission.source, submission.name
    if diagnosis is not None:
        settings = replace(settings, diagnose=partial(diagnosis, submission))
    try:
        with progress(name) if bar else nullcontext() as advance:
            result = run_submission(
                problem, data, source, name, groups=groups, on_progress=advance, settings=settings
            )
        return naming.named(result) if naming else result
    except UsageError:  # a level of isolation that cannot be had
        raise
    except JudgeError as fault:  # such as a reference that fails on a case: the others are judged still
        return judge_fault(problem.id, name, str(fault))
    except (OSError, MemoryError, RuntimeError) as fault:
        short = shortage(fault)
        if short is None:
            raise
        return judge_fault(problem.id, name, str(short))
