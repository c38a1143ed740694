"""`judge hint` and `judge solution`: one more hint; the model solution, once it is solved or given up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
from msgspec import Struct

from judge.cli.hints import hints_of, hints_seen, next_hint, note_seen
from judge.cli.kept import history_at
from judge.cli.options import Common, command, opt, takes
from judge.cli.resolve import kata_meant
from judge.errors import UsageError
from judge.languages import language_of
from judge.practice.events import Help
from judge.practice.solutions import approaches, chosen_approach
from judge.problem import Problem
from judge.report.published_practice import ApproachRow, HintShown, SolutionShown, Yours

if TYPE_CHECKING:
    from judge.practice.events import Run
    from judge.run.result import Taken

_ROUNDS = 3


class HintAsk(Struct, frozen=True):
    """Which hint."""

    again: Annotated[bool, opt("--again", help="Repeat the last one.")] = False
    step: Annotated[int | None, opt("--step", metavar="N", help="Show hint N; the first is 1.")] = None
    whole: Annotated[bool, opt("--all", help="Show all hints.")] = False


@command("hint", HintShown)
@click.argument("name", metavar="[KATA|FILE]", required=False)
@takes(HintAsk, "ask")
def hint(name: str | None, ask: HintAsk, common: Common) -> Iterator[HintShown]:
    """Give one more hint.

    The hint is for that kata, for the kata of a file, or for your current kata. The first hint is a nudge,
    the last is nearly the whole solution. The judge remembers which ones you have seen.
    """
    if ask.again + ask.whole + (ask.step is not None) > 1:
        raise UsageError("--again, --step and --all exclude each other", remedy="name one of them")
    problem = kata_meant(name, common)
    chosen = _chosen(problem, ask, common.db)
    try:
        note_seen(chosen[-1], common.db)  # first: what was shown counts as seen, whatever happens then
    finally:
        yield from chosen


def _chosen(problem: Problem, ask: HintAsk, db: Path | None) -> Sequence[HintShown]:
    """The hints that were asked for, at least one. Raises UsageError."""
    hints = hints_of(problem)
    if ask.whole:
        return hints
    step = ask.step
    if ask.again:
        step = min(hints_seen(problem.id, db), len(hints))
        if not step:
            raise UsageError(f"You have seen no hint to {problem.id} yet", remedy=f"judge hint {problem.id}")
    if step is None:
        return [next_hint(problem, db)]
    if not 1 <= step <= len(hints):
        raise UsageError(f"{problem.id} has no hint {step}", remedy=f"they go from 1 to {len(hints)}")
    return [hints[step - 1]]


class SolutionAsk(Struct, frozen=True):
    """Which solution, and whether to measure."""

    giving_up: Annotated[
        bool, opt("--give-up", help="Show it before you have solved the kata; this is remembered.")
    ] = False
    language: Annotated[
        str | None, opt("--language", metavar="L", help="The one in this language: go, cpp, java …")
    ] = None
    times: Annotated[
        bool, opt("--times", help="Measure all approaches and yours, in each language; takes a minute.")
    ] = False
    rounds: Annotated[
        int | None,
        opt("--rounds", type=click.IntRange(1, 99), metavar="N", help=f"Measure N times, not {_ROUNDS}."),
    ] = None


@command("solution", SolutionShown)
@click.argument("name", metavar="[KATA", required=False)
@click.argument("approach", metavar="[APPROACH]]", required=False)
@takes(SolutionAsk, "ask")
def solution(name: str | None, approach: str | None, ask: SolutionAsk, common: Common) -> SolutionShown:
    """Show the model solution, and why it works.

    Without KATA: that of your current kata. It is shown once yours is accepted, or with --give-up; the kata
    then comes back sooner. Below it are the other approaches by name.

    With --times you see what each approach takes for one case, beside the first one and your own.
    """
    if ask.rounds and not ask.times:
        raise UsageError("--rounds goes with --times", remedy="add --times")
    problem = kata_meant(name, common)
    models = approaches(problem)
    model = chosen_approach(problem, models, approach, ask.language)
    yours = _admit(problem, common.db, giving_up=ask.giving_up)
    programs = [(each.file, each.solution.source) for each in models]
    programs += [(yours[0].submission, yours[1])] if yours else []
    taken = (
        _measured(problem, programs, ask.rounds or _ROUNDS, common) if ask.times else [None] * len(programs)
    )
    return SolutionShown(
        problem=problem.id,
        file=model.file,
        language=model.tongue,
        code=model.solution.language.id if model.solution.language else "python",
        idea=model.solution.name,
        explanation=model.solution.text,
        program=model.program,
        approaches=tuple(
            ApproachRow(
                name=each.name,
                call=each.call,
                file=each.file,
                language=each.tongue,
                about=each.solution.sentence,
                taken=its,
            )
            for each, its in zip(models, taken, strict=False)
        ),
        yours=Yours(run=yours[0].id, file=yours[0].submission, taken=taken[-1]) if yours else None,
    )


def _measured(
    problem: Problem, programs: Sequence[tuple[str, bytes]], rounds: int, common: Common
) -> Sequence[Taken]:
    """What each program takes for a case; why not, where its language is not installed."""
    from judge.judging.api import RunOptions
    from judge.judging.session import Session
    from judge.languages.find import why_not
    from judge.report.wait import progress
    from judge.run.times import Program, measure

    entries = []
    for name, source in programs:
        language = language_of(name)
        missing, warms = (why_not(language), language.factor > 1) if language else ("", False)
        entries.append(Program(name, source, missing, warms))
    with Session(problem, RunOptions(isolation=common.isolation, timed=False), bars=progress) as session:
        data = session.data
        with progress("measuring") as advance:
            return measure(data, entries, session.open_box, rounds, advance)


def _admit(problem: Problem, db: Path | None, *, giving_up: bool) -> tuple[Run, bytes] | None:
    """The person's latest run that solved it, and its source; None where it was given up, which is noted.

    Raises UsageError where it is neither.
    """
    with history_at(db, reading=not giving_up) as history:
        solved = [run for run in history.runs(problem.id) if run.solved]
        if solved:
            return solved[-1], history.source(solved[-1].id)
        if any(each.gave_up for each in history.events(Help, problem.id)):
            return None
        if giving_up:
            history.keep(Help(problem.id, hints=0))
            return None
    raise UsageError(f"Solve {problem.id} first", remedy="or see it anyway: add --give-up")
