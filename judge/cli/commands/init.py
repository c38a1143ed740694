"""`judge init`: the file a kata begins with."""

from __future__ import annotations

from pathlib import Path

import click

from judge.cli.kata import Kata, take_up, write_stub
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata.stub import file_name
from judge.languages import file_name as program_name
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.report.kata import begun_lines
from judge.report.screen import out

SCHEMA = 1


@click.command("init")
@click.argument("name", metavar="PROBLEM")
@click.argument("file", metavar="[FILE]", required=False)
@click.option("--language", metavar="LANGUAGE", help="The language of the file; Python by default.")
@click.option("--force", is_flag=True, help="Overwrite an existing file.")
@json_option
@db_option
@problems_option
def command(
    name: str,
    file: str | None,
    language: str | None,
    force: bool,
    as_json: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Begin a kata: write the file for your solution.

    The file has the head of the function, the statement and its examples. It fails until you write the
    function. Without FILE, it is named after the kata. The end of its name says the language, or --language
    does: c, cpp, go, java, javascript, rust, pypy. This is then your current kata: judge run, judge watch
    and judge hint use it until you begin another one.
    """
    problem = find_problem(name, folders)
    path = Path(_usual(problem, language) if file is None else file)
    write_stub(problem, path, force=force)
    take_up(Kata(problem, path.absolute()), db)
    if as_json:
        write_json({"schema": SCHEMA, "problem": problem.id, "file": str(path)})
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(begun_lines(problem, str(path), screen.width))
    return ExitCode.ACCEPTED


def _usual(problem: Problem, language: str | None) -> str:
    """The usual name of the problem's file in that language. Raises UsageError for one that nobody knows."""
    if language is None:
        return file_name(problem)
    from judge.languages.model import named_language

    found = named_language(language)
    if found is None:
        return file_name(problem)
    return program_name(problem.id.replace("-", "_"), found)
