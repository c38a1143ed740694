"""`judge try`: a case of one's own."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from judge.cli.judging_options import isolation_option, svg_option
from judge.cli.options import json_option, problems_option, write_json
from judge.cli.submissions import Submission, read_submissions
from judge.cli.target import check_svg, svg_target
from judge.data.given import line_of, read_case
from judge.errors import ExitCode, UsageError, told
from judge.judging.job import RunOptions
from judge.judging.session import Session
from judge.judging.trying import ask, try_case
from judge.languages import is_program
from judge.problem import Verdict
from judge.problem.declare import Shown
from judge.problem.find import find_problem
from judge.problem.model import chosen_groups
from judge.report.layout import Line, line
from judge.report.screen import Notes, Screen, note, out
from judge.report.trying import said_lines, tried_lines
from judge.run.tried import Said, Tried
from judge.values import show

if TYPE_CHECKING:
    from judge.drawing import Picture

SCHEMA = 1
_AROUND = 3  # rows of a terminal: one above a picture, one below it, and the prompt


@click.command("try", context_settings={"ignore_unknown_options": True})
@click.argument("name", metavar="PROBLEM")
@click.argument("words", metavar="CASE [FILE]", nargs=-1, type=click.UNPROCESSED)
@click.option("--group", metavar="G", help="Use the tolerance of this test group.")
@json_option
@isolation_option
@svg_option
@problems_option
def command(
    name: str,
    words: tuple[str, ...],
    group: str | None,
    as_json: bool,
    level: str | None,
    svg: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Answer a case of your own, exactly.

    Write CASE as Python arguments, "0, 0, 1, (-1, 1), (1, 1)", with or without names, as a whole call, or
    as the line that a program reads, 0 0 1 -1 1 1 1. It must be valid by the statement. You see the exact
    answer, which answers are accepted, and the picture. With a FILE you also see what that answers; it runs
    isolated.

    Exit status: 0 accepted or no FILE, 1 not accepted, 2 usage or an invalid case, 3 a fault of the judge
    or of the problem.
    """
    problem = find_problem(name, folders)
    if group is not None:
        chosen_groups(problem, [group])  # a name that is none
    case, submission = _case_and_file(words)
    if svg is not None:
        check_svg(svg, 1)
    tried = try_case(problem, read_case(problem, case), group)
    said = None
    if submission is not None:
        with Session(problem, RunOptions(isolation=level)) as session:
            said = ask(session, tried, submission.source, submission.name)
            Notes().say(session.containment.notes(said.isolation))
    if as_json:
        write_json(_as_object(tried, group, submission, said))
    else:
        _show(tried, submission, said, out())
    if svg is not None:
        _save(tried, said, svg)
    return ExitCode.ACCEPTED if said is None or said.verdict is Verdict.AC else ExitCode.NOT_ACCEPTED


def _case_and_file(words: Sequence[str]) -> tuple[str, Submission | None]:
    """The case in one text, and the file if the last word is one. Raises UsageError."""
    for word in words:
        if word.startswith("--"):  # which a negative number never does
            raise UsageError(f"no such option '{word}'", remedy="see 'judge try --help'")
    if not words or not is_program(words[-1]):
        return " ".join(words), None
    *first, last = words
    submissions = read_submissions([last])
    if len(submissions) > 1:
        raise UsageError("this folder holds several submissions", where=last, remedy="name one file")
    return " ".join(first), submissions[0]


def _as_object(
    tried: Tried, group: str | None, submission: Submission | None, said: Said | None
) -> dict[str, Any]:
    """The published object; `said` is null without a file."""
    problem = tried.problem
    answer = None
    if submission is not None and said is not None:
        answer = {
            "submission": submission.name,
            "mode": said.mode.value if said.mode else None,
            "verdict": said.verdict.value,
            "got": said.got,
            "message": said.message,
            "isolation": said.isolation or None,
        }
    return {
        "schema": SCHEMA,
        "problem": problem.id,
        "group": group,
        "input": problem.named(tried.case),
        "line": line_of(problem, tried.case),
        "exact": show.exact_text(problem.answer, tried.exact),
        "expected": tried.wanted,
        "accepted": show.accepted(problem.answer, tried.target),
        "said": answer,
    }


def _picture(tried: Tried, said: Said | None) -> Picture | None:
    draw = tried.data.module.hooks.picture
    if draw is None:
        return None
    values = tried.problem.named(tried.case)
    wrong = said if said is not None and said.verdict is not Verdict.AC else None
    got, given = (wrong.got, wrong.given) if wrong else (None, None)
    return draw(Shown(tried.problem, values, tried.exact, tried.wanted, got, given, "your case"))


def _show(tried: Tried, submission: Submission | None, said: Said | None, screen: Screen) -> None:
    above = list(tried_lines(tried, screen.width))
    below: list[Line] = []
    if submission is not None and said is not None:
        below = list(said_lines(said, submission.name, screen.width))
    drawn = _drawn(tried, said, screen, len(above) + len(below))
    screen.show([*above, *drawn, *([line()] if drawn and below else []), *below])


def _drawn(tried: Tried, said: Said | None, screen: Screen, beside: int) -> list[Line]:
    """The picture for a terminal that has room for it, so low that as many other lines are seen with it."""
    from judge.report.picture import has_room, picture_lines
    from judge.report.terminal import height

    drawn: list[Line] = []
    if has_room(screen):
        try:
            picture = _picture(tried, said)
        except Exception as fault:  # the answer is known, and worth more
            note(f"the case is not drawn: {told(fault)}")
            picture = None
        if picture is not None:
            drawn = [line(), *picture_lines(picture, height(screen) - beside - _AROUND)]
    return drawn


def _save(tried: Tried, said: Said | None, path: Path) -> None:
    from judge.drawing.svg import to_svg

    picture = _picture(tried, said)
    if picture is None:
        note(f"nothing to draw, {path} is not written: the problem has no picture of it")
        return
    svg_target(path).write(to_svg(picture).encode())
