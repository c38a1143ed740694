"""What a worker does, on this machine or another: judge one task, and say where that was.

`judge_task` and `learn_task` are module functions, known by their names in every process; text and bytes go
in and text comes out. What a problem needs stays warm from one task to the next, for a few problems.
"""

from __future__ import annotations

import atexit
import json
import os
import resource
import time
from collections import OrderedDict
from functools import cache
from pathlib import Path

import msgspec
from msgspec.structs import replace

from judge.batch.model import Done, Standard, Task
from judge.batch.standard import differing, standard_of
from judge.errors import ProblemError, UsageError
from judge.judging.api import RunOptions
from judge.judging.session import Session
from judge.problem import Group, Problem
from judge.problem.find import find_problem
from judge.problem.model import chosen_groups
from judge.run.reference import check_needs
from judge.run.result import judge_fault

_WARM = 4  # problems whose data, reference and known mistakes a worker keeps at a time


def judge_task(task: Task) -> str:
    """Judge it: a `Done`, as JSON. A problem that cannot be judged is the result JE.

    Raises:
        UsageError: there is no such problem here, this worker does not judge by the task's standard, or the
            isolation cannot be had.
    """
    began = _cpu()
    try:
        session = _benches().session(task)
        points = sum(group.points for group in _chosen(session))
        result = session.judge(task.source, task.name)
    except ProblemError as fault:
        points, result = 0, judge_fault(task.problem, task.name, str(fault))
    plain = result.as_json()
    own, boxes = (now - before for now, before in zip(_cpu(), began, strict=True))
    seconds = round(own + max(boxes, result.time.cpu_seconds), 6)  # a box may keep its children's to itself
    machine = os.uname().nodename
    ratio = result.time.ratio
    busy = ratio.busy if ratio else ""
    done = Done(plain, result.notes, machine, f"{machine}:{os.getpid()}", busy, seconds, points)
    return _text(done)


def learn_task(task: Task) -> str:
    """Build the problem's data and find what its known mistakes answer, and keep both; the task's source is
    not judged. Why that cannot be done, or nothing. Raises as `judge_task`.
    """
    try:
        session = _benches().session(task)
        session.learn()
    except ProblemError as fault:
        return str(fault)
    return ""


def fault_done(task: Task, why: str) -> str:
    """What is kept of a task that no worker could do: JE, as a `Done` in JSON."""
    return _text(Done(judge_fault(task.problem, task.name, why).as_json()))


def _text(done: Done) -> str:
    """The value as JSON; half of a surrogate pair, which a submission may answer, is a question mark."""
    try:
        return msgspec.json.encode(done).decode()
    except UnicodeEncodeError:
        plain = json.dumps(msgspec.to_builtins(done), ensure_ascii=False)
        return plain.encode("utf-8", "replace").decode()


def release() -> None:
    """End what this process keeps warm; the next task opens it again."""
    _benches().close()


class _Benches:
    """The sessions of a worker, the one that was used longest ago first."""

    def __init__(self) -> None:
        self._open: OrderedDict[tuple[str, str, str, tuple[str, ...]], Session] = OrderedDict()

    def session(self, task: Task) -> Session:
        """The session that judges such a task. Raises as `judge_task`, and ProblemError."""
        key = task.problem, task.terms, task.standard, task.folders
        if key not in self._open:
            session = _opened(task)
            while len(self._open) >= _WARM:
                self._open.popitem(last=False)[1].close()
            self._open[key] = session
        self._open.move_to_end(key)
        return self._open[key]

    def close(self) -> None:
        """End what the sessions hold."""
        while self._open:
            self._open.popitem()[1].close()


@cache
def _benches() -> _Benches:
    """Those of this process."""
    benches = _Benches()
    atexit.register(benches.close)
    return benches


def _opened(task: Task) -> Session:
    problem = find_problem(task.problem, [Path(folder) for folder in task.folders])
    asked = msgspec.json.decode(task.terms, type=RunOptions)
    standard = msgspec.json.decode(task.standard, type=Standard)
    parts = differing(standard, standard_of(problem, asked, standard.isolation))
    if parts:
        remedy = "bring the judge, its problems and Python to one version"
        where = f"{task.problem} on {os.uname().nodename}"
        what = f"what judges here differs from what was asked for: {parts}"
        raise UsageError(what, where=where, remedy=remedy)
    if asked.timed:
        _check_needs(problem)
    return Session(problem, replace(asked, isolation=standard.isolation or asked.isolation))


def _chosen(session: Session) -> tuple[Group, ...]:
    return chosen_groups(session.problem, session.options.groups, session.options.level)


def _check_needs(problem: Problem) -> None:
    """Raise ProblemError where a module is missing that its solutions need: that costs this problem alone."""
    try:
        check_needs(problem)
    except UsageError as fault:
        raise ProblemError(fault.what, remedy=fault.remedy) from fault


def _cpu() -> tuple[float, float]:
    """The CPU seconds of this process, and of its children that have ended."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time(), children.ru_utime + children.ru_stime
