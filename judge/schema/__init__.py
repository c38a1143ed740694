"""The published JSON Schemas (draft 2020-12) of what `--json` writes: one file for each command.

    judge/schema/<command>.json    an object as the command writes it; its own $defs are in it
    judge/schema/shared.json       $defs that several commands use, as {"$ref": "shared.json#/$defs/verdict"};
                                   `result` is generated from the structs that are written
    judge/schema/files/<name>.json files that a setter writes, as TOML

A command whose value is a struct needs no file: its schema is made of the type. `schema_of` puts a command's
file and what it refers to into one document that needs no other.
"""

from __future__ import annotations

import json
from inspect import cleandoc
from pathlib import Path
from typing import Any

_FOLDER = Path(__file__).parent
_SHARED = "shared.json"
_LOCAL = "#/$defs/"
RESULT = "result"  # of shared.json, but in no file

Schema = dict[str, Any]


def commands() -> list[str]:
    """The commands that have a schema, in order of name."""
    return sorted(path.stem for path in _FOLDER.glob("*.json") if path.name != _SHARED)


def schema_of(command: str) -> Schema:
    """The schema of one command's objects, complete in itself. Raises KeyError if there is none."""
    if command not in commands():
        raise KeyError(command)
    definitions: dict[str, Schema] = {}
    schema: Schema = _bundled(f"{command}.json", _read(f"{command}.json"), definitions)
    schema.pop("$defs", None)
    return schema | ({"$defs": dict(sorted(definitions.items()))} if definitions else {})


def files() -> list[str]:
    """The names of the files' schemas, in order of name."""
    return sorted(path.stem for path in (_FOLDER / "files").glob("*.json"))


def schema_of_file(name: str) -> Schema:
    """The schema of a file that a setter writes. Raises KeyError if there is none of that name."""
    if name not in files():
        raise KeyError(name)
    return _read(f"files/{name}.json")


def _bundled(file: str, schema: Any, definitions: dict[str, Schema]) -> Any:
    """A part of `file` with its references turned into ones to `definitions`, where their targets are put."""
    if isinstance(schema, list):
        return [_bundled(file, part, definitions) for part in schema]
    if not isinstance(schema, dict):
        return schema
    bundled = {key: _bundled(file, part, definitions) for key, part in schema.items() if key != "$defs"}
    target = schema.get("$ref")
    if isinstance(target, str) and not target.startswith("https:"):
        home, _, name = target.partition(_LOCAL)
        home = home or file
        # A command's own definitions are named after it: several commands have a `group`.
        known = name if home == _SHARED else f"{home.removesuffix('.json')}.{name}"
        if home == _SHARED and name == RESULT:
            definitions |= _of_results()
        elif known not in definitions:
            definitions[known] = {}  # before its own references are followed, which may come back to it
            definitions[known] = _bundled(home, _read(home)["$defs"][name], definitions)
        bundled["$ref"] = _LOCAL + known
    return bundled


def _of_results() -> dict[str, Schema]:
    """A result and its parts, from the structs that are written."""
    import msgspec

    from judge.run.result import Result

    (result,), parts = msgspec.json.schema_components([Result], ref_template=_LOCAL + "{name}")
    for part in parts.values():
        part["description"] = cleandoc(part.get("description", ""))
        if "properties" in part:  # every key is always there, and no other one
            part |= {"required": list(part["properties"]), "additionalProperties": False}
    return {**parts, RESULT: result}


def _read(file: str) -> Schema:
    schema: Schema = json.loads((_FOLDER / file).read_text(encoding="utf-8"))
    return schema
