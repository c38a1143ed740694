"""`judge replay`: judge a submission on one case, named by its replay id."""

from __future__ import annotations

from pathlib import Path

import click
from msgspec.structs import replace

from judge.cli.containment import Containment, isolation_option
from judge.cli.options import json_option, problems_option, write_json
from judge.cli.submissions import read_submissions
from judge.data import GroupData, ProblemData
from judge.errors import ExitCode, UsageError
from judge.report.results import result_lines
from judge.report.screen import out
from judge.run import run_submission
from judge.spec import Problem
from judge.spec.find import find_problem


@click.command("replay")
@click.argument("replay", metavar="ID")
@click.argument("file", metavar="FILE")
@json_option
@isolation_option
@problems_option
def command(replay: str, file: str, as_json: bool, level: str | None, folders: tuple[Path, ...]) -> ExitCode:
    """Judge a submission on one case, by its replay id.

    `judge run` shows the id of the smallest case that breaks a submission; it works on any machine with the
    same version of the problem.

    Exit status: as that of `judge run`.
    """
    from judge.diagnose.replay import problem_name

    name = problem_name(replay)
    submissions = read_submissions([file])
    if len(submissions) > 1:
        raise UsageError("this folder holds several submissions", where=file, remedy="name one file")
    problem = find_problem(name, folders)
    data = _one_case(replay, problem)
    (submission,) = submissions
    with Containment(problem, level) as containment:
        settings = replace(containment.settings(submissions=1), measured=False)
        result = run_submission(problem, data, submission.source, submission.name, settings=settings)
        containment.warn_of(result.isolation)
    if as_json:
        write_json(result.as_json())
    else:
        screen = out()
        screen.show(result_lines(result, screen.width))
    return result.exit_code


def _one_case(replay: str, problem: Problem) -> ProblemData:
    """The data of the id's case alone."""
    from judge.compare.targets import compile_answer
    from judge.data.module import blaming, load_module
    from judge.diagnose.replay import decode

    module = load_module(problem)
    group, case = decode(replay, problem, module)
    with blaming(problem, "the reference fails on the case"):
        target = compile_answer(module.reference(*case), group.tolerance)
    alone = replace(group, count=1, points=100)
    return ProblemData(problem, (GroupData(alone, [case], [target]),), module=module)
