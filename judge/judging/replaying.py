"""Judging a submission on one case, by its replay id."""

from __future__ import annotations

from msgspec.structs import replace

from judge.data.build import target_of
from judge.data.model import GroupData, ProblemData
from judge.diagnose.replay import decode
from judge.judging.session import Session
from judge.problem import Problem
from judge.problem.module import load_module
from judge.run.execute import run_in
from judge.run.hurdle import with_hurdle
from judge.run.printed import with_printed
from judge.run.result import Result


def replayed(session: Session, replay: str, source: bytes, name: str) -> Result:
    """The result of the case alone; it is worth all points, and nothing is measured.

    Raises:
        UsageError: the id belongs to no case of the session's problem, or the isolation cannot be had.
        JudgeError: the problem is broken, or nothing can be run here.
    """
    data = _one_case(replay, session.problem)
    settings = replace(session.settings, measured=False)
    with settings.box_factory(source, name) as box:
        judged = run_in(box, session.problem, data, source, name, settings=settings)
        result = replace(judged.result, levels=())  # one case says nothing of a level
        if judged.runner is not None:
            result = with_hurdle(result, judged.runner, box, source)
            if result.hurdle is None:
                result = with_printed(result, data, judged.runner, box)
    return result.noting(*session.containment.notes(result.isolation))


def _one_case(replay: str, problem: Problem) -> ProblemData:
    """The data of the id's case alone."""
    module = load_module(problem)
    group, case, answer = decode(replay, problem, module)
    target = target_of(problem, answer, group.tolerance)
    alone = replace(group, count=1, points=100)
    return ProblemData(problem, (GroupData(alone, [case], [target]),), module=module)
