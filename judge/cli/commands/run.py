"""`judge run`: judge files once, or on fresh cases until the time is up."""

from __future__ import annotations

import math
import os
import random
import sys
from collections.abc import Generator, Iterator, Sequence
from contextlib import closing, nullcontext, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.duration import seconds_of
from judge.cli.options import Common, command, opt, takes
from judge.cli.resolve import Task, resolve
from judge.cli.submissions import Unjudged
from judge.cli.target import OutFile, check_svg
from judge.cli.wish import Wish
from judge.errors import ExitCode, JudgeError, UsageError, told
from judge.judging.api import RunOptions
from judge.problem.model import LEVELS, chosen_groups
from judge.report.judged import AtLines, Judged, Several
from judge.run.result import Result, judge_fault

if TYPE_CHECKING:
    from judge.cli.picture import Drawing

_SEEDS = 10**9  # a fresh seed is below it: short enough to be typed again
TEXT, GITHUB, EDITOR = FORMATS = ("text", "github", "editor")


class RunAsk(Struct, frozen=True):
    """What to run, and what to show of it; the hidden ones are for scripts."""

    quiet: Annotated[bool, opt("-q", "--quiet", help="Only the verdicts, one line a file.")] = False
    whole: Annotated[bool, opt("--all", help="Show every test group.")] = False
    level: Annotated[
        str | None,
        opt("--level", type=click.Choice(LEVELS), metavar="|".join(LEVELS), help="Only this level."),
    ] = None
    groups: Annotated[tuple[str, ...], opt("--group", metavar="G", help="Only this group; repeatable.")] = ()
    jobs: Annotated[
        int,
        opt("-j", "--jobs", type=click.IntRange(1, 256), metavar="N", help="Judge N files at once."),
    ] = 1
    fresh: Annotated[
        str | None,
        opt("--fresh", "--for", metavar="TIME", help="Judge on new cases for so long, such as 30s or 2m."),
    ] = None
    form: Annotated[
        str,
        opt(
            "--format",
            metavar="|".join(FORMATS),
            type=click.Choice(FORMATS),
            help="github: annotations; editor: lines as compilers write them.",
        ),
    ] = TEXT
    junit: Annotated[
        Path | None, opt("--junit", metavar="FILE", help="Also write the results as JUnit XML.")
    ] = None
    seed: Annotated[int | None, opt("--seed", metavar="N", help="Cases of this seed.", hidden=True)] = None
    mode: Annotated[
        str,
        opt("--mode", type=click.Choice(("program", "auto")), help="program: run it as one.", hidden=True),
    ] = "auto"
    svg: Annotated[
        Path | None, opt("--svg", metavar="FILE", help="Draw the failing case into this file.", hidden=True)
    ] = None
    unnamed: Annotated[bool, opt("--no-name", help="Do not name the mistake.", hidden=True)] = False
    unshrunk: Annotated[bool, opt("--no-shrink", help="Seek no smaller case.", hidden=True)] = False
    unrecorded: Annotated[bool, opt("--no-history", help="Keep nothing of it.", hidden=True)] = False

    def options(self, isolation: str | None, *, brief: bool) -> RunOptions:
        """How to judge; who sees only verdicts waits neither for a smallest case nor for a name."""
        return RunOptions(
            self.groups,
            self.seed,
            isolation,
            diagnosed=not (self.unshrunk or (brief and self.svg is None)),
            named=not (self.unnamed or brief),
            level=self.level,
            program=self.mode == "program",
        )


@command("run", Result)
@click.argument("words", metavar="[KATA] [FILE]...", nargs=-1)
@takes(RunAsk, "ask")
def run(words: tuple[str, ...], ask: RunAsk, common: Common) -> Iterator[Struct]:
    """Judge files once.

    Without words: the file of your current kata. A FILE says its kata by its function, the first line of its
    stub, its name, or its folder in solutions/; a folder stands for every *.py in it. A file that does not
    define the kata's function is run as a program that reads standard input.

    With --fresh, new cases are drawn until the time is up or one fails. Ctrl-C keeps what was found.

    Exit status: 0 all accepted, 1 not accepted, 2 usage, 3 a fault of the judge or of a kata.
    """
    if common.json and ask.form != TEXT:
        raise UsageError(f"--json and --format {ask.form} contradict each other", remedy="leave one out")
    junit = (
        OutFile(ask.junit, "--junit", "JUnit XML", lambda start: b"<testsuite" in start)
        if ask.junit
        else None
    )
    if junit is not None:
        junit.check()
    tasks, unjudged = resolve(words, common)
    total = len(unjudged) + sum(len(task.submissions) for task in tasks)
    if ask.svg is not None:
        check_svg(ask.svg, total)
    for task in tasks:
        chosen_groups(task.problem, ask.groups, ask.level)  # a name that is none is told before all else
    if ask.fresh is not None:
        if total > 1 or unjudged:
            raise UsageError("--fresh takes one file", remedy="name one FILE")
        yield _fresh(tasks[0], ask, common)
        return
    found: list[Result] = []
    results = _judged(tasks, unjudged, total, ask, common)
    try:
        with closing(results):
            for each in results:
                found.append(each.result)
                yield _as(each, ask.form)
    except KeyboardInterrupt:
        yield from _several(found, total, ask)
        raise
    finally:
        if junit is not None and found:
            from judge.report.formats import junit as written

            junit.write(written(found))
    yield from _several(found, total, ask)


def _several(found: Sequence[Result], total: int, ask: RunAsk) -> Iterator[Several]:
    """What several submissions came to."""
    if total > 1 and found and ask.form == TEXT:
        yield Several(tuple(found), total - len(found))


def _as(judged: Judged, form: str) -> Struct:
    """The result as it is to be shown."""
    if form == TEXT:
        return judged
    from judge.report.formats import annotation, editor_lines

    entry = judged.problem.entry if judged.problem else ""
    if form == EDITOR:
        lines = editor_lines(judged.result, judged.source, entry)
    else:
        lines = iter((annotation(judged.result, judged.source, entry, os.environ),))
    return AtLines("".join(f"{line}\n" for line in lines), judged.result.exit_code)


def _judged(
    tasks: Sequence[Task], unjudged: Sequence[Unjudged], total: int, ask: RunAsk, common: Common
) -> Generator[Judged, None, None]:
    """Every result in order, one kata after another; last what could not be read or has no kata.

    Of several katas, one that is broken costs its own submissions only. A fault of the judge's own is the
    result of each submission that is left, for whoever reads the results as data.
    """
    from judge.cli.judging import judged
    from judge.report.wait import progress

    plain = ask.form == TEXT and ask.junit is None and not common.json
    brief = ask.quiet and plain
    options = ask.options(common.isolation, brief=brief and ask.svg is None)
    wish = Wish(options, ask.jobs, kept=not ask.unrecorded, db=common.db, total=total)
    several = len(tasks) if total > 1 else 0
    waiting = [(task, each) for task in tasks for each in task.submissions]
    done = 0
    try:
        with progress("judging") if brief and ask.jobs > 1 and total > 1 else nullcontext() as advance:
            for task in tasks:
                begun = done
                drawings = judged(task.problem, task.submissions, replace(wish, before=done))
                try:
                    with closing(drawings):
                        for drawing in drawings:
                            done += 1
                            if advance:
                                advance(done, total)
                            yield _shown(drawing, total, several, ask, common)
                            drawing.save(ask.svg)
                            if not (common.isolation or brief) and plain:
                                _say_that_full_is_missing(drawing.result)
                except JudgeError as fault:
                    if isinstance(fault, UsageError) or len(tasks) == 1:
                        raise
                    for each in task.submissions[done - begun :]:
                        done += 1
                        yield _not_judged(each.name, str(fault), task.problem.id, several, ask, each.source)
    except Exception as fault:
        if not (plain or isinstance(fault, UsageError | OSError)):
            for task, each in waiting[done:]:
                yield _not_judged(each.name, told(fault), task.problem.id, several, ask, each.source)
        raise
    for entry in unjudged:
        yield _not_judged(entry.name, entry.why, entry.problem, several, ask)


def _shown(drawing: Drawing, total: int, several: int, ask: RunAsk, common: Common) -> Judged:
    """One result, with all that its screen shows."""
    found = Judged(
        drawing.result,
        drawing.source,
        drawing.problem,
        drawing,
        quiet=ask.quiet and total == 1,
        several=several,
        whole=ask.whole,
    )
    if not drawing.result.solved or several or ask.quiet or common.json:
        return found
    from judge.report.screen import is_terminal

    if is_terminal(sys.stdout) and not ask.unrecorded:
        from judge.cli.home import standing

        with suppress(JudgeError):  # the verdict is known, and worth more
            return replace(found, standing=standing(drawing.problem.id, common))
    return found


def _not_judged(name: str, why: str, problem: str, several: int, ask: RunAsk, source: bytes = b"") -> Judged:
    return Judged(judge_fault(problem, name, why), source, quiet=ask.quiet, several=several)


def _fresh(task: Task, ask: RunAsk, common: Common) -> Judged:
    """One submission on new cases for so long."""
    from judge.cli.picture import Drawing
    from judge.data.load import ProblemData
    from judge.judging.cases import judge_fresh
    from judge.judging.session import Session
    from judge.report.screen import Notes
    from judge.report.wait import progress, stages

    (submission,), problem = task.submissions, task.problem
    lasting = seconds_of(ask.fresh or "", "--fresh")
    seed = random.randrange(_SEEDS) if ask.seed is None else ask.seed
    groups = chosen_groups(problem, ask.groups, ask.level)
    options = replace(ask.options(common.isolation, brief=ask.quiet), seed=None, timed=False)
    with Session(problem, options, bars=progress) as session, stages(Path(submission.name).name) as stage:

        def tell(cases: int, spent: float) -> None:
            if stage:
                whole = math.ceil(lasting)
                stage(f"{cases:,} cases, {cases / spent:,.0f} a second", min(int(spent), whole), whole)

        stressed = judge_fresh(
            session, submission.source, submission.name, groups, seed=seed, seconds=lasting, on_cases=tell
        )
    again = f"{stressed.cases:,} fresh cases in {stressed.seconds:.0f} s; the same again: --seed {seed}"
    Notes().say(stressed.result.notes)
    drawing = Drawing(problem, ProblemData(problem, ()), stressed.result)
    drawing.save(ask.svg)
    stopped = stressed.interrupted and stressed.result.failure is None
    return Judged(
        stressed.result.noting(again),
        submission.source,
        problem,
        drawing,
        quiet=ask.quiet,
        whole=ask.whole,
        fresh=again,
        status=ExitCode.INTERRUPTED if stopped else stressed.result.exit_code,
    )


def _say_that_full_is_missing(result: Result) -> None:
    """Once a day, to a person who has not been told so by `judge doctor`."""
    from judge.judging.containment import first_today, kept_level
    from judge.report.screen import is_terminal, note

    if result.isolation == "strong" and is_terminal(sys.stderr) and kept_level() is None and first_today():
        note("Sandbox: strong, not full. Why: judge doctor")
