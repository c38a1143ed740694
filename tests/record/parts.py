"""The parts of the record, and where each is kept: a file of JSON lines a kata, a text a transcript."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

from record import packages, pictures, programs, transcripts
from record.steady import steadied

PARTS = ("programs", "pictures", "packages", "transcripts")
_OF_KATAS = {"programs": programs.record, "pictures": pictures.record, "packages": packages.record}


class Item(NamedTuple):
    """A kata's programs, pictures or packages, or a transcript."""

    part: str
    key: str

    @property
    def path(self) -> Path:
        """The file it is kept in."""
        if self.part == "transcripts":
            return transcripts.path_of(self.key)
        return transcripts.RECORD / self.part / f"{self.key}.jsonl"


def keys(part: str) -> list[str]:
    """The items of a part."""
    return transcripts.names() if part == "transcripts" else programs.katas()


def kept(item: Item) -> dict[str, Any]:
    """What was kept, by key; nothing where nothing was."""
    if not item.path.exists():
        return {}
    text = item.path.read_text(encoding="utf-8")
    if item.part == "transcripts":
        return {item.key: text}
    lines = map(json.loads, text.splitlines())
    return {line.pop("key"): line for line in lines}


def now(item: Item, world: Path) -> dict[str, Any]:
    """What the judge says now; `world` is a folder to work in, which may be shared."""
    if item.part != "transcripts":
        return json.loads(json.dumps(_OF_KATAS[item.part](item.key)))
    world.mkdir(parents=True, exist_ok=True)
    with steadied(world.parent):
        return {item.key: transcripts.played(item.key, world)}


def write(item: Item, found: dict[str, Any]) -> None:
    """Keep this."""
    item.path.parent.mkdir(parents=True, exist_ok=True)
    if item.part == "transcripts":
        text = found[item.key]
    else:
        lines = [json.dumps({"key": key, **found[key]}, ensure_ascii=False) for key in found]
        text = "".join(f"{line}\n" for line in lines)
    item.path.write_text(text, encoding="utf-8", newline="\n")
