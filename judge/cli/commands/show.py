"""`judge show`: one problem, whole."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import click

from judge.cli.allowed import growth_rule, limits_object, own_rules
from judge.cli.options import json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.problem import Group, Parameter, Problem, Tolerance
from judge.problem.find import find_problem
from judge.report.layout import line
from judge.report.problems import detail_lines
from judge.report.screen import out
from judge.report.statement import show_statement

SCHEMA = 1


@click.command("show")
@click.argument("name", metavar="PROBLEM")
@click.option(
    "--groups", "listing", is_flag=True, help="What each test group tests, and the mistakes it rejects."
)
@json_option
@problems_option
def command(name: str, listing: bool, as_json: bool, folders: tuple[Path, ...]) -> ExitCode:
    """Show a problem: its statement, parameters and test groups.

    The parameters come with their bounds, the test groups with what they test, their points and tolerances.
    --groups shows only the groups, with the names of the mistakes that each one rejects.
    """
    problem = find_problem(name, folders)
    if as_json:
        write_json(as_object(problem))
        return ExitCode.ACCEPTED
    screen = out()
    if listing:
        from judge.report.groups import group_lines

        screen.show(group_lines(problem, problem.groups, screen.width))
        return ExitCode.ACCEPTED
    show_statement(problem.statement, screen)
    screen.show([line(), *detail_lines(problem, screen.width)])
    return ExitCode.ACCEPTED


def as_object(problem: Problem) -> dict[str, Any]:
    """The published object of one problem. Bounds and tolerances are exact: `n` or `n/d` as text."""
    return {
        "schema": SCHEMA,
        "problem": problem.id,
        "title": problem.title,
        "tier": problem.tier.value,
        "summary": problem.summary,
        "entry": problem.entry,
        "answer": str(problem.answer),
        "parameters": [_parameter(parameter) for parameter in problem.parameters],
        "bands": {},
        "limits": limits_object(problem.limits),
        **growth_rule(problem.growth, problem.groups),
        "groups": [_group(group) for group in problem.groups],
        "examples": [
            {"input": _named(problem, example.case), "answer": example.wanted} for example in problem.examples
        ],
        "statement": problem.statement,
        "source": {
            "authors": list(problem.source.authors),
            "license": problem.source.license or "unknown",
            "origin": problem.source.origin or None,
        },
    }


def _named(problem: Problem, case: tuple[Any, ...]) -> dict[str, Any]:
    return {parameter.name: value for parameter, value in zip(problem.parameters, case, strict=True)}


def _parameter(parameter: Parameter) -> dict[str, Any]:
    return {
        "name": parameter.name,
        "type": str(parameter.type),
        "low": str(parameter.low),
        "high": str(parameter.high),
        "smallest": str(parameter.smallest),
        "about": parameter.about,
    }


def _group(group: Group) -> dict[str, Any]:
    return {
        "name": group.name,
        "about": group.about,
        "cases": group.count,
        "points": group.points,
        **({"level": group.level.value} if group.level else {}),
        "seed": group.seed,
        "tolerance": _tolerance(group.tolerance),
        "kills": list(group.kills),
        **own_rules(group),
    }


def _tolerance(tolerance: Tolerance) -> dict[str, str]:
    parts: dict[str, Fraction] = {
        "extent": tolerance.extent,
        "relative": tolerance.relative,
        "zero": tolerance.zero,
        "ulps": tolerance.ulps,
    }
    return {name: str(amount) for name, amount in parts.items()}
