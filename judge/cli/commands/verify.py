"""`judge verify`: the setter's gate."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.atomic import replace_file
from judge.cli.options import json_option, problems_option, write_json
from judge.data.model import ProblemData
from judge.errors import ExitCode, ProblemError, UsageError
from judge.judging.isolation import kept_level
from judge.kata.check import kata_faults
from judge.languages.boxes import AnyBoxes
from judge.languages.signature import signature_of
from judge.mistakes.verified import ChoicesReport, verify_choices
from judge.problem import Group, Problem
from judge.problem.find import find_problem, folders_within, problem_folders
from judge.problem.tables import meant
from judge.report.layout import line
from judge.report.progress import stages
from judge.report.screen import out
from judge.report.verified import report_lines, summary_line
from judge.run.edges import edges_of
from judge.run.matrix import Matrix
from judge.run.verify import Fault, Progress, SolutionReport, VerifyReport, fresh_data, verify_problem
from judge.sandbox import Boxes

SCHEMA = 1


@click.command("verify")
@click.argument("names", metavar="[PROBLEM]...", nargs=-1)
@click.option(
    "--matrix",
    is_flag=True,
    help="Show which test group rejects which wrong program, and which edges have cases.",
)
@click.option("--pin", is_flag=True, help="Pin the data as they are now: write pins.json.")
@click.option("--figures", is_flag=True, help="Draw the statement's figure: write figure.svg.")
@click.option(
    "--seeds",
    type=click.IntRange(1, 100),
    default=1,
    metavar="N",
    help="Check N sets of data, pinned ones first.",
)
@click.option("--group", "groups", multiple=True, metavar="NAME", help="Check only this group.")
@click.option(
    "--solution", metavar="FILE", default="", help="Judge only this solution, such as accepted/exact.py."
)
@click.option(
    "-j", "jobs", type=click.IntRange(1, 64), default=1, metavar="N", help="Check N problems at once."
)
@json_option
@problems_option
def command(
    names: tuple[str, ...],
    matrix: bool,
    pin: bool,
    figures: bool,
    seeds: int,
    groups: tuple[str, ...],
    solution: str,
    jobs: int,
    as_json: bool,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Check problems from the setter's side.

    It checks that every case is valid, that the examples agree with the reference, that the data are the
    pinned ones, that every solution gets the verdict of its folder, that the hints can be read, and that a
    stub can be made. Without a name: all problems of the folders that --problems gives, or all there are.

    A wrong program that fewer than five cases reject is a warning.

    --matrix shows each wrong program with the groups that reject it, and in how many of their cases; the
    groups that no program needs; and how many cases reach which edge: a parameter is 0, two are equal, a
    decision is exact or nearly so.

    --group and --solution check only a part: how many cases of a group reject each mistake, or whether one
    program is right.

    Exit status: 0 sound, 2 usage, 3 something is wrong.
    """
    if pin and (groups or solution):
        raise UsageError("--pin is for the whole problem", remedy="leave out --group and --solution")
    chosen = tuple(dict.fromkeys(names or sorted(folder.name for folder in _chosen(folders))))
    check = partial(_verify, _Options(folders, pin, seeds, matrix, groups, solution))
    reports = []
    for report in _checked(check, chosen, jobs):
        if figures and report.ok:
            _draw_figure(find_problem(report.problem, folders))
        reports.append(report)
        if as_json:
            write_json(as_object(report, with_matrix=matrix))
        else:
            screen = out()
            lines = report_lines(report, screen.width, with_matrix=matrix, with_least=bool(groups))
            screen.show([*lines, line()])
    if not as_json:
        screen = out()
        screen.show(summary_line(reports, screen.width))
    return ExitCode.ACCEPTED if all(report.ok for report in reports) else ExitCode.FAULT


def _chosen(folders: Sequence[Path]) -> list[Path]:
    """The problems to check where none is named: a setter means their own, not all that can be found."""
    return folders_within(folders) if folders else problem_folders()


def _checked(check: Callable[[str], VerifyReport], names: Sequence[str], jobs: int) -> Iterator[VerifyReport]:
    """The report on each, in their order; several at once are several processes."""
    if jobs == 1 or len(names) == 1:
        yield from map(check, names)
        return
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        yield from pool.map(check, names)


class _Options(Struct, frozen=True):
    """What to check of each problem."""

    folders: Sequence[Path]
    pin: bool
    seeds: int
    edges: bool
    groups: Sequence[str]
    solution: str


def _verify(options: _Options, name: str) -> VerifyReport:
    """The report on one problem; one that cannot even be read has that as its only fault."""
    try:
        problem = find_problem(name, options.folders)
    except ProblemError as error:
        fault = Fault(error.what, error.where or name, error.remedy or "")
        return VerifyReport(name, 0, 0, "differing", (), (fault,))
    boxes = Boxes(least=kept_level())
    part = bool(options.groups)
    if options.groups:
        problem = replace(problem, groups=tuple(_group(problem, each) for each in options.groups))
    with stages(name) as progress:
        data = _data(problem, options.seeds, progress)
        found = ChoicesReport()
        if data and not options.solution:
            found = verify_choices(problem, data, boxes, progress, partial=part)
        any_boxes = AnyBoxes(boxes, signature_of(problem))
        report = verify_problem(
            problem,
            update_pins=options.pin,
            progress=progress,
            box_factory=any_boxes,
            kills=found.kills,
            data=data,
            solution=options.solution,
            partial=part,
        )
    return replace(
        report,
        edges=tuple(edges_of(data[0])) if options.edges and data else (),
        choices=found.count,
        least=found.least,
        faults=tuple(dict.fromkeys((*report.faults, *found.faults, *kata_faults(problem, options.folders)))),
        warnings=(*report.warnings, *found.warnings),
    )


def _group(problem: Problem, name: str) -> Group:
    """The group of that name. Raises UsageError."""
    names = {group.name: group for group in problem.groups}
    if name not in names:
        raise UsageError(
            f"{problem.id} has no group {name!r}", remedy=meant(name, list(names), "its groups are")
        )
    return names[name]


def _draw_figure(problem: Problem) -> None:
    """Write figure.svg beside the statement, where there is something to draw."""
    from judge.report.figure import FIGURE, figure

    drawn = figure(problem)
    if drawn is not None:
        replace_file(problem.folder / FIGURE, drawn.encode())


def _data(problem: Problem, seeds: int, progress: Progress | None) -> list[ProblemData]:
    """The pinned data, built anew, and those of seeds 1, 2, …; none where they cannot be built, which
    verify_problem tells."""
    try:
        return [fresh_data(problem, progress, seed) for seed in (None, *range(1, seeds))]
    except ProblemError:
        return []


def as_object(report: VerifyReport, *, with_matrix: bool = False) -> dict[str, Any]:
    """The published object of one problem's report."""
    matrix: dict[str, Any] = {}
    if with_matrix:
        least = [
            {"name": each.name, "line": each.line, "group": each.group, "cases": each.cases}
            for each in report.least
        ]
        matrix = {"matrix": _matrix(report.matrix) if report.matrix else None, "mistakes": least}
        matrix["edges"] = [{"what": what, "cases": cases} for what, cases in report.edges]
    return {
        "schema": SCHEMA,
        "problem": report.problem,
        "ok": report.ok,
        "groups": report.groups,
        "cases": report.cases,
        "pins": report.pins,
        "solutions": [_solution(solution) for solution in report.solutions],
        "choices": report.choices,
        "faults": [_fault(fault) for fault in report.faults],
        "warnings": [_fault(fault) for fault in report.warnings],
        **matrix,
    }


def _fault(fault: Fault) -> dict[str, str]:
    return {"what": fault.what, "where": fault.where, "remedy": fault.remedy}


def _matrix(matrix: Matrix) -> dict[str, Any]:
    return {
        "groups": list(matrix.groups),
        "programs": [
            {
                "file": row.file,
                "mistake": row.mistake,
                "aimed": list(row.aimed),
                "own": row.own.group if row.own else None,
                "rejected": {kill.group: list(kill.rejected) for kill in row.kills},
                "cases": {kill.group: kill.cases for kill in row.kills},
            }
            for row in matrix.rows
        ],
        "aimless": list(matrix.aimless),
        "replaceable": list(matrix.replaceable),
        "unkilled": [row.file for row in matrix.unkilled],
    }


def _solution(report: SolutionReport) -> dict[str, Any]:
    return {
        "file": report.file,
        "name": report.name,
        "verdict": report.verdict.value if report.verdict else None,
        "ok": report.ok,
        "failed": list(report.failed),
        **({"unjudged": report.unjudged} if report.unjudged else {}),
    }
