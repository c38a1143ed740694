"""`judge run`: judge files once, or on fresh cases until the time is up."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Generator, Iterator, Sequence
from contextlib import closing
from pathlib import Path

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.files import OutFile, SubmissionFile, Unjudged
from judge.cli.options import Common, command, opt, seconds_of
from judge.cli.resolve import Tasks, resolve
from judge.errors import UsageError, told
from judge.judging import RunOptions
from judge.problem import Problem
from judge.problem.model import LEVELS, chosen_groups
from judge.report.published_result import RunReport, Several
from judge.report.screen import Notes, is_terminal, note
from judge.report.wait import progress, stages
from judge.run.result import Result, judge_fault

_SEEDS = 10**9  # a fresh seed is below it: short enough to be typed again
TEXT, GITHUB, EDITOR = FORMATS = ("text", "github", "editor")


class RunAsk(Struct, frozen=True):
    """What to run, and what to show of it; the hidden ones are for scripts."""

    quiet: bool = opt("-q --quiet", "Only the verdicts, one line for each file.")
    whole: bool = opt("--all", "Show every test group.")
    level: str | None = opt("--level", "Only this level.", choices=LEVELS)
    groups: tuple[str, ...] = opt("--group G", "Only this group; repeatable.", default=())
    jobs: int = opt("-j --jobs N", "Judge N files at once.", type=click.IntRange(1, 256), default=1)
    fresh: float | None = opt("--fresh --for TIME", "Judge on new cases, for 30s or 2m.", type=seconds_of)
    form: str = opt(
        "--format", "github: annotations; editor: lines like a compiler's.", choices=FORMATS, default=TEXT
    )
    junit: Path | None = opt("--junit FILE", "Also write the results as JUnit XML.")
    seed: int | None = opt("--seed N", "Cases of this seed.", hidden=True)
    mode: str | None = opt("--mode", "program: run it as one.", hidden=True, choices=("program", "auto"))
    unnamed: bool = opt("--no-name", "Do not name the mistake.", hidden=True)
    unshrunk: bool = opt("--no-shrink", "Seek no smaller case.", hidden=True)
    unrecorded: bool = opt("--no-history", "Keep nothing of it.", hidden=True)

    def is_plain(self, common: Common) -> bool:
        """Whether only a person reads what is shown."""
        return self.form == TEXT and self.junit is None and not common.json

    def options(self, common: Common) -> RunOptions:
        """How to judge; who sees only verdicts waits neither for a smallest case nor for a name."""
        brief = self.quiet and self.is_plain(common)
        return RunOptions(
            self.groups,
            self.seed,
            common.isolation,
            diagnosed=not (self.unshrunk or brief),
            named=not (self.unnamed or brief),
            level=self.level,
            program=self.mode == "program",
        )


@command("run", Result, ask=RunAsk)
@click.argument("words", metavar="[KATA] [FILE]...", nargs=-1)
def run(words: tuple[str, ...], ask: RunAsk, common: Common) -> Iterator[Struct]:
    """Judge files once.

    Without words, it is the file of your current kata. The kata of a FILE is found by the function in it, the
    first line of its stub, its name, or its folder in solutions/. A folder stands for every *.py in it. A
    file that does not define the kata's function is run as a program that reads standard input.

    With --fresh, new cases are drawn until the time is up or one fails. Ctrl-C keeps what was found.

    Exit status: 0 all accepted, 1 not accepted, 2 usage, 3 a fault of the judge or of a kata.
    """
    if common.json and ask.form != TEXT:
        raise UsageError(f"--json and --format {ask.form} contradict each other", remedy="leave one out")
    junit = OutFile(ask.junit, "--junit", "JUnit XML", lambda start: b"<testsuite" in start)
    tasks, unjudged = resolve(words, common)
    total = len(unjudged) + sum(len(submissions) for _, submissions in tasks)
    for problem, _ in tasks:
        chosen_groups(problem, ask.groups, ask.level)  # a name that is none is told before all else
    if ask.fresh is not None:
        if total > 1 or unjudged:
            raise UsageError("--fresh takes one file", remedy="name one FILE")
        yield from _fresh(*tasks[0], ask, common)
        return
    found: list[Result] = []
    pressed: KeyboardInterrupt | None = None
    try:
        with closing(_judged(tasks, unjudged, ask, common)) as rows:
            for row in rows:
                found.append(row.result)
                yield row if ask.form == TEXT else replace(row, plain=_lines(row, ask.form))
    except KeyboardInterrupt as ctrl_c:
        pressed = ctrl_c
    finally:
        if junit.path is not None and found:
            from judge.report.formats import junit as written

            junit.write(written(found))
    if total > 1 and found and ask.form == TEXT:
        yield Several(tuple(found), total - len(found))
    if pressed:
        raise pressed


def _lines(judged: RunReport, form: str) -> str:
    """The result as another program reads it."""
    from judge.report.formats import annotation, editor_lines

    asked = judged.result, judged.source, judged.data.problem if judged.data else None
    lines = editor_lines(*asked) if form == EDITOR else (annotation(*asked, os.environ),)
    return "".join(f"{line}\n" for line in lines)


def _judged(
    tasks: Tasks, unjudged: Sequence[Unjudged], ask: RunAsk, common: Common
) -> Generator[RunReport, None, None]:
    """Every result in order, one kata after another; last what could not be read or has no kata.

    Of several katas, one that is broken costs its own submissions only. What ends the judging of a single one
    is also the result of each submission that is left, for whoever reads the results as data.
    """
    from judge.cli.judging import Wish, judged, with_standing
    from judge.judging.session import Session

    plain, done = ask.is_plain(common), 0
    total = len(unjudged) + sum(len(submissions) for _, submissions in tasks)
    wish = Wish(ask.jobs, kept=not ask.unrecorded, db=common.db, total=total)
    several = len(tasks) if total > 1 else 0
    whole = is_terminal(sys.stdout) and not (several or ask.quiet or common.json or ask.unrecorded)
    for problem, submissions in tasks:
        left = list(submissions)
        try:
            with (
                Session(problem, ask.options(common)) as session,
                closing(judged(session, submissions, replace(wish, before=done))) as results,
            ):
                for found in results:
                    left.pop(0)
                    row = replace(found, several=several, quiet=ask.quiet, whole=ask.whole)
                    yield with_standing(row, common) if whole else row
                    if plain and not (common.isolation or ask.quiet):
                        _say_that_full_is_missing(row.result)
        except Exception as fault:
            if isinstance(fault, UsageError | OSError) or (plain and len(tasks) == 1):
                raise
            for each in left:
                yield RunReport(judge_fault(problem.id, each.name, told(fault)), each.source, several=several)
            if len(tasks) == 1:
                raise
        done += len(submissions)
    for entry in unjudged:
        yield RunReport(judge_fault(entry.problem, entry.name, entry.why), several=several)


def _fresh(
    problem: Problem, submissions: list[SubmissionFile], ask: RunAsk, common: Common
) -> Iterator[RunReport]:
    """One submission on new cases for so long. Raises KeyboardInterrupt if that ended it and none failed."""
    import random

    from judge.data import ProblemData
    from judge.judging.cases import judge_fresh
    from judge.judging.session import Session

    (submission,), lasting = submissions, ask.fresh or 0.0
    seed = random.randrange(_SEEDS) if ask.seed is None else ask.seed
    groups = chosen_groups(problem, ask.groups, ask.level)
    options = replace(ask.options(common), seed=None, timed=False)
    with Session(problem, options, bars=progress) as session, stages(Path(submission.name).name) as stage:

        def tell(cases: int, spent: float) -> None:
            if stage:
                whole = math.ceil(lasting)
                stage(f"{cases:,} cases, {cases / spent:,.0f} a second", min(int(spent), whole), whole)

        stressed = judge_fresh(
            session, submission.source, submission.name, groups, seed=seed, seconds=lasting, on_cases=tell
        )
    result = stressed.result
    again = f"{stressed.cases:,} fresh cases in {stressed.seconds:.0f} s; the same again: --seed {seed}"
    Notes().say(result.notes)
    data, noted = ProblemData(problem, ()), result.noting(again)
    yield RunReport(noted, submission.source, data, quiet=ask.quiet, whole=ask.whole, fresh=again)
    if stressed.interrupted and result.failure is None:
        raise KeyboardInterrupt


def _say_that_full_is_missing(result: Result) -> None:
    """Once a day, to a person who has not been told so by `judge doctor`."""
    from judge.judging.containment import first_today, kept_level

    if result.isolation == "strong" and is_terminal(sys.stderr) and kept_level() is None and first_today():
        note("Sandbox: strong, not full. Why: judge doctor")
