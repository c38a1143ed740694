"""`judge hint` and `judge solution`: one more hint; the model solution, once it is solved or given up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import click
from msgspec import Struct

from judge.cli.options import Common, command, opt
from judge.cli.resolve import history_at, kata_meant
from judge.errors import UsageError
from judge.languages import language_of
from judge.practice.events import Help, Run
from judge.practice.model import approaches, chosen_approach
from judge.problem import Problem
from judge.problem.hints import read_hints
from judge.report.published_practice import ApproachRow, HintShown, SolutionShown, Yours
from judge.run.result import Taken

_ROUNDS = 3


class HintAsk(Struct, frozen=True):
    """Which hint."""

    again: bool = opt("--again", "Repeat the last one.")
    step: int | None = opt("--step N", "Show hint N; the first is 1.")
    whole: bool = opt("--all", "Show all hints.")


@command("hint", HintShown, ask=HintAsk)
@click.argument("name", metavar="[KATA|FILE]", required=False)
def hint(name: str | None, ask: HintAsk, common: Common) -> Iterator[HintShown]:
    """Give one more hint.

    The hint is for that kata, for the kata of a file, or for your current kata. The first hint is a nudge,
    the last is nearly the whole solution. The judge remembers which ones you have seen.
    """
    if ask.again + ask.whole + (ask.step is not None) > 1:
        raise UsageError("--again, --step and --all exclude each other", remedy="name one of them")
    chosen = hints(kata_meant(name, common), ask, common.db)
    try:
        note_seen(chosen[-1], common.db)  # first: what was shown counts as seen, whatever happens then
    finally:
        yield from chosen


def hints(problem: Problem, ask: HintAsk, db: Path | None) -> list[HintShown]:
    """The hints that are asked for, at least one: the first that was not seen, or else the last.

    Raises UsageError where there is none, ProblemError where they are broken.
    """
    found = read_hints(problem)
    if not found:
        remedy = f"'judge show {problem.id} --groups' says what its test groups show"
        raise UsageError(f"there are no hints to {problem.id}", remedy=remedy)
    seen, count = 0 if ask.whole or ask.step is not None else _seen(problem.id, db), len(found)
    if ask.again and not seen:
        raise UsageError(f"You have seen no hint to {problem.id} yet", remedy=f"judge hint {problem.id}")
    step = ask.step if ask.step is not None else min(seen if ask.again else seen + 1, count)
    if not 1 <= step <= count:
        raise UsageError(f"{problem.id} has no hint {step}", remedy=f"they go from 1 to {count}")
    return [
        HintShown(problem=problem.id, step=each.number, steps=count, title=each.title, text=each.text)
        for each in found
        if ask.whole or each.number == step
    ]


def _seen(problem: str, db: Path | None) -> int:
    """How many of the kata's hints have been seen."""
    with history_at(db, reading=True) as history:
        return max((each.hints for each in history.events(Help, problem)), default=0)


def note_seen(hint: HintShown, db: Path | None) -> None:
    """Remember that the hints up to this one have been seen."""
    if hint.step > _seen(hint.problem, db):
        with history_at(db) as history:
            history.keep(Help(hint.problem, hint.step))


class SolutionAsk(Struct, frozen=True):
    """Which solution, and whether to measure."""

    giving_up: bool = opt("--give-up", "Show it before you have solved the kata; this is remembered.")
    language: str | None = opt("--language L", "The one in this language: go, cpp, java …")
    times: bool = opt("--times", "Measure all approaches and yours, in each language; takes a minute.")
    rounds: int | None = opt("--rounds N", f"Measure N times, not {_ROUNDS}.", type=click.IntRange(1, 99))


@command("solution", SolutionShown, ask=SolutionAsk)
@click.argument("name", metavar="[KATA", required=False)
@click.argument("approach", metavar="[APPROACH]]", required=False)
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
    programs = [(each.path.name, each.source) for each in models]
    if yours:
        programs.append((yours[0].submission, yours[1]))
    taken: Sequence[Taken | None] = [None] * len(programs)
    if ask.times:
        taken = _measured(problem, programs, ask.rounds or _ROUNDS, common)
    return SolutionShown(
        problem=problem.id,
        file=model.path.name,
        language=model.tongue,
        code=model.language.id if model.language else "python",
        idea=model.idea,
        explanation=model.explanation,
        program=model.program,
        approaches=tuple(
            ApproachRow(each.name, each.call, each.path.name, each.tongue, each.about, its)
            for each, its in zip(models, taken, strict=False)
        ),
        yours=Yours(yours[0].id, yours[0].submission, taken[-1]) if yours else None,
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
