"""`judge data`: a problem's test data as files."""

from __future__ import annotations

from pathlib import Path

import click

from judge.atomic import replace_file
from judge.cli.options import (
    group_option,
    json_option,
    problems_option,
    seed_option,
    write_json,
)
from judge.data.load import load_data
from judge.errors import ExitCode, UsageError, unwritable
from judge.problem.find import find_problem
from judge.problem.model import chosen_groups
from judge.report.files import group_files
from judge.report.layout import Span, Style, line
from judge.report.names import shown_name
from judge.report.progress import progress
from judge.report.screen import note, out
from judge.report.values import counted

SCHEMA = 1
_KINDS = (".in", ".ans", ".json")
_REMEDY = "name another folder with --out"


@click.command("data")
@click.argument("name", metavar="PROBLEM")
@click.option(
    "--out", "target", metavar="DIR", required=True, type=click.Path(path_type=Path), help="Where to write."
)
@click.option("--force", is_flag=True, help="Overwrite existing files.")
@json_option
@group_option
@seed_option
@problems_option
def command(
    name: str,
    target: Path,
    force: bool,
    as_json: bool,
    groups: tuple[str, ...],
    seed: int | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Write a problem's test data and exact answers as files.

    For each test group: G.in is what a program reads, G.ans what a perfect one prints, and G.json has every
    case with its exact answer in up to 40 digits, and the least and greatest double that is accepted.
    """
    problem = find_problem(name, folders)
    chosen = chosen_groups(problem, groups)
    names = [f"{group.name}{kind}" for group in chosen for kind in _KINDS]
    _make_room(target, names, force=force)
    with progress(f"building {problem.id}") as advance:
        data = load_data(problem, seed=seed, progress=advance)
    for text in data.notes:
        note(text)
    wanted = {group.name for group in chosen}
    cases = 0
    for group in data.groups:
        if group.group.name in wanted:
            cases += len(group.cases)
            for file, text in group_files(data, group):
                _write(target / file, text)
    if as_json:
        write_json(
            {"schema": SCHEMA, "problem": problem.id, "out": str(target), "cases": cases, "files": names}
        )
    else:
        what = f"{counted(cases, 'case')} in {counted(len(names), 'file')}"
        out().show([line(Span(shown_name(str(target)), Style.STRONG), f"  {what}")])
    return ExitCode.ACCEPTED


def _make_room(target: Path, names: list[str], *, force: bool) -> None:
    """Make the folder; nothing that is there already is written over unasked."""
    try:
        target.mkdir(parents=True, exist_ok=True)
        there = [name for name in names if (target / name).exists()]
    except FileExistsError as fault:
        raise UsageError("it is a file, not a folder", where=str(target), remedy=_REMEDY) from fault
    except OSError as fault:
        raise unwritable(target, fault, _REMEDY) from fault
    if there and not force:
        more = f" and {counted(len(there) - 1, 'more file')}" if len(there) > 1 else ""
        raise UsageError(
            f"{there[0]}{more} would be written over",
            where=str(target),
            remedy="name an empty folder or add --force",
        )


def _write(path: Path, text: str) -> None:
    try:
        replace_file(path, text.encode())
    except OSError as fault:
        raise unwritable(path, fault, _REMEDY) from fault
