"""`judge export`: problems as packages that other judges read."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from judge.cli.options import json_option, problems_option, write_json
from judge.errors import ExitCode, ProblemError, UsageError
from judge.judging.isolation import kept_level
from judge.packs.export.forms import why_left_out
from judge.packs.export.job import Export, Order, Package, Progress, check_places, export
from judge.packs.export.metadata import Version, short_name, short_names
from judge.packs.export.statement import latex
from judge.problem import Problem
from judge.problem.find import find_problem, folders_within, problem_folders
from judge.report.export import export_lines, total_line
from judge.report.layout import line
from judge.report.progress import stages
from judge.report.screen import out
from judge.sandbox import Boxes

SCHEMA = 1
_BOTH = "both"


@click.command("export")
@click.argument("names", metavar="[PROBLEM]...", nargs=-1)
@click.option("--all", "everything", is_flag=True, help="All problems, or all in the folders of --problems.")
@click.option(
    "--format",
    "form",
    type=click.Choice(["kattis"]),
    default="kattis",
    metavar="kattis",
    help="The format; kattis is the only one.",
)
@click.option(
    "--version",
    "version",
    type=click.Choice([*(each.value for each in Version), _BOTH]),
    default=_BOTH,
    metavar="|".join([*(each.value for each in Version), _BOTH]),
    help="The version of the format; both by default.",
)
@click.option(
    "--out", "target", metavar="DIR", required=True, type=click.Path(path_type=Path), help="Where to write."
)
@click.option("--zip", "archives", is_flag=True, help="Also write archives, one of them for DOMjudge.")
@click.option("--no-submissions", "bare", is_flag=True, help="Write no programs into the packages.")
@click.option(
    "--wrong",
    type=click.IntRange(0),
    metavar="N",
    help="At most N wrong programs; there is one for each mistake.",
)
@json_option
@problems_option
def command(
    names: tuple[str, ...],
    everything: bool,
    form: str,  # noqa: ARG001 - there is only one
    version: str,
    target: Path,
    archives: bool,
    bare: bool,
    wrong: int | None,
    as_json: bool,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Write problems as packages that other judges read.

    Kattis, DOMjudge and others read them. DIR/legacy/ID and DIR/2025-09/ID are one package in two versions
    of the format. It has the test groups as files, a validator that decides exactly as judge does for
    programs, the statement as LaTeX, and the programs of solutions/, each in the folder of the verdict that
    it gets there. --zip also writes DIR/*/ID.kpp and DIR/domjudge/ID.zip. A package of the same problem is
    replaced.

    What a package cannot hold is left out, and named.

    Exit status: 0 written, 2 usage, or nothing could be written, 3 a problem is broken.
    """
    versions = tuple(Version) if version == _BOTH else (Version(version),)
    order = Order(target, versions, archives, not bare, wrong)
    problems = _chosen(names, folders, everything=everything)
    wanted = [each for each in problems if not why_left_out(each)]
    short_names(each.id for each in wanted)
    for each in wanted:  # what cannot be is told before anything takes long
        check_places(each, order)
    if wanted:
        latex(wanted[0])
    return _exported(problems, order, as_json=as_json)


def _chosen(names: tuple[str, ...], folders: tuple[Path, ...], *, everything: bool) -> list[Problem]:
    if bool(names) == everything:
        what = "name problems, or give --all, not both" if names else "no problem is named"
        raise UsageError(what, remedy="judge export PROBLEM… --out DIR, or judge export --all --out DIR")
    if everything:
        paths = folders_within(folders) if folders else problem_folders()
        names = tuple(sorted(path.name for path in paths))
    return [find_problem(name, folders) for name in dict.fromkeys(names)]


def _exported(problems: list[Problem], order: Order, *, as_json: bool) -> ExitCode:
    boxes = Boxes(least=kept_level())
    exports: list[Export] = []
    for problem in problems:
        why = why_left_out(problem)
        if why:
            exports.append(Export(problem, short_name(problem.id), why))
        else:
            with stages(problem.id) as advance:
                exports.append(_one(problem, order, boxes, advance or _silent, alone=len(problems) == 1))
        if as_json:
            write_json(as_object(exports[-1]))
        else:
            screen = out()
            screen.show([*export_lines(exports[-1], screen.width)])
    if not as_json:
        out().show([line(), total_line(exports)])
    if any(each.broken for each in exports):
        return ExitCode.FAULT
    if all(each.why for each in exports):
        what = "no package can hold any of these" if len(exports) > 1 else "no package can hold it"
        raise UsageError(what, where=exports[0].problem.id if len(exports) == 1 else None)
    return ExitCode.ACCEPTED


def _one(problem: Problem, order: Order, boxes: Boxes, advance: Progress, *, alone: bool) -> Export:
    """One problem's packages; of several, one whose folder is broken costs itself only."""
    try:
        return export(problem, order, boxes, advance)
    except ProblemError as fault:
        if alone:
            raise
        return Export(problem, short_name(problem.id), str(fault), broken=True)


def _silent(_what: str, _done: int, _total: int) -> None:
    pass


def as_object(export: Export) -> dict[str, Any]:
    """The published object of one problem."""
    programs = export.programs
    return {
        "schema": SCHEMA,
        "problem": export.problem.id,
        "package": export.short,
        "left_out": export.why or None,
        "packages": [_package(each) for each in export.packages],
        "domjudge": str(export.domjudge) if export.domjudge else None,
        "time_limit": programs.seconds if programs else None,
        "programs": [
            {"file": each.path, "verdict": each.trial.verdict.value, "test": each.trial.file or None}
            for each in (programs.held if programs else ())
        ],
        "programs_left_out": [
            {"file": each.file, "why": each.why} for each in (programs.left_out if programs else ())
        ],
        "notes": list(export.notes),
    }


def _package(package: Package) -> dict[str, Any]:
    return {
        "version": package.version.value,
        "folder": str(package.folder),
        "archive": str(package.archive) if package.archive else None,
        "files": package.files,
        "bytes": package.bytes,
    }
