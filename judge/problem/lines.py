"""Finding the line of a TOML text that declares a key, so that a fault can be shown where it is."""

from __future__ import annotations

import re
from collections import defaultdict

KeyPath = tuple[str | int, ...]  # ("groups", 2, "seed")

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$")
_KEY = re.compile(
    r"\s*+((?:[A-Za-z0-9_-]++|\"[^\"]*+\"|'[^']*+')(?:\s*+\.\s*+(?:[A-Za-z0-9_-]++|\"[^\"]*+\"|'[^']*+'))*+)\s*+="
)
_PART = re.compile(r"[A-Za-z0-9_-]+|\"[^\"]*\"|'[^']*'")


def key_lines(text: str) -> dict[KeyPath, int]:
    """The line, from 1, of every table header and key that stands at the start of a line.

    Keys inside inline tables and arrays are not listed: their own key is (see `line_of`).
    """
    lines: dict[KeyPath, int] = {(): 1}
    sizes: defaultdict[KeyPath, int] = defaultdict(int)  # of each array of tables so far
    table: KeyPath = ()
    inside: str | None = None  # the quotes of the multi-line string we are in
    for number, line in enumerate(text.splitlines(), start=1):
        if inside is None:
            if header := _HEADER.match(line):
                table = _enter(_parts(header[2]), header[1] == "[[", sizes)
                lines.setdefault(table, number)
            elif key := _KEY.match(line):
                lines.setdefault(table + _parts(key[1]), number)
        inside = _quotes_open_after(line, inside)
    return lines


def line_of(path: KeyPath, lines: dict[KeyPath, int]) -> int:
    """The line of `path`, or of the nearest thing around it that has one."""
    while path not in lines:
        path = path[:-1]
    return lines[path]


def _parts(dotted: str) -> KeyPath:
    return tuple(part.strip("\"'") for part in _PART.findall(dotted))


def _enter(names: KeyPath, is_array: bool, sizes: defaultdict[KeyPath, int]) -> KeyPath:
    """The full path of a table header; a name that is an array of tables stands for its last element."""
    path: KeyPath = ()
    for depth, name in enumerate(names, start=1):
        path += (name,)
        if is_array and depth == len(names):
            sizes[path] += 1
        if sizes[path]:
            path += (sizes[path] - 1,)
    return path


def _quotes_open_after(line: str, inside: str | None) -> str | None:
    for quotes in re.findall(r"\"\"\"|'''", line):
        if inside is None:
            inside = quotes
        elif inside == quotes:
            inside = None
    return inside
