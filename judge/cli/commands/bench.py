"""`judge bench`: what solutions take for a case, language beside language."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from judge.cli.judging_options import isolation_option
from judge.cli.options import group_option, json_option, problems_option, write_json
from judge.cli.submissions import read_submissions
from judge.cli.target import OutFile
from judge.cli.wish import named_problem
from judge.data.load import load_data
from judge.errors import ExitCode, UsageError
from judge.judging.containment import Containment
from judge.kata.model import Model, approaches
from judge.languages import NAME as PYTHON
from judge.languages import language_of
from judge.problem import Problem
from judge.problem.choose import chosen_groups
from judge.report.bench import bench_lines
from judge.report.progress import progress, stages
from judge.report.screen import note, out
from judge.run.bench import MOST_ROUNDS, Bench, Entrant, Row, Spread, bench

if TYPE_CHECKING:
    from judge.languages.model import Language

SCHEMA = 1
_ROUNDS = 7


@click.command("bench")
@click.argument("name", metavar="PROBLEM")
@click.argument("files", metavar="[FILE]...", nargs=-1)
@click.option(
    "--languages",
    "names",
    metavar="L,L,…",
    help="Only the solutions in these languages, beside Python's: go,cpp,java.",
)
@click.option(
    "--rounds",
    type=click.IntRange(1, MOST_ROUNDS),
    default=_ROUNDS,
    show_default=True,
    metavar="N",
    help="How often everything is measured.",
)
@group_option
@click.option(
    "--html",
    "page",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Write the table and the plot into an HTML page too.",
)
@isolation_option
@json_option
@problems_option
def command(
    name: str,
    files: tuple[str, ...],
    names: str | None,
    rounds: int,
    groups: tuple[str, ...],
    page: Path | None,
    level: str | None,
    as_json: bool,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Measure what solutions take for a case, language beside language.

    The problem's solutions that set the time limits, one in each language, and your own FILEs beside them, on
    the problem's cases or a sample of a thousand. Every round measures each of them once, contained. Shown
    are nanoseconds of CPU time for a case after the start, with quartiles, the ratio to Python's solution,
    the start in bare starts of Python, memory, and the first pass, cold, beside those that come after it.

    \b
      judge bench distance
      judge bench distance mine.go --languages go,cpp
      judge bench distance --html bench.html

    Ctrl-C ends it early and keeps the rounds that are whole.

    Exit status: 0 measured, 2 usage, 3 the judge's or the problem's own fault, 130 interrupted.
    """
    problem = named_problem(name, folders)
    target = None
    if page is not None:
        from judge.report.page.bench import is_bench_page, render_bench

        target = OutFile(page, "--html", "page of judge bench", is_bench_page)
        target.check()
    entrants = _entrants(problem, files, names)
    chosen = [group for group in chosen_groups(problem, groups) if groups or group.size is None]
    with progress(f"building {problem.id}") as advance:
        data = load_data(problem, progress=advance)
    wanted = [each for each in data.groups if each.group in chosen]
    with Containment(problem, level) as containment, stages("bench") as stage:
        found = bench(data, wanted, entrants, containment.open_box, rounds, stage)
    if as_json:
        write_json(as_object(found))
    else:
        screen = out()
        screen.show(bench_lines(found, screen.width))
    if target is not None:
        target.write(render_bench(found, datetime.now(UTC)))
        if not as_json:
            note(f"the page is {page}")
    return ExitCode.INTERRUPTED if found.interrupted else ExitCode.ACCEPTED


def _entrants(problem: Problem, files: Sequence[str], names: str | None) -> list[Entrant]:
    """Python's solution first, then one in each language, then a person's own files."""
    wanted = _wanted(names)
    own = [Entrant(each.name, each.source, _tongue(each.name), own=True) for each in read_submissions(files)]
    models: dict[str, Model] = {}
    declared = problem.time.references if problem.time else {}
    for model in approaches(problem):
        key = model.language.id if model.language else ""
        if key not in models or declared.get(key) == model.path.name:
            models[key] = model
    if "" not in models:
        what = f"{problem.id} has no solution in {PYTHON} to compare with"
        raise UsageError(what, remedy="name another problem")
    missing = [each.name for each in wanted or () if each is not None and each.id not in models]
    for each in missing:
        note(f"{problem.id} has no solution in {each}")
    chosen = [
        _of_model(model)
        for key, model in models.items()
        if not key or wanted is None or model.language in wanted
    ]
    return _told([*chosen, *own])


def _wanted(names: str | None) -> list[Language | None] | None:
    """The languages that are named; None where none is. Raises UsageError for one that nobody knows."""
    if names is None:
        return None
    from judge.languages.model import named_language

    words = [word.strip() for word in names.split(",") if word.strip()]
    if not words:
        raise UsageError("--languages names none", remedy="name some, as --languages go,cpp")
    return [named_language(word) for word in words]


def _of_model(model: Model) -> Entrant:
    return Entrant(model.path.name, model.source, model.tongue)


def _tongue(name: str) -> str:
    language = language_of(name)
    return language.name if language else PYTHON


def _told(entrants: Sequence[Entrant]) -> list[Entrant]:
    """The same, each with why nothing in its language can be run here."""
    from msgspec.structs import replace

    from judge.languages.find import why_not

    found = []
    for each in entrants:
        language = language_of(each.name)
        if language is not None:
            each = replace(each, missing=why_not(language), warms=language.factor > 1)
        found.append(each)
    return found


def as_object(found: Bench) -> dict[str, Any]:
    """The published object."""
    return {
        "schema": SCHEMA,
        "problem": found.problem,
        "cases": found.cases,
        "rounds": found.rounds,
        "wanted_rounds": found.wanted,
        "interrupted": found.interrupted,
        "rounds_beside_others": found.beside,
        "bare_start_seconds": _spread(found.bare),
        "isolation": found.isolation or None,
        "rows": [_row(row) for row in found.rows],
    }


def _row(row: Row) -> dict[str, Any]:
    return {
        "language": row.entrant.language,
        "file": row.entrant.name,
        "own": row.entrant.own,
        "ns": _spread(row.seconds, 1e9),
        "ratio": _spread(row.ratio),
        "first_pass_ns": _spread(row.first, 1e9),
        "starts": _spread(row.start),
        "memory_bytes": row.memory_bytes,
        "passes": row.passes,
        "wrong": row.wrong,
        "why_not": row.why_not or None,
    }


def _spread(spread: Spread | None, factor: float = 1.0) -> dict[str, float] | None:
    if spread is None:
        return None
    return {"median": spread.median * factor, "low": spread.low * factor, "high": spread.high * factor}
