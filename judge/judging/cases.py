"""A case of a person's own, answered and asked; one that breaks a wrong program; fresh cases without end."""

from __future__ import annotations

import re
from collections.abc import Sequence

from msgspec.structs import replace

from judge.data import ProblemData
from judge.data.build import Fresh, target_of, validate
from judge.errors import UsageError
from judge.judging import RunOptions
from judge.judging.session import NAMED, Bars, Session
from judge.languages import file_name
from judge.mistakes.puzzles import WrongProgram, usual_group
from judge.problem import Case, Group, Problem, Verdict
from judge.problem.declare import InvalidCase, lenient
from judge.problem.model import case_of
from judge.problem.module import load_module
from judge.problem.solutions import accepted_source
from judge.run.entry import entry_error
from judge.run.execute import Judgement, judge_submission, opened
from judge.run.group import group_limits
from judge.run.printed import message_of, text_of
from judge.run.result import Failure, GroupResult, Result, short_answer
from judge.run.runner import VERDICTS, Replies, Runner
from judge.run.stress import OnCases, Stressed, stress
from judge.run.tried import CaseResult, OneCase
from judge.sandbox.boundary import Stop
from judge.values import show, wire
from judge.values.check import Rejection
from judge.values.wire import Raw

_SHOWN = 400  # characters of an answer
_NAME = file_name("program")  # what a wrong program is called in a message


def try_case(problem: Problem, case: Case, group: str = "") -> OneCase:
    """Prove and solve the case; the tolerance is the group's, or that of most where there is no such group.

    Raises:
        UsageError: the case breaks the bounds, or has no answer.
        ProblemError: the problem's own code fails on it.
    """
    module = load_module(problem)
    try:
        with lenient() as broken:
            exact = validate(problem, module, case)
    except InvalidCase as fault:
        what = re.sub("^The ", "the ", str(fault))
        raise UsageError(f"Not a valid input: {what}", remedy=f"see judge show {problem.id}") from None
    judged_by = problem.group(group) or usual_group(problem)
    target = target_of(problem, exact, judged_by.tolerance)
    return OneCase(problem, case, judged_by, exact, target, module, broken=broken[0] if broken else "")


def ask(session: Session, tried: OneCase, source: bytes, name: str) -> CaseResult:
    """What a submission answers to the case, called alone in a container.

    Raises:
        UsageError: the isolation that is asked for cannot be had.
        JudgeError: nothing can be run here.
    """
    with session.take(source, name) as box:
        runner = opened(box, tried.problem, source)
        if isinstance(runner, Failure):
            return CaseResult(name, Verdict.CE, "no answer", runner.message, box.isolation)
        replies = runner.ask(box, [tried.case], group_limits(tried.problem, tried.group))
        verdict, got, message, given = _answer(runner, tried, replies)
        printed = text_of(replies.printed)
        if tried.problem.talks:
            printed = runner.explained(Failure("", input=tried.problem.named(tried.case))).shown
        said = CaseResult(
            name, verdict, got, message, box.isolation, runner.mode, short_answer(given), printed
        )
        if verdict is Verdict.AC:
            return said
        failure = runner.explained(Failure(message_of(message, got, printed)))
        group = GroupResult(name=tried.group.name, verdict=verdict, cases=1, passed=0)
        result = Result(
            problem=tried.problem.id, submission=name, verdict=verdict, groups=(group,), failure=failure
        )
        hurdle = entry_error(result, runner, box.inspect(), source)
        return replace(said, message=failure.message, hurdle=hurdle)


def _answer(runner: Runner, tried: OneCase, replies: Replies) -> tuple[Verdict, str, str, Raw]:
    """The verdict on what came of one call, the answer in words, why it is rejected, the answer itself."""
    broken = replies.breakdown
    if broken is not None:
        return broken.verdict, broken.got, broken.detail, None
    reply = replies.replies[0]
    if reply.stop is not Stop.ANSWERED:
        return VERDICTS[reply.stop], "no answer", reply.detail, None
    outcome = runner.decide(reply.answer, tried.target, lambda: (tried.exact, tried.group.tolerance))
    given = runner.raw(reply.answer)
    if isinstance(outcome, Rejection):
        return Verdict.WA, outcome.got, outcome.message, given
    if runner.calls or tried.problem.formatted:
        return Verdict.AC, show.shown(tried.problem.answer, given)[:_SHOWN], "", given
    return Verdict.AC, wire.quoted(reply.answer)[1:-1][:_SHOWN], "", given


def hack(session: Session, puzzle: WrongProgram, tried: OneCase) -> tuple[CaseResult, str]:
    """What the puzzle's program answers to the case, and why that does not break it; "" where it does.

    Raises as `ask`.
    """
    said = ask(session, tried, puzzle.source, _NAME)
    if said.verdict is Verdict.AC:
        return said, "the program answers this case correctly"
    rule = tried.problem.time
    if puzzle.special and rule and rule.function:
        model = accepted_source(tried.problem, rule.function)
        if model is not None and ask(session, tried, model, _NAME).verdict is Verdict.WA:
            return said, f"with the tolerance of {puzzle.group.name}, a right program fails this case too"
    return said, ""


def smallest(problem: Problem, puzzle: WrongProgram, isolation: str | None, bars: Bars) -> OneCase | None:
    """A smallest case that breaks the program, with what it says to it; None where none of its group does.

    Raises as `ask`.
    """
    options = RunOptions(groups=(puzzle.group.name,), isolation=isolation, timed=False, named=False)
    with Session(problem, options, bars=bars) as session:
        result = session.judge(puzzle.source, _NAME)
        found = result.counterexample
        shown = found if found is not None and found.replay else result.failure
        if shown is None or shown.input is None:
            return None
        tried = try_case(problem, case_of(shown.input), puzzle.group.name)
        return replace(tried, said=ask(session, tried, puzzle.source, _NAME))


def judge_fresh(
    session: Session,
    source: bytes,
    name: str,
    groups: Sequence[Group],
    *,
    seed: int,
    seconds: float,
    on_cases: OnCases | None = None,
) -> Stressed:
    """Judge a submission on fresh cases of the groups, from that seed and for so long; explain what breaks.

    The session's options say whether that is shrunk and named. Ctrl-C ends it early; what broke by then is
    kept. Raises JudgeError.
    """
    problem, options = session.problem, session.options
    session.boot(source, name)
    module = load_module(problem)  # while the box boots
    fresh = Fresh(problem, module, groups, seed)
    with session.take(source, name) as box:
        data = ProblemData(problem, (), loaded=module)
        stressed = stress(
            data, fresh, box, source, name, seconds=seconds, on_cases=on_cases, lock=session.lock
        )
        result, broken, runner = stressed.result, stressed.broken, stressed.runner
        if broken is not None and runner is not None:
            result = replace(result, hurdle=entry_error(result, runner, box.inspect(), source))
            if result.hurdle is not None:
                return replace(stressed, result=result)
            try:
                if options.diagnosed:
                    series = broken.series
                    failed = session.diagnosed(
                        Judgement(replace(result, failure=broken.failure), runner, {}),
                        ProblemData(problem, (series,), loaded=module),
                        box,
                    )
                    result = replace(failed, failure=result.failure)
                if options.named and result.verdict in NAMED:
                    pinned = judge_submission(session.data, source, name, session.untimed)
                    named = session.named(pinned, source, box)
                    result = replace(result, pitfall=named.pitfall).noting(*named.notes)
            except KeyboardInterrupt:  # what broke is known, and worth more than the rest
                stressed = replace(stressed, interrupted=True)
        return replace(stressed, result=result.noting(*session.notes(box.isolation)))
