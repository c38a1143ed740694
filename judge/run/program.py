"""Program mode: the submission reads a whole group from stdin and writes a line for each case.

T                      number of cases
cx cy r ax ay bx by    the parameters in order, floats as `repr`; T such lines
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from judge.problem import Argument, Case, Verdict
from judge.run.budget import Budget
from judge.run.group import VERDICTS, GroupRun, group_limits
from judge.sandbox import Box, ProgramResult, Stop

SHOWN = 80  # characters of a line that is quoted
SEARCHED_SECONDS = 1.0  # the longest run that is worth repeating to find the case it breaks at


def render_group(cases: Sequence[Case]) -> bytes:
    """The standard input of a program that is judged on these cases."""
    lines = [str(len(cases)), *(" ".join(_numbers(case)) for case in cases)]
    return ("\n".join(lines) + "\n").encode("ascii")


def _numbers(arguments: Iterable[Argument]) -> Iterator[str]:
    for argument in arguments:
        if isinstance(argument, (tuple, list)):
            yield from _numbers(argument)
        else:
            yield repr(argument)


def answer_lines(stdout: bytes, *, complete: bool) -> list[str]:
    """The lines of an output, without blank ones at its end.

    Bytes that are not ASCII become characters that no answer holds. Where the output is not `complete`, an
    unfinished last line is left out: it may be half a number.
    """
    text = stdout.decode("ascii", errors="replace").replace("\r\n", "\n")
    *lines, rest = text.split("\n")
    if complete:
        lines.append(rest)
    while lines and not lines[-1].strip(" \t"):
        lines.pop()
    return lines


def judge_programs(
    box: Box,
    tallies: Sequence[GroupRun],
    *,
    budget: Budget,
    on_calls: Callable[[GroupRun], None],
    on_group: Callable[[GroupRun], None],
) -> None:
    """Run the program once for each group; arguments as those of `judge_calls`."""
    for tally in tallies:
        if budget.over:
            return
        judge_program(box, tally, budget)
        on_calls(tally)
        on_group(tally)


def judge_program(box: Box, tally: GroupRun, budget: Budget) -> None:
    """Run the program once on the whole group and compare it line by line."""
    from judge.compare.text import check_line

    problem, cases = tally.problem, tally.group.cases
    result = box.run_program(render_group(cases), budget.within(group_limits(problem, tally.usage)))
    result = result._replace(detail=budget.told(result.stop, result.detail))
    tally.usage += result.usage
    # An exit status of its own is no loss: that costs nothing, and many a program has one.
    budget.spent(result.usage, Stop.EXCEPTION if result.stop is Stop.EXITED else result.stop)
    complete = result.stop is Stop.ANSWERED
    if result.stop is Stop.OUTPUT:  # the lines of a flood are wrong too, or too many: that says less
        tally.failed(0, VERDICTS[result.stop], result.detail)
    lines = answer_lines(result.stdout, complete=complete)
    surplus = lines[len(cases) :]
    compared = lines[: len(cases) - bool(surplus)]
    for index, line in enumerate(compared):
        outcome = check_line(problem.answer, line, tally.group.targets[index], tally.exact(index))
        tally.compared(index, outcome, line)
    tally.reached = len(compared)
    if surplus:
        message = f"{_counted(len(lines), 'line')} printed, {len(cases)} wanted: one for each case"
        tally.failed(len(cases) - 1, Verdict.WA, message, f"more lines: {surplus[0][:SHOWN]!r}")
    elif complete and len(lines) < len(cases):
        message = f"{_counted(len(lines), 'line')} printed, {len(cases)} wanted: one for each case"
        tally.failed(len(lines), Verdict.WA, message, "no line")
    if not complete:
        _stopped(box, tally, result, len(lines), budget)


def _stopped(box: Box, tally: GroupRun, result: ProgramResult, printed: int, budget: Budget) -> None:
    """Record a run that did not end well; its time, memory or output belong to no case in particular."""
    if tally.failure is not None:
        return
    count = len(tally.group.cases)
    index = min(printed, count - 1)
    message = f"{result.detail}, after {_counted(printed, 'line')} of {count}"
    if result.stop in (Stop.EXCEPTION, Stop.EXITED) and result.usage.wall_seconds < SEARCHED_SECONDS:
        culprit = _culprit(box, tally, budget)
        if culprit is not None:
            tally.stopped(culprit, result.stop, result.detail)
            return
    tally.failed(index, VERDICTS[result.stop], message)


def _culprit(box: Box, tally: GroupRun, budget: Budget) -> int | None:
    """The case at which the program breaks, found by halving, or None where it breaks without any.

    What it had printed may still have been in its buffer, so the lines that arrived do not tell. None, too,
    where the search takes too long.
    """
    cases = tally.group.cases
    limits = group_limits(tally.problem, tally.usage)
    limits = limits._replace(
        cpu_seconds=min(limits.cpu_seconds, 2 * SEARCHED_SECONDS),
        wall_seconds=min(limits.wall_seconds, 2 * SEARCHED_SECONDS),
    )

    def breaks(count: int) -> bool:
        result = box.run_program(render_group(cases[:count]), budget.within(limits))
        budget.searched(result.usage)
        return result.stop is not Stop.ANSWERED

    if not budget.may_search() or breaks(0):
        return None
    good, bad = 0, len(cases)
    while bad - good > 1:
        if not budget.may_search():
            return None
        middle = (good + bad) // 2
        good, bad = (good, middle) if breaks(middle) else (middle, bad)
    return bad - 1


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
