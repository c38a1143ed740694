"""The page about problem.toml says what the loader knows: every key, nothing else, and examples that load."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import msgspec
import pytest

from judge.problem import schema
from judge.problem.load import load_problem
from judge.values.grammar import ALIASES, VECTORS

ROOT = Path(__file__).parents[2]
MANUAL = ROOT / "judge" / "manual"
PAGE = (MANUAL / "problem-toml.md").read_text(encoding="utf-8")
TABLES = {
    "The file": schema.ProblemTable,
    "Parameters": schema.ParameterTable,
    "Limits": schema.LimitsTable,
    "Tolerance": schema.ToleranceTable,
    "Time": schema.TimeTable,
    "Growth": schema.GrowthTable,
    "Groups": schema.GroupTable,
    "Time of a group": schema.GroupTimeTable,
    "Limits of a group": schema.GroupLimitsTable,
    "Sets and skills": schema.SkillTable,
    "Words": schema.WordsTable,
    "Source": schema.SourceTable,
}
BASE = """\
title = "T"
tier = "junior"
summary = "S."
entry = "f"
answer = "count"

[limits]
cpu_seconds = 2
wall_seconds = 6
memory_mb = 256
output_mb = 4

[[parameters]]
name = "n"
type = "integer"
low = 0
high = 9
about = "a number"

[[groups]]
name = "small"
about = "All."
builder = "numbers"
seed = 1
count = 10
points = 100
"""


def sections() -> dict[str, str]:
    parts = re.split(r"^## (.*)$", PAGE, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def told(section: str) -> dict[str, bool]:
    """The keys of a section's table, each with whether it may be missing."""
    rows = re.findall(r"^\| `(\w+)` \| (yes|no) \|", sections()[section], re.MULTILINE)
    return {key: word == "yes" for key, word in rows}


def test_every_key_of_the_loader_is_told_and_no_other_with_an_example():
    tables = {*schema._TABLES.values(), *schema._TABLES_OF_GROUPS.values(), schema.ProblemTable}
    assert tables == set(TABLES.values())
    for section, table in TABLES.items():
        assert told(section) == {field.name: not field.required for field in msgspec.structs.fields(table)}
        assert "```toml" in sections()[section], section


def head_and_tables(text: str) -> tuple[str, list[str]]:
    head, *tables = re.split(r"^(?=\[)", text, flags=re.MULTILINE)
    return head, tables


def completed(example: str) -> str:
    """A whole problem.toml: the example, and of the base what it does not say itself."""
    own = set(tomllib.loads(example))
    head, tables = head_and_tables(BASE)
    lines = [line for line in head.splitlines() if line.partition(" = ")[0] not in own]
    kept = [table for table in tables if not set(tomllib.loads(table)) <= own]
    example_head, example_tables = head_and_tables(example)
    return "\n".join([example_head, *lines, "", *example_tables, *kept])


def loaded(example: str, folder: Path):
    place = folder / "divisors"
    place.mkdir()
    (place / "problem.toml").write_text(completed(example), encoding="utf-8")
    entry = tomllib.loads(completed(example))["entry"]
    worked = f"    >>> {entry}(1)\n    1\n" if 'builder = "examples"' in example else ""
    (place / "statement.md").write_text(f"# T\n\n{worked}")
    return load_problem(place)


EXAMPLES = re.findall(r"^```toml\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda text: text.split("\n")[0])
def test_the_examples_are_loaded(example, tmp_path):
    problem = loaded(example, tmp_path)
    groups = tomllib.loads(example).get("groups", [{"name": "small"}])
    assert [group.name for group in problem.groups] == [each["name"] for each in groups]


def test_every_type_of_the_loader_is_told():
    rows = set(re.findall(r"`([^`]+)`", re.sub(r"^```.*?^```$", "", sections()["Types"], flags=re.M | re.S)))
    told = {word for row in rows for word in re.findall(r"^[a-z][a-z0-9-]*", row)}
    atoms = {path.stem for path in (MANUAL.parent / "values" / "atoms").glob("[a-z]*.py")}
    assert atoms
    assert {*ALIASES, *VECTORS, *atoms} <= told
