"""Every attack of the table, at every level this machine offers, as root and as a plain user."""

from __future__ import annotations

import pytest
from attackers import HERE, Attacker
from table import ATTACKS, Attack

LEVELS = ["full", "strong", "limits"]
NAMES = [attack.name for attack in ATTACKS]


def _by_name(attack: Attack) -> str:
    return attack.name


def test_every_script_has_a_row_and_every_row_a_script() -> None:
    assert sorted(path.stem for path in (HERE / "attacks").glob("*.py")) == sorted(NAMES)


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("attack", ATTACKS, ids=_by_name)
def test_attack_is_contained(attacker: Attacker, level: str, attack: Attack) -> None:
    attacker.require(level)
    outcome = attacker.outcomes(level, NAMES)[attack.name]
    assert "fault" not in outcome, outcome
    if attack.ends:
        assert outcome["stop"] in {stop.value for stop in attack.ends}, outcome
    elif level not in attack.open_at:
        assert outcome["output"].startswith("held"), outcome


@pytest.mark.parametrize("attack", ATTACKS, ids=_by_name)
def test_attack_works_without_containment(attacker: Attacker, attack: Attack) -> None:
    outcome = attacker.outcomes("none", NAMES)[attack.name]
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
