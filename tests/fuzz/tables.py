"""Changing a TOML text where it means something: its keys, values and tables, a line at a time.

Most of what comes out is TOML still, of a shape or with values that nobody meant.
"""

from __future__ import annotations

import random
import re

from mangle import pool

_PAIR = re.compile(r"^(?P<indent>\s*)(?P<key>[\w-]+)(?P<equals>\s*=\s*)(?P<value>.*)$")
_HEADER = re.compile(r"^\[+.*\]+\s*$")

_DEEP_TABLE = "{a=" * 300 + "1" + "}" * 300
_NUMBERS = (*pool("numbers"), *("9" * count for count in (400, 4300, 4301, 20_000)), "0." + "3" * 5000)
_TEXTS = (*pool("texts"), f'"{"x" * 20_000}"', f'"{"x " * 5_000}"')
_OTHERS = (*pool("others"), "[" * 3000 + "]" * 3000, _DEEP_TABLE)
_LINES = (*pool("lines"), "seed = 1" + "0" * 400)
_CALM = re.compile(r"count|points|size|cpu_seconds|wall_seconds")  # where a big number is only much work
_SMALL = (*pool("small"), "9" * 400)


def changed_table(chance: random.Random, text: str) -> tuple[str, str]:
    """The text with one change, and what was done to it."""
    lines = text.splitlines()
    pairs = [at for at, line in enumerate(lines) if _PAIR.match(line)]
    headers = [at for at, line in enumerate(lines) if _HEADER.match(line)]
    change = chance.choice(
        ("value", "value", "value", "value", "key", "gone", "twice", "swap", "add", "table")
    )
    if change == "value" and pairs:
        return _other_value(chance, lines, chance.choice(pairs))
    if change == "key" and pairs:
        return _other_key(chance, lines, chance.choice(pairs), pairs)
    if change == "table" and headers:
        return _whole_table(chance, lines, headers)
    at = chance.randrange(len(lines) + 1)
    if change == "gone" and lines:
        at = chance.choice(pairs or [0])
        return f"without {lines[at][:60]!r}", _joined([*lines[:at], *lines[at + 1 :]])
    if change == "twice" and lines:
        at = chance.choice(pairs or [0])
        return f"{lines[at][:60]!r} twice", _joined([*lines[:at], lines[at], *lines[at:]])
    if change == "swap" and len(pairs) > 1:
        one, other = chance.sample(pairs, 2)
        lines[one], lines[other] = lines[other], lines[one]
        return f"lines {one + 1} and {other + 1} swapped", _joined(lines)
    line = chance.choice(_LINES)
    return f"{line[:60]!r} added at {at + 1}", _joined([*lines[:at], line, *lines[at:]])


def _other_value(chance: random.Random, lines: list[str], at: int) -> tuple[str, str]:
    found = _PAIR.match(lines[at])
    assert found
    calm = _CALM.search(lines[at])
    value = chance.choice(chance.choice((_SMALL if calm else _NUMBERS, _TEXTS, _OTHERS)))
    inner = re.search(r"(?<== )[^={}]+(?=[ ,}])", found["value"]) if "{" in found["value"] else None
    if inner and chance.random() < 0.7:  # a value of an inline table
        start = found.start("value") + inner.start()
        lines[at] = lines[at][:start] + value + lines[at][start + len(inner[0]) :]
    else:
        lines[at] = f"{found['indent']}{found['key']}{found['equals']}{value}"
    return f"line {at + 1}: {lines[at][:80]}", _joined(lines)


def _other_key(chance: random.Random, lines: list[str], at: int, pairs: list[int]) -> tuple[str, str]:
    found, donor = _PAIR.match(lines[at]), _PAIR.match(lines[chance.choice(pairs)])
    assert found
    assert donor
    key = chance.choice((donor["key"], found["key"][:-1] or "x", f'"{found["key"]}"', '""', '"\\u0000"', "é"))
    lines[at] = f"{found['indent']}{key}{found['equals']}{found['value']}"
    return f"line {at + 1}: {lines[at][:80]}", _joined(lines)


def _whole_table(chance: random.Random, lines: list[str], headers: list[int]) -> tuple[str, str]:
    """A table is gone, twice, or has another header."""
    index = chance.randrange(len(headers))
    start = headers[index]
    end = headers[index + 1] if index + 1 < len(headers) else len(lines)
    header, block = lines[start], lines[start:end]
    match chance.choice(("gone", "twice", "header")):
        case "gone":
            return f"without {header} of line {start + 1}", _joined([*lines[:start], *lines[end:]])
        case "twice":
            return f"{header} of line {start + 1} twice", _joined([*lines[:end], *block, *lines[end:]])
        case _:
            lines[start] = chance.choice(
                ("[x]", header.strip("[]"), f"[{header}]", "[groups]", "[[limits]]", "[.]")
            )
            return f"line {start + 1}: {lines[start]}", _joined(lines)


def _joined(lines: list[str]) -> str:
    return "\n".join(lines) + "\n"
