"""The JSON Schemas (draft 2020-12) of the files that a setter writes, as TOML: `files/<name>.json`.

What commands write with `--json` needs none: its schema is made of the structs, by `judge.cli.emit`.
"""

from __future__ import annotations

import json
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
