"""The harmless attacks: each works without containment, and is held at the upper levels."""

from __future__ import annotations

import re
import socket
import tempfile
from pathlib import Path
from typing import Any

import pytest
from attackers import Attacker
from attacking import targets
from attacks import ATTACKS
from sampling import nightly

from judge.manual import page

NAMES = [attack.name for attack in ATTACKS]
MAYBE = {"namespace", "trace", "memory-of-others", "proc"}  # what some kernels let nobody do
ALWAYS = {"environment", "descriptors", "limits", "memory", "output", "loop", "sleep"}  # held at `limits` too
FOUND: dict[tuple[str, str], dict[str, dict[str, Any]]] = {}


def outcomes(attacker: Attacker, level: str) -> dict[str, dict[str, Any]]:
    """What came of all attacks; they are made together, once."""
    if (attacker.name, level) not in FOUND:
        rows = attacker.run("harmless.py", level)
        FOUND[attacker.name, level] = {row["name"]: row for row in rows}
    return FOUND[attacker.name, level]


def test_there_are_twenty_at_least_and_each_has_a_name() -> None:
    assert len(set(NAMES)) == len(NAMES) >= 20


def test_the_socket_to_attack_has_a_name_that_fits_wherever_temporary_files_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    deep = tmp_path / ("x" * 120)
    deep.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(deep))
    with targets([]) as target, socket.socket(socket.AF_UNIX) as caller:
        caller.connect(target["socket"])
        assert Path(target["private"]).read_text() == "private"
    assert not Path(target["folder"]).exists()


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("level", ["full", nightly("strong")])
def test_it_is_held(attacker: Attacker, level: str, name: str) -> None:
    attacker.require(level)
    outcome = outcomes(attacker, level)[name]
    assert outcome["held"], outcome
    assert outcome["how"], outcome


@pytest.mark.nightly
@pytest.mark.parametrize("name", NAMES)
def test_it_is_an_attack(attacker: Attacker, name: str) -> None:
    outcome = outcomes(attacker, "none")[name]
    if name in MAYBE and not outcome["works"]:
        pytest.skip(f"this kernel does not let {attacker.name} do it: {outcome['how']}")
    assert outcome["works"], outcome


@pytest.mark.nightly
def test_what_limits_does_not_hold_is_said(attacker: Attacker) -> None:
    attacker.require("limits")
    found = outcomes(attacker, "limits")
    broken = {name for name, outcome in found.items() if not outcome["held"]}
    assert {"judge", "file", "connect", "write"} <= broken
    assert not broken & ALWAYS
    assert all("BREACH" in found[name]["how"] for name in broken), found


# -- what the manual promises -------------------------------------------------------------------------------

ROWS = [
    [cell.strip() for cell in line.split("|")[1:-1]]
    for line in page("sandbox").text.splitlines()
    if line.startswith("| ")
]
PROMISES = [row for row in ROWS if len(row) == 3 and row[1] in ("yes", "no")]


def attacks_of(row: list[str]) -> list[str]:
    return re.findall(r"`([\w-]+)`", row[2])


def test_each_attack_is_named_once_beside_a_promise() -> None:
    named = [name for row in PROMISES for name in attacks_of(row)]
    assert sorted(named) == sorted(NAMES)


def test_what_is_promised_at_limits_is_what_holds_there() -> None:
    for row in PROMISES:
        for name in attacks_of(row):
            assert (row[1] == "yes") == (name in ALWAYS), name
