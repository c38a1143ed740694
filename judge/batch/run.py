"""Judging a class: what is missing is learnt once, every text is judged once, each row is kept at once."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Iterator, Sequence
from contextlib import closing
from pathlib import Path

import msgspec

from judge.batch.elsewhere import Elsewhere
from judge.batch.model import Row, Standard
from judge.batch.plan import Ground, Plan, rows_of
from judge.batch.standard import level_here, standard_of
from judge.batch.store import Store
from judge.batch.work import fault_done, judge_task, learn_task
from judge.data.cache import DataCache
from judge.errors import JudgeError, ProblemError, UsageError
from judge.judging.executors import Executor
from judge.judging.job import RunOptions
from judge.mistakes.known import is_kept
from judge.problem import Problem
from judge.problem.find import find_problem


def ground_of(ids: Iterable[str], options: RunOptions, folders: Sequence[Path], level: str = "") -> Ground:
    """By what these problems are judged; at `level` by workers elsewhere, which find the problems themselves.

    Raises:
        UsageError: the isolation that is demanded cannot be had.
        JudgeError: nothing can be judged here.
    """
    problems: dict[str, Problem] = {}
    faults: dict[str, str] = {}
    for each in dict.fromkeys(ids):
        try:
            problem = find_problem(each, folders)
            options.chosen(problem)
            problems[each] = problem
        except (ProblemError, UsageError) as fault:
            faults[each] = str(fault)
    standards: dict[str, Standard] = {}
    said: tuple[str, ...] = ()
    if problems:
        if not level:
            level, said = level_here(next(iter(problems.values())), options)
        else:
            folders = ()
        standards = {each: standard_of(problem, options, level) for each, problem in problems.items()}
    plain = msgspec.json.encode(options).decode()
    places = tuple(str(folder.absolute()) for folder in folders)
    return Ground(problems, standards, faults, plain, places, said)


def learnt(
    plan: Plan, ground: Ground, options: RunOptions, executor: Executor
) -> Iterator[tuple[str, int, int]]:
    """Build the data, and find what known mistakes answer, of each problem where that is not there yet; so
    that no two workers do it; elsewhere on each machine. Gives a problem before it is looked at, and how many
    of how many are done.
    """
    first = {work.task.problem: work for work in reversed(plan.work)}
    elsewhere = executor if isinstance(executor, Elsewhere) else None
    unknown = [each for each in sorted(first) if elsewhere or not _is_learnt(ground.problems[each], options)]
    missing = [first[each].task for each in unknown]
    if not missing:
        return
    total = len(missing) * (len(elsewhere.machines()) if elsewhere else 1)
    yield missing[0].problem, 0, total
    spread = elsewhere.everywhere if elsewhere else executor.finished
    outcomes = spread(learn_task, missing, lambda _task, why: why)
    with closing(outcomes):  # what cannot be learnt is told with each row
        for done, (place, _) in enumerate(outcomes, 1):
            yield missing[place].problem, done, total


def judged(plan: Plan, store: Store, executor: Executor) -> Generator[Row, None, None]:
    """The rows that are new, each when it is kept; close it, so that the work ends.

    Raises:
        UsageError: a worker does not judge by the standard that is asked for.
        StoreError: a row cannot be kept.
    """
    store.keep_all(plan.rows)
    yield from plan.rows
    tasks = [work.task for work in plan.work]
    outcomes = executor.finished(judge_task, tasks, fault_done)
    with closing(outcomes):
        for place, text in outcomes:
            rows = rows_of(plan.work[place], text)
            store.keep_all(rows)
            yield from rows


def _is_learnt(problem: Problem, options: RunOptions) -> bool:
    try:
        data = DataCache(problem, options.seed).exists()
        return data and (not options.named or is_kept(problem, options.seed))
    except JudgeError:  # whoever judges says so
        return True
