"""The options of the commands that judge."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from judge.errors import UsageError
from judge.sandbox.boundary import LEVELS

F = TypeVar("F", bound=Callable[..., Any])
PROGRAM, _AUTO = MODES = ("program", "auto")
TEXT, JSON, GITHUB, EDITOR = FORMATS = ("text", "json", "github", "editor")

isolation_option: Callable[[F], F] = click.option(
    "--isolation",
    "level",
    metavar="LEVEL",
    type=click.Choice(LEVELS),
    help="Demand full, strong or limits; the best available by default. See 'judge doctor'.",
)
jobs_option: Callable[[F], F] = click.option(
    "-j",
    "--jobs",
    type=click.IntRange(1, 256),
    default=1,
    metavar="N",
    help="Judge N files at once; timing stays one at a time.",
)
no_name_option: Callable[[F], F] = click.option("--no-name", is_flag=True, help="Do not name the mistake.")
no_shrink_option: Callable[[F], F] = click.option(
    "--no-shrink", "unshrunk", is_flag=True, help="Do not search for the smallest failing case."
)
svg_option: Callable[[F], F] = click.option(
    "--svg",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Draw the failing case into an SVG file.",
)
all_option: Callable[[F], F] = click.option(
    "--all", "whole", is_flag=True, help="Show everything, with a table of all test groups."
)
picture_option: Callable[[F], F] = click.option(
    "--picture", "pictured", is_flag=True, help="Draw the failing case on a low terminal too."
)
mode_option: Callable[[F], F] = click.option(
    "--mode",
    metavar="MODE",
    type=click.Choice(MODES),
    help="program: run the file as a program, even if it defines the function.",
)
follow_links_option: Callable[[F], F] = click.option(
    "--follow-links", is_flag=True, help="Follow links in a folder, wherever they lead."
)
format_option: Callable[[F], F] = click.option(
    "--format",
    "form",
    metavar="FORMAT",
    type=click.Choice(FORMATS),
    help="text, json (as --json), github (annotations) or editor (FILE:LINE:COLUMN: error: …).",
)
junit_option: Callable[[F], F] = click.option(
    "--junit",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Also write the results as JUnit XML.",
)
no_history_option: Callable[[F], F] = click.option(
    "--no-history", "unrecorded", is_flag=True, help="Keep nothing in the history."
)


def chosen_format(form: str | None, *, as_json: bool) -> str:
    """The format that the options come to. Raises UsageError where they contradict each other."""
    if as_json and form not in (None, JSON):
        raise UsageError(f"--json and --format {form} contradict each other", remedy="leave one out")
    return JSON if as_json else form or TEXT
