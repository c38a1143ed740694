"""`judge schema`: the published JSON Schemas of what the commands write with `--json`, and of files."""

from __future__ import annotations

import json
import sys

import click

from judge.cli.options import json_option, write_json
from judge.errors import ExitCode, UsageError, nearest
from judge.schema import commands, files, schema_of, schema_of_file, whole


@click.command("schema")
@click.argument("name", metavar="[COMMAND]", required=False)
@json_option
def command(name: str | None, as_json: bool) -> ExitCode:
    """Print the JSON Schema of what a command writes with --json.

    Without a name: of every command. The schemas are draft 2020-12 and refuse unknown keys; each describes
    one line of output. `cards` and `checklist` describe files that a setter writes.
    """
    known = [*commands(), *files()]
    if name is not None and name not in known:
        meant = nearest(name, known)
        remedy = f"did you mean {meant!r}?" if meant else f"there are {', '.join(known)}"
        raise UsageError(f"there is no schema of {name!r}", remedy=remedy)
    schema = whole() if name is None else schema_of_file(name) if name in files() else schema_of(name)
    if as_json:
        write_json(schema)
        return ExitCode.ACCEPTED
    sys.stdout.write(json.dumps(schema, indent=2) + "\n")
    sys.stdout.flush()
    return ExitCode.ACCEPTED
