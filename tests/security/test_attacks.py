"""Every attack of the table, at every level this machine offers, as root and as a plain user.

By day each attack is made once: at the lowest level that promises to contain it, where nothing else stands
in its way, and by users who take turns; and some at the highest level and without any containment.
"""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
from attackers import LEVELS, USERS, Attacker, matrix
from table import ATTACKS, ONLY_FULL

NAMES = [attack.name for attack in ATTACKS]
BY_NAME = {attack.name: attack for attack in ATTACKS}
HIGHEST = ("read_answers", "list_root", "tcp_connect", "kill_everybody", "write_file", "fork")


def _by_day() -> Iterator[tuple[str, str, str]]:
    for turn, attack in enumerate(ATTACKS):
        lowest = "full" if attack.open_at == ONLY_FULL else "strong" if attack.open_at else "limits"
        user = USERS[-1] if attack.control == "root" else USERS[turn % len(USERS)]
        yield attack.name, LEVELS[turn % 3] if attack.ends else lowest, user
    for name in HIGHEST:
        yield name, "full", USERS[-1]
    yield "shrink_shared_memory", "limits", "plain"


BY_DAY = {*_by_day()}
CONTROLLED = {(name, "none", "plain") for name in (*HIGHEST, "hog_quiet")}


def test_every_attack_has_a_name_of_its_own_and_its_day() -> None:
    assert len(set(NAMES)) == len(NAMES)
    assert {*NAMES} == {name for name, _, _ in BY_DAY}


@pytest.mark.parametrize(("name", "level", "user"), matrix(NAMES, LEVELS, BY_DAY))
def test_attack_is_contained(attacker: Attacker, level: str, name: str, together: list[str]) -> None:
    attacker.require(level)
    attack = BY_NAME[name]
    outcome = attacker.outcomes("driver.py", level, together, json.dumps(together))[name]
    assert "fault" not in outcome, outcome
    if attack.ends:
        assert outcome["stop"] in {stop.value for stop in attack.ends}, outcome
    elif level not in attack.open_at:
        assert outcome["output"].startswith("held"), outcome


@pytest.mark.parametrize(("name", "level", "user"), matrix(NAMES, ["none"], CONTROLLED))
def test_attack_works_without_containment(
    attacker: Attacker, level: str, name: str, together: list[str]
) -> None:
    attack = BY_NAME[name]
    outcome = attacker.outcomes("driver.py", level, together, json.dumps(together))[name]
    works = {
        "breach": outcome["output"].startswith("BREACH"),
        "runs": outcome["ran_on"],
        "dies": outcome["signal"] > 0,
        "hogs": outcome["peak"] > 300 << 20,
        "floods": outcome["printed"] > 1 << 20,
    }
    if attack.control in ("maybe", "root"):
        if attack.control == "root" and attacker.name != "root":
            pytest.skip("only root can do this at all")
        if not works["breach"]:
            pytest.skip(f"this kernel does not let {attacker.name} do it: {outcome['output']}")
    elif attack.control:
        assert works[attack.control], outcome
