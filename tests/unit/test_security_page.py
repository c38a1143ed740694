"""The page about security: each attack of `judge doctor --attack` is a promise's, and each test is there."""

from __future__ import annotations

import re
from pathlib import Path

from judge.sandbox.attacks import ATTACKS

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "judge" / "manual" / "security.md").read_text(encoding="utf-8")
ROWS = [
    [cell.strip() for cell in line.split("|")[1:-1]] for line in PAGE.splitlines() if line.startswith("| ")
]
PROMISES = [row for row in ROWS if len(row) == 5 and row[1] in ("yes", "no")]
ALWAYS = {"environment", "descriptors", "limits", "memory", "output", "loop", "sleep"}


def attacks_of(row):
    return re.findall(r"`([\w-]+)`", row[4])


def test_each_attack_is_named_once_beside_a_promise():
    named = [name for row in PROMISES for name in attacks_of(row)]
    assert sorted(named) == sorted(attack.name for attack in ATTACKS)


def test_what_is_promised_at_limits_is_what_holds_there():
    for row in PROMISES:
        for name in attacks_of(row):
            assert (row[3] == "yes") == (name in ALWAYS), name


def test_every_file_it_names_is_there():
    named = re.findall(r"`((?:tests|judge)/[\w./-]+\.(?:py|toml))`", PAGE)
    assert len(named) > 15
    assert [path for path in named if not (ROOT / path).exists()] == []
