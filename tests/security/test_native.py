"""Compiled programs and their compilers: attacked, and at work, at every level, as root and as a plain user.

By day each attack is made at the lowest level that contains it, by users who take turns; at `limits` nothing
is hidden and nothing refused.
"""

from __future__ import annotations

import base64
import json
import os
import pickle
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from attackers import LEVELS, USERS, Attacker, by_turns, matrix
from native_table import BOMBS, COMPILE, MAYBE, RUN, SOURCES

from judge.languages import find
from judge.languages.boxes import recipe_of
from judge.languages.model import language_called
from judge.sandbox.recipe import Recipe

ADDING = {  # the sum of two numbers on a line
    "c": '#include <stdio.h>\nint main(void) { int a, b; scanf("%d%d", &a, &b); printf("%d\\n", a + b); }',
    "cpp": "#include <iostream>\nint main() { int a, b; std::cin >> a >> b; std::cout << a + b << '\\n'; }",
    "go": 'package main\nimport "fmt"\nfunc main() { var a, b int; fmt.Scan(&a, &b); fmt.Println(a + b) }',
    "rust": (
        "use std::io::*;\nfn main() { let mut t = String::new(); stdin().read_to_string(&mut t).unwrap();"
        ' println!("{}", t.split_whitespace().map(|w| w.parse::<i32>().unwrap()).sum::<i32>()); }'
    ),
    "java": (
        "import java.util.*;\npublic class Main { public static void main(String[] w) {"
        " var in = new Scanner(System.in); System.out.println(in.nextInt() + in.nextInt()); } }"
    ),
    "javascript": (
        "const w = require('fs').readFileSync(0, 'utf8').trim().split(/\\s+/).map(Number);"
        " console.log(w[0] + w[1]);"
    ),
    "pypy": "print(sum(map(int, input().split())))",
}
CONTAINED = ("full", "strong")
HIGHEST = ("read_answers", "connect", "signal_all", "make_file", "program_in_memory")
OF_ROOT = ("privileged", "read_shadow")  # which a plain user may not do anyway
LOWEST = {
    (name, "strong", USERS[-1 if name in OF_ROOT else turn % len(USERS)])
    for turn, name in enumerate([*RUN, *COMPILE])
}
CONTROLLED = ("read_answers", "connect", "fork")


@cache
def recipe(name: str) -> Recipe:
    language = language_called(name)
    assert language is not None
    if find.why_not(language):
        pytest.skip(find.remedy(language))
    return recipe_of(find.toolchain(language))


def outcomes(attacker: Attacker, level: str, names: Sequence[str]) -> dict[str, Any]:
    """What came of attacks in C, or of adding in a language."""
    orders = [(name, recipe(name if name in ADDING else "c"), (SOURCES | ADDING)[name]) for name in names]
    return attacker.outcomes(
        "native_driver.py", level, names, base64.b64encode(pickle.dumps(orders)).decode()
    )


def at(level: str, names: Iterable[str]) -> set[tuple[str, str, str]]:
    """These names at one level, as the last of the users."""
    return {(name, level, USERS[-1]) for name in names}


@pytest.mark.parametrize(
    ("name", "level", "user"),
    matrix(RUN, CONTAINED, {each for each in LOWEST if each[0] in RUN} | at("full", HIGHEST)),
)
def test_a_program_gets_nowhere(attacker, level, name, together):
    attacker.require(level)
    found = outcomes(attacker, level, together)[name]
    assert "broken" not in found, found
    assert "fault" not in found, found
    assert "BREACH" not in found["output"], found
    assert found["output"].startswith("held") or found["stop"] == "exited", found


@pytest.mark.parametrize(("name", "level", "user"), matrix(RUN, ["none"], at("none", CONTROLLED)))
def test_without_containment_it_would(attacker, level, name, together):
    found = outcomes(attacker, level, together)[name]
    assert "fault" not in found, found
    if name in MAYBE and "BREACH" not in found["output"]:
        pytest.skip(f"not even without containment here: {found['output']}")
    assert "BREACH" in found["output"], found


@pytest.mark.parametrize(
    ("name", "level", "user"), matrix(COMPILE, CONTAINED, {each for each in LOWEST if each[0] in COMPILE})
)
def test_a_compiler_tells_nothing(attacker, level, name, together):
    attacker.require(level)
    found = outcomes(attacker, level, together)[name]
    assert "broken" not in found, found
    assert COMPILE[name][1] not in json.dumps(found), found
    assert "fault" in found, found


@pytest.mark.parametrize(("name", "level", "user"), matrix(COMPILE, ["none"], ()))
def test_without_containment_it_would_tell(attacker, level, name, together):
    assert COMPILE[name][1] in json.dumps(outcomes(attacker, level, together)[name])


@pytest.mark.parametrize(("name", "level", "user"), matrix(BOMBS, ["full"], at("full", ["large", "itself"])))
def test_a_bomb_for_the_compiler_is_its_own_fault(attacker, level, name, together):
    attacker.require(level)
    found = outcomes(attacker, level, together)[name]
    assert found.get("fault"), found
    assert name != "large" or found["fault"] == "it compiles to more than 64 MB"


@pytest.mark.parametrize(("name", "level", "user"), matrix(["large"], ["strong", "limits"], ()))
def test_a_bomb_is_so_at_the_lower_levels_too(attacker, level, name, together):
    attacker.require(level)
    assert outcomes(attacker, level, together)[name].get("fault")


def closed_to(attacker: Attacker, name: str) -> bool:
    """Whether the tools lie where this user may not look, as in somebody's private home."""
    if attacker.name == "root" or os.geteuid() != 0:
        return False
    values = find.toolchain(language_called(name)).values
    paths = [Path(path) for key, path in values.items() if key != "gocache" and Path(path).exists()]
    parts = {part for path in paths for part in (path, *path.parents)}
    return any(not part.stat().st_mode & 0o001 for part in parts if part.is_dir())


@pytest.mark.parametrize(("name", "user", "level"), by_turns(ADDING, USERS, LEVELS))
def test_a_language_compiles_and_runs(attacker, level, name):
    recipe(name)
    attacker.require(level)
    if closed_to(attacker, name):
        pytest.skip(f"this user may not read the tools of {name}")
    found = outcomes(attacker, level, [name])[name]
    assert found.get("output") == "42\n", found
    assert found["level"] == level
