"""Compiled programs and their compiler, attacked at every level, as root and as a plain user."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import pytest
from attackers import Attacker
from native_table import BOMBS, COMPILE, MAYBE, RUN

from judge.languages import find
from judge.languages.boxes import recipe_of
from judge.languages.model import language_called

LEVELS = ["full", "strong"]  # at `limits` nothing is hidden and nothing refused
FOUND: dict[tuple[str, str], dict[str, Any]] = {}


@cache
def recipe() -> dict[str, Any]:
    language = language_called("c")
    assert language is not None
    if find.why_not(language):
        pytest.skip(find.remedy(language))
    made = recipe_of(find.toolchain(language))._asdict()
    return {**made, "empty": [made["empty"][0], made["empty"][1].decode()]}


def outcomes(attacker: Attacker, level: str, names: list[str]) -> dict[str, Any]:
    """What came of the attacks; they are made together, once."""
    key = (attacker.name, f"{level} {names[0]}")
    if key not in FOUND:
        given = json.dumps({"recipe": recipe(), "names": names})
        rows = attacker.run("native_driver.py", level, given=given)
        FOUND[key] = {row["name"]: row for row in rows}
    return FOUND[key]


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("name", RUN)
def test_a_program_gets_nowhere(attacker, level, name):
    attacker.require(level)
    outcome = outcomes(attacker, level, list(RUN))[name]
    assert "broken" not in outcome, outcome
    assert "fault" not in outcome, outcome
    assert "BREACH" not in outcome["output"], outcome
    assert outcome["output"].startswith("held") or outcome["stop"] == "exited", outcome


@pytest.mark.parametrize("name", RUN)
def test_without_containment_it_would(attacker, name):
    outcome = outcomes(attacker, "none", list(RUN))[name]
    assert "fault" not in outcome, outcome
    if name in MAYBE and "BREACH" not in outcome["output"]:
        pytest.skip(f"not even without containment here: {outcome['output']}")
    assert "BREACH" in outcome["output"], outcome


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("name", COMPILE)
def test_a_compiler_tells_nothing(attacker, level, name):
    attacker.require(level)
    outcome = outcomes(attacker, level, list(COMPILE))[name]
    assert "broken" not in outcome, outcome
    assert COMPILE[name][1] not in json.dumps(outcome), outcome
    assert "fault" in outcome, outcome


@pytest.mark.parametrize("name", COMPILE)
def test_without_containment_it_would_tell(attacker, name):
    assert COMPILE[name][1] in json.dumps(outcomes(attacker, "none", list(COMPILE))[name])


@pytest.mark.parametrize("name", BOMBS)
def test_a_bomb_for_the_compiler_is_its_own_fault(attacker, name):
    attacker.require("full")
    outcome = outcomes(attacker, "full", list(BOMBS))[name]
    assert outcome.get("fault"), outcome
    assert name != "large" or outcome["fault"] == "it compiles to more than 64 MB"


@pytest.mark.parametrize("level", ["strong", "limits"])
def test_a_bomb_is_so_at_the_lower_levels_too(attacker, level):
    attacker.require(level)
    assert outcomes(attacker, level, ["large"])["large"].get("fault")
