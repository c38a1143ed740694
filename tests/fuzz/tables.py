"""Changing a TOML text where it means something: its keys, values and tables, a line at a time.

Most of what comes out is TOML still, of a shape or with values that nobody meant.
"""

from __future__ import annotations

import random
import re

_PAIR = re.compile(r"^(?P<indent>\s*)(?P<key>[\w-]+)(?P<equals>\s*=\s*)(?P<value>.*)$")
_HEADER = re.compile(r"^\[+.*\]+\s*$")

_NUMBERS = (
    *(
        "0",
        "-0",
        "1",
        "-1",
        "2",
        "100",
        "101",
        "0.5",
        "-0.0",
        "0.0",
        "1e-9",
        "1e9",
        "1e400",
        "-1e400",
        "1e-400",
    ),
    *("1e4000", "1e4001", "-1e4001", "1e-4001", "1e999999999", "1e-999999999", "nan", "-nan", "inf", "-inf"),
    *("0x7fffffffffffffff", "9223372036854775808", "-9223372036854775809", "9" * 400, "9" * 4300, "9" * 4301),
    *("9" * 20_000, "0." + "3" * 5000, "0.1e-300", "123_456", "0o17", "0b1"),
)
_TEXTS = (
    *(
        '""',
        '" "',
        '"x"',
        "'x'",
        '"\\u0000"',
        '"\\u001b[31mred"',
        '"\\n"',
        '"a\\nb"',
        '"\\u202eabc"',
        '"\\ufeff"',
    ),
    *(
        '"None"',
        '"class"',
        '"print"',
        '"__import__"',
        '"é"',
        '"ａ"',
        '"a b"',
        '"a.b"',
        '"../x"',
        '"/etc/passwd"',
    ),
    *(
        '"examples"',
        '"count"',
        '"points"',
        '"parameter"',
        '"number"',
        '"integer"',
        '"point"',
        '"integer-point"',
    ),
    *(
        '"\\"\\"\\""',
        '"\\\\"',
        '"{{a.low}}"',
        '"{{"',
        '"%s"',
        '"]]>"',
        '"<b>"',
        '"\\U0001F600"',
        '"1"',
        '"nan"',
    ),
    *('"junior"', '"professional"', f'"{"x" * 20_000}"', f'"{"x " * 5_000}"', '"""\na\nb\n"""', "'''\n'''"),
    *(
        '"x.py"',
        '".py"',
        '"..py"',
        '"quadratic.py"',
        '"exact.py"',
        '"program.py"',
        '"floor-division"',
        '"Émile"',
    ),
    '"\\u0007\\u0008\\u007f\\u0085\\u2028"',
)
_OTHERS = (
    *(
        "true",
        "false",
        "[]",
        "{}",
        "[1]",
        "[1, 2]",
        "[true]",
        '["a"]',
        '["a", "a"]',
        "[[]]",
        "[{}]",
        "{ a = 1 }",
    ),
    *(
        "1979-05-27",
        "07:32:00",
        "1979-05-27T07:32:00Z",
        "[nan]",
        "[1e4000]",
        '{ "" = 1 }',
        "{ a = { b = 1 } }",
    ),
    *('{ "\\u0000" = 1 }', "[" * 50 + "]" * 50, "[" * 3000 + "]" * 3000, "{a=" * 300 + "1" + "}" * 300),
    *('{ size = "x" }', "{ size = -1 }", "{ size = 0 }", "{ self = 1 }", "{ draw = 1 }", "{ size = 1e400 }"),
    *("{ odd = 7 }", "{ odd = [] }", '["examples"]', '[""]', "", "#", "=", "x", '"', "[", "{"),
)
_LINES = (
    *(
        "[parameters]",
        "[[parameters]]",
        "[groups]",
        "[[groups]]",
        "[limits]",
        "[tolerance]",
        "[time]",
        "[bands]",
    ),
    *(
        "[[time]]",
        "[x]",
        "[[x]]",
        "[groups.tolerance]",
        "[a.b.c]",
        "[]",
        '[""]',
        "x = 1",
        '"" = 1',
        "a.b = 1",
    ),
    *('"a.b" = 1', "bands.x = 1", "limits.cpu_seconds = 1", "parameters = []", "groups = []", "time = {}"),
    *('kills = ["x"]', "skills = []", 'problems = ["count"]', "needs = []", "= 1", "\\", "[[groups]] # x"),
    *('[time]\nlimit = 2\nfunction = "exact.py"', '[time]\nlimit = 1e300\nfunction = "mean.py"', "count = 3"),
    *("[bands]\ntangent = 1e-9", "[bands]\nx = nan", "seed = -1", "seed = 1" + "0" * 400, "tolerance = 1"),
)
_CALM = re.compile(r"count|points|size|cpu_seconds|wall_seconds")  # where a big number is only much work
_SMALL = ("0", "-1", "1", "2", "3.5", "1e-9", "-0.0", "nan", "inf", "1e400", "-5", "9" * 30, "9" * 400)


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
