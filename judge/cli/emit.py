"""What becomes of a command's value: JSON on standard output, or its view on the screen.

A command returns a frozen Struct, or an iterator of them where the work is long; it never prints. A value
may have `exit_code`, `published` (what goes out as JSON instead of it: a tuple of structs, one a line) and
`paged` (whether the pager shows what is longer than the terminal), `plain` (text for another program, such as
CSV, which is written as it is).
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from inspect import cleandoc
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import msgspec
from msgspec import Struct

from judge.errors import ExitCode
from judge.schema import schema_of as written_schema

if TYPE_CHECKING:
    from judge.cli.options import Common


def emit(found: Struct | Iterable[Struct], common: Common) -> ExitCode:
    """Write each value as soon as it is there; the greatest `exit_code` of them all."""
    worst = ExitCode.ACCEPTED
    for value in (found,) if isinstance(found, Struct) else found:
        if common.json:
            for each in getattr(value, "published", (value,)):
                sys.stdout.write(msgspec.json.encode(each, enc_hook=_plain).decode() + "\n")
            sys.stdout.flush()
        elif plain := getattr(value, "plain", ""):
            sys.stdout.write(plain)
            sys.stdout.flush()
        else:
            _show(value)
        worst = max(worst, getattr(value, "exit_code", worst))
    return worst


def schema_of(command: click.Command) -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of one line that the command writes, from the type of its value.

    Raises KeyError where it writes none.
    """
    writes = getattr(command, "writes", None)
    if writes is None:
        return written_schema(str(command.name))
    kinds, parts = msgspec.json.schema_components(
        writes, schema_hook=lambda _type: {"type": "string"}, ref_template="#/$defs/{name}"
    )
    for part in parts.values():
        part["description"] = cleandoc(part.get("description", ""))
        if "properties" in part:  # every key is always there, and no other one
            part |= {"required": [*part["properties"]], "additionalProperties": False}
    dialect = "https://json-schema.org/draft/2020-12/schema"
    return {"$schema": dialect, **(kinds[0] if len(kinds) == 1 else {"anyOf": [*kinds]}), "$defs": parts}


def _plain(value: object) -> str:
    """Paths as text."""
    if isinstance(value, Path):
        return str(value)
    raise NotImplementedError(type(value))


def _show(value: Struct) -> None:
    from judge.report.screen import out, show, show_paged  # --json does without the screen
    from judge.report.views import view

    screen = out()
    (show_paged if getattr(value, "paged", False) else show)(view(value, screen), screen)
