"""Imports point one way: a room of the package knows only those that stand after it here."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import judge

PACKAGE = Path(judge.__file__).parent
ROOMS = [
    *(
        "cli",
        "cluster",
        "batch",
        "judging",
        "report",
        "kata",
        "topics",
        "packs",
        "mistakes",
        "diagnose",
        "run",
    ),
    *("data", "problem", "drawing", "manual", "languages", "values", "exact", "database", "kept", "atomic"),
    *("digest", "reading", "folders", "errors"),
]


def imported(path: Path) -> set[str]:
    """The rooms of the package that a file imports from, wherever in it."""
    nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    names = [node.module for node in nodes if isinstance(node, ast.ImportFrom) and node.module]
    names += [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    names += [
        f"judge.{alias.name}"
        for node in nodes
        if isinstance(node, ast.ImportFrom) and node.module == "judge"
        for alias in node.names
    ]
    return {name.split(".")[1] for name in names if name.startswith("judge.")}


def files(room: str) -> list[Path]:
    folder = PACKAGE / room
    return sorted(folder.rglob("*.py")) if folder.is_dir() else [PACKAGE / f"{room}.py"]


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_knows_only_those_below_it(room):
    above = set(ROOMS[: ROOMS.index(room)])
    found = {path.relative_to(PACKAGE).as_posix(): imported(path) & above for path in files(room)}
    assert found
    assert {path: rooms for path, rooms in found.items() if rooms} == {}


def test_the_sandbox_knows_nothing_of_the_judge_but_its_errors():
    known = set().union(*(imported(path) for path in files("sandbox")))
    assert known <= {"sandbox", "errors"}


def test_every_room_has_its_place():
    rooms = {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").exists()}
    assert rooms <= {*ROOMS, "sandbox", "schema"}


def test_no_engine_room_knows_a_topic():
    found = {
        path.relative_to(PACKAGE).as_posix()
        for path in PACKAGE.rglob("*.py")
        if "topics" not in path.relative_to(PACKAGE).parts and "topics" in imported(path)
    }
    assert found == set()
