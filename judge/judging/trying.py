"""A case of a person's own: its exact answer, what is accepted, and what a submission answers."""

from __future__ import annotations

from collections import Counter

from msgspec.structs import replace

from judge.data.build import target_of
from judge.data.model import GroupData, ProblemData
from judge.data.validate import Validator
from judge.errors import UsageError
from judge.judging.session import Session
from judge.problem import Case, Group, Problem, Tolerance, Verdict
from judge.problem.module import load_module
from judge.run.execute import opened
from judge.run.group import group_limits
from judge.run.hurdle import hurdle_of
from judge.run.printed import message_of, text_of
from judge.run.replies import VERDICTS
from judge.run.result import Failure, GroupResult, Result
from judge.run.runner import Runner
from judge.run.tried import Said, Tried
from judge.sandbox.boundary import Reply, Stop, Usage
from judge.values import show, wire
from judge.values.answers import Exact
from judge.values.check import Rejection

_SHOWN = 400  # characters of an answer


def try_case(problem: Problem, case: Case, group: str = "") -> Tried:
    """Prove and solve the case; the tolerance is the group's, or that of most where there is no such group.

    Raises:
        UsageError: the case breaks the bounds or the promise.
        ProblemError: the problem's own code fails on it.
    """
    module = load_module(problem)
    proof = Validator(problem, module.solve).proof(case)
    if proof.fault:
        what = proof.fault.replace("The ", "the ", 1) if proof.fault.startswith("The ") else proof.fault
        raise UsageError(f"Not a valid input: {what}", remedy=f"see judge show {problem.id}")
    alone = replace(problem.group(group) or _usual(problem), count=1, points=100)
    target = target_of(problem, proof.answer, alone.tolerance)
    data = ProblemData(problem, (GroupData(alone, [case], [target]),), module=module)
    return Tried(problem, case, alone, proof.answer, target, data)


def ask(session: Session, tried: Tried, source: bytes, name: str) -> Said:
    """What a submission answers to the case, called alone in a container.

    Raises:
        UsageError: the isolation that is asked for cannot be had.
        JudgeError: nothing can be run here.
    """
    with session.containment.take(source, name) as box:
        runner = opened(box, tried.problem, source)
        if isinstance(runner, Failure):
            return Said(name, Verdict.CE, "no answer", runner.message, box.isolation)
        replies = runner.answers(box, [tried.case], group_limits(tried.problem, tried.group, Usage()))
        broken = replies.breakdown
        if broken is not None:
            said = Said(name, broken.verdict, broken.got, broken.detail, box.isolation, runner.mode)
        else:
            said = _said(runner, tried, replies.replies[0], name, box.isolation)
        printed = text_of(replies.printed)
        if said.verdict is Verdict.AC:
            return replace(said, printed=printed)
        failure = runner.explained(Failure(message_of(said.message, said.got, printed)))
        group = GroupResult(name=tried.group.name, verdict=said.verdict, cases=1, passed=0)
        result = Result(
            problem=tried.problem.id,
            submission=name,
            verdict=said.verdict,
            groups=(group,),
            failure=failure,
        )
        hurdle = hurdle_of(result, runner, box.inspect(), source)
        return replace(said, message=failure.message, printed=printed, hurdle=hurdle)


def _said(runner: Runner, tried: Tried, reply: Reply, name: str, isolation: str) -> Said:
    if reply.stop is not Stop.ANSWERED:
        return Said(name, VERDICTS[reply.stop], "no answer", reply.detail, isolation, runner.mode)

    def exact() -> tuple[Exact, Tolerance]:
        return tried.exact, tried.group.tolerance

    outcome = runner.decide(reply.answer, tried.target, exact)
    given = runner.raw(reply.answer)
    if isinstance(outcome, Rejection):
        return Said(name, Verdict.WA, outcome.got, outcome.message, isolation, runner.mode, given)
    shown = show.shown(tried.problem.answer, given) if runner.calls else wire.quoted(reply.answer)[1:-1]
    return Said(name, Verdict.AC, shown[:_SHOWN], "", isolation, runner.mode, given)


def _usual(problem: Problem) -> Group:
    """A group that has the tolerance of most."""
    usual = Counter(group.tolerance for group in problem.groups).most_common(1)[0][0]
    return next(group for group in problem.groups if group.tolerance == usual)
