"""What a worker does, on this machine or another: judge one task, and say where that was.

`judge_task` is a module's function, known by its name in every process. What a problem needs stays warm from
one task to the next, for a few problems.
"""

from __future__ import annotations

import atexit
import os
import resource
import time
from collections import OrderedDict
from pathlib import Path

from msgspec.structs import replace

from judge.batch.model import Environment, Task, WorkerResult
from judge.errors import ProblemError, UsageError
from judge.judging import RunOptions
from judge.judging.session import Session
from judge.languages import file_name
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.run.result import judge_fault
from judge.run.settings import check_needs

_WARM = 4  # problems whose data, reference and known mistakes a worker keeps at a time
_sessions: OrderedDict[Task, Session] = OrderedDict()  # that was used longest ago first


def judge_task(task: Task) -> WorkerResult:
    """Judge it. A problem that cannot be judged is the result JE.

    Raises:
        UsageError: there is no such problem here, this worker does not judge by the task's environment, or
            the isolation cannot be had.
    """
    began = _cpu()
    try:
        result = _session(task).judge(task.source, task.name)
    except ProblemError as fault:
        result = judge_fault(task.problem, task.name, str(fault))
    own, boxes = (now - before for now, before in zip(_cpu(), began, strict=True))
    seconds = round(own + max(boxes, result.time.cpu_seconds), 6)  # a box may keep its children's to itself
    machine = os.uname().nodename
    return WorkerResult(result.as_json(), machine, f"{machine}:{os.getpid()}", seconds)


def level_here(problem: Problem, options: RunOptions) -> tuple[str, tuple[str, ...]]:
    """The level of isolation that submissions get here, and what is to be said of it.

    Raises:
        UsageError: the one that is demanded cannot be had.
        JudgeError: none can.
    """
    with Session(problem, options) as session, session.take(b"", file_name("empty")) as box:
        box.inspect()
        return box.isolation, session.notes(box.isolation)


def release() -> None:
    """End what this process keeps warm; the next task opens it again."""
    while _sessions:
        _sessions.popitem()[1].close()


atexit.register(release)


def _session(task: Task) -> Session:
    """The session that judges such a task. Raises as `judge_task`, and ProblemError."""
    kind = replace(task, name="", source=b"")
    session = _sessions.pop(kind, None) or _opened(task)
    while len(_sessions) >= _WARM:
        _sessions.popitem(last=False)[1].close()
    _sessions[kind] = session
    return session


def _opened(task: Task) -> Session:
    problem = find_problem(task.problem, list(map(Path, task.folders)))
    options, isolation = task.options, task.environment.isolation
    if parts := Environment.here(problem, options, isolation).changes(task.environment):
        raise UsageError(
            f"what judges here differs from what was asked for: {parts}",
            where=f"{task.problem} on {os.uname().nodename}",
            remedy="bring the judge, its problems and Python to one version",
        )
    try:
        check_needs(problem)
    except UsageError as fault:  # a module that its solutions need is missing: this problem alone
        raise ProblemError(fault.what, remedy=fault.remedy) from fault
    return Session(problem, replace(options, isolation=isolation or options.isolation))


def _cpu() -> tuple[float, float]:
    """The CPU seconds of this process, and of its children that have ended."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time(), children.ru_utime + children.ru_stime
