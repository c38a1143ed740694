"""The JSON Schemas (draft 2020-12) of what commands write with `--json`, made of their structs, and of the
files that a setter writes, as TOML: `files/<name>.json`.
"""

from __future__ import annotations

import json
from inspect import cleandoc
from pathlib import Path
from typing import Any

_FOLDER = Path(__file__).parent / "files"

Schema = dict[str, Any]


def files() -> list[str]:
    """The names of the files' schemas, in order of name."""
    return sorted(path.stem for path in _FOLDER.glob("*.json"))


def schema_of_file(name: str) -> Schema:
    """The schema of a file that a setter writes. Raises KeyError if there is none of that name."""
    if name not in files():
        raise KeyError(name)
    schema: Schema = json.loads((_FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    return schema


def schema_of(command: Any) -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of one line that the command writes, from the type of its value.

    Raises KeyError where it writes none.
    """
    import msgspec  # hardly ever

    writes = getattr(command, "writes", None)
    if writes is None:
        raise KeyError(command.name)
    kinds, parts = msgspec.json.schema_components(
        writes, schema_hook=lambda _type: {"type": "string"}, ref_template="#/$defs/{name}"
    )
    for part in parts.values():
        part["description"] = cleandoc(part.get("description", ""))
        if "properties" in part:  # every key is always there, and no other one
            part |= {"required": [*part["properties"]], "additionalProperties": False}
    dialect = "https://json-schema.org/draft/2020-12/schema"
    return {"$schema": dialect, **(kinds[0] if len(kinds) == 1 else {"anyOf": [*kinds]}), "$defs": parts}
