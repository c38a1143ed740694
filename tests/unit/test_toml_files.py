"""TOML files are parsed once, and what is kept is what the parser gave; each key has its line."""

from __future__ import annotations

import tomllib
from decimal import Decimal
from pathlib import Path

import pytest

import judge.problem.toml as toml_file
from judge.problem.find import shipped_problems
from judge.problem.lines import key_lines, line_of
from judge.problem.toml import read_toml

ODD = """
whole = 123456789012345678901234567890
yes = true
list = [1, 2.50, [], {x = 1e-400}]
text = "ä\\u0000\\"\\ud7ff"
none = [{}, ""]
[a.b."c d"]
wide = -0.0
"""


@pytest.fixture(autouse=True)
def _cache(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))


def same(one, other):
    """Equal, and of the same types: 1, 1.0 and True are three."""
    if type(one) is not type(other):
        return False
    if isinstance(one, dict):
        return list(one) == list(other) and all(same(one[key], other[key]) for key in one)
    if isinstance(one, list):
        return len(one) == len(other) and all(map(same, one, other))
    return str(one) == str(other)


@pytest.mark.parametrize("exact", [False, True])
def test_what_is_read_is_what_was_parsed(exact, monkeypatch):
    texts = [
        ODD,
        *(path.read_text(encoding="utf-8") for path in (shipped_problems() / "sets").glob("*.toml")),
    ]
    parsed = [tomllib.loads(text, parse_float=Decimal if exact else float) for text in texts]
    assert len(parsed) > 4
    for again in (False, True):
        if again:
            monkeypatch.setattr(toml_file, "toml_of", lambda *_, **__: pytest.fail("it is parsed again"))
        for place, text in enumerate(texts):
            assert same(read_toml(Path(f"/{place}"), text, "it", exact=exact), parsed[place]), text


@pytest.mark.parametrize("text", ["day = 2026-11-22", '"" = 1', '[x]\n"" = "1"'])
def test_what_json_cannot_hold_is_parsed_each_time(text, tmp_path):
    for _ in range(2):
        assert read_toml(Path("/here"), text, "it", exact=True) == tomllib.loads(text)
    assert not list(tmp_path.rglob("*.json"))


TEXT = '''summary = """
entry = "not a key"
[[groups]]
"""
[limits]  # of a group
cpu_seconds = 1

[[groups]]
  [groups.tolerance]
  ulps = 4

[[groups]]
"name" = "second"
parameters = { size = 3 }
tolerance.relative = 1
'''


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("entry",), 1),  # only text inside a string: the file itself
        (("limits", "cpu_seconds"), 6),
        (("groups", 0, "tolerance", "ulps"), 10),
        (("groups", 1, "name"), 13),
        (("groups", 1, "parameters", "size"), 14),  # inside an inline table: its key
        (("groups", 1, "tolerance", "relative"), 15),
        (("groups", 1, "seed"), 12),  # missing: its table
    ],
)
def test_line_of_a_path(path, line):
    assert line_of(path, key_lines(TEXT)) == line
