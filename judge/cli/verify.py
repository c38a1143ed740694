"""`judge verify`: the setter's gate."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from judge.cli.options import json_option, problems_option, write_json
from judge.errors import ExitCode, ProblemError
from judge.report.layout import line
from judge.report.progress import stages
from judge.report.screen import out
from judge.report.verified import report_lines, summary_line
from judge.run.verify import Fault, SolutionReport, VerifyReport, verify_problem
from judge.spec.find import find_problem, problem_folders

SCHEMA = 1


@click.command("verify")
@click.argument("names", metavar="[PROBLEM]...", nargs=-1)
@click.option("--pin", is_flag=True, help="Pin the data as they are now: write hashes.json.")
@json_option
@problems_option
def command(names: tuple[str, ...], pin: bool, as_json: bool, folders: tuple[Path, ...]) -> ExitCode:
    """Check problems from the setter's side.

    That every case keeps the promise, that examples agree with the reference, that the data are the pinned
    ones, and that every solution gets the verdict its folder says. Without a name: all problems.

    Exit status: 0 sound, 2 usage, 3 something is wrong.
    """
    chosen = names or tuple(sorted(folder.name for folder in problem_folders(folders)))
    reports = []
    for name in dict.fromkeys(chosen):
        report = _verify(name, folders, pin=pin)
        reports.append(report)
        if as_json:
            write_json(as_object(report))
        else:
            screen = out()
            screen.show([*report_lines(report, screen.width), line()])
    if not as_json:
        screen = out()
        screen.show(summary_line(reports, screen.width))
    return ExitCode.ACCEPTED if all(report.ok for report in reports) else ExitCode.FAULT


def _verify(name: str, folders: Sequence[Path], *, pin: bool) -> VerifyReport:
    """The report on one problem; one that cannot even be read has that as its only fault."""
    try:
        problem = find_problem(name, folders)
    except ProblemError as error:
        fault = Fault(error.what, error.where or name, error.remedy or "")
        return VerifyReport(name, 0, 0, "differing", (), (fault,))
    with stages(name) as progress:
        return verify_problem(problem, update_pins=pin, progress=progress)


def as_object(report: VerifyReport) -> dict[str, Any]:
    """The published object of one problem's report."""
    return {
        "schema": SCHEMA,
        "problem": report.problem,
        "ok": report.ok,
        "groups": report.groups,
        "cases": report.cases,
        "pins": report.pins,
        "solutions": [_solution(solution) for solution in report.solutions],
        "faults": [
            {"what": fault.what, "where": fault.where, "remedy": fault.remedy} for fault in report.faults
        ],
    }


def _solution(report: SolutionReport) -> dict[str, Any]:
    return {
        "file": report.file,
        "name": report.name,
        "verdict": report.verdict.value,
        "ok": report.ok,
        "failed": list(report.failed),
    }
