"""`judge explore`: a page for the browser on which a case can be moved about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.cli.target import OutFile
from judge.data.given import read_case
from judge.errors import ExitCode, UsageError
from judge.problem.find import find_problem
from judge.problem.module import load_module
from judge.report.layout import Link, Span, line
from judge.report.names import shown_name
from judge.report.screen import note, out

if TYPE_CHECKING:
    from judge.problem import Problem

SCHEMA = 1
_USUAL = Path("judge-explore.html")
_MARK = b'name="generator" content="judge explore"'


@click.command("explore", context_settings={"ignore_unknown_options": True})
@click.argument("name", metavar="[PROBLEM|ID", required=False)
@click.argument("words", metavar="[CASE]]", nargs=-1, type=click.UNPROCESSED)
@click.option(
    "--out",
    "path",
    metavar="FILE",
    type=click.Path(path_type=Path),
    default=_USUAL,
    help=f"Where to write the page; {_USUAL} in the current folder if not given.",
)
@click.option("--force", is_flag=True, help="Overwrite a file that is not such a page.")
@click.option("--open", "opened", is_flag=True, help="Open it in the browser.")
@json_option
@db_option
@problems_option
def command(
    name: str | None,
    words: tuple[str, ...],
    path: Path,
    force: bool,
    opened: bool,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Write a page on which a case can be moved about.

    Drag the figure in your browser with the mouse, a finger or the keyboard. The page shows what is decided,
    and every number on the way, exactly; beside it is what the same formulas give in doubles. It is one file
    that loads nothing. It begins with the CASE, written as for 'judge try', or with the case of a replay ID,
    which 'judge run' shows with a failing case. Without a PROBLEM it is about your current kata, or the first
    that has such a page. Every kata in the plane has one.

    Exit status: 0 written, 2 usage, 3 a fault of a problem.
    """
    for word in words:
        if word.startswith("--"):  # which a negative number never does
            raise UsageError(f"no such option '{word}'", remedy="see 'judge explore --help'")
    target = OutFile(path, "--out", "page of judge explore", lambda start: _MARK in start)
    target.check(force=force, remedy="name another file with --out, or overwrite it with --force")
    problem, page = _page(name, " ".join(words), folders, db)
    target.write(page.encode())
    if as_json:
        write_json({"schema": SCHEMA, "problem": problem.id, "out": str(path), "bytes": len(page.encode())})
    else:
        out().show([line(Span(shown_name(str(path)), link=Link(str(path))))])
    if opened:
        _open(path)
    return ExitCode.ACCEPTED


def _page(name: str | None, case: str, folders: Sequence[Path], db: Path | None) -> tuple[Problem, str]:
    """The problem and its page. Raises UsageError where there is none."""
    if name is None:
        return _usual(folders, db)
    if ":" in name:
        return _replayed(name, case, folders)
    problem = find_problem(name, folders)
    values = problem.named(read_case(problem, case)) if case else None
    return problem, _explored(problem, values)


def _replayed(replay: str, case: str, folders: Sequence[Path]) -> tuple[Problem, str]:
    from judge.diagnose.replay import decode, problem_name

    if case:
        raise UsageError("a replay ID is a case already", remedy="leave one of them out")
    problem = find_problem(problem_name(replay), folders)
    found = decode(replay, problem, load_module(problem))
    return problem, _explored(problem, problem.named(found.case))


def _usual(folders: Sequence[Path], db: Path | None) -> tuple[Problem, str]:
    """The kata in hand, or else the first of the path that has a page."""
    from judge.cli.kata import kata_in_hand, problem_of, the_path

    try:
        mine = [problem_of(kata_in_hand(db), folders)]
    except UsageError:
        mine = []
    for problem in (*mine, *(each for each, _ in the_path(folders, db)[1])):
        page = _page_of(problem)
        if page is not None:
            return problem, page
    raise UsageError("no problem has a page to explore", remedy="name a folder of problems with --problems")


def _explored(problem: Problem, values: Mapping[str, Any] | None) -> str:
    page = _page_of(problem, values)
    if page is None:
        remedy = "'judge explore count' shows one that has"
        raise UsageError(f"{problem.id} has no page to explore", remedy=remedy)
    return page


def _page_of(problem: Problem, values: Mapping[str, Any] | None = None) -> str | None:
    explore = load_module(problem).hooks.explore
    return explore(problem, values) if explore else None


def _open(path: Path) -> None:
    import webbrowser

    if not webbrowser.open(path.absolute().as_uri()):
        note(f"there is no browser here; open {path} yourself")
