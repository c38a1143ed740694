"""Every language at every level, as root and as a plain user."""

from __future__ import annotations

import base64
import os
import pickle
from pathlib import Path
from typing import Any

import pytest

from judge.languages import find
from judge.languages.boxes import recipe_of
from judge.languages.model import language_called
from judge.sandbox.recipe import Sources

ADDING = {  # the sum of two numbers on a line
    "c": '#include <stdio.h>\nint main(void) { int a, b; scanf("%d%d", &a, &b); printf("%d\\n", a + b); }',
    "cpp": "#include <iostream>\nint main() { int a, b; std::cin >> a >> b; std::cout << a + b << '\\n'; }",
    "go": 'package main\nimport "fmt"\nfunc main() { var a, b int; fmt.Scan(&a, &b); fmt.Println(a + b) }',
    "java": (
        "import java.util.*;\npublic class Main { public static void main(String[] w) {"
        " var in = new Scanner(System.in); System.out.println(in.nextInt() + in.nextInt()); } }"
    ),
    "rust": (
        "use std::io::*;\nfn main() { let mut t = String::new(); stdin().read_to_string(&mut t).unwrap();"
        ' println!("{}", t.split_whitespace().map(|w| w.parse::<i32>().unwrap()).sum::<i32>()); }'
    ),
    "javascript": (
        "const w = require('fs').readFileSync(0, 'utf8').trim().split(/\\s+/).map(Number);"
        " console.log(w[0] + w[1]);"
    ),
    "pypy": "print(sum(map(int, input().split())))",
}
FOUND: dict[tuple[str, str], dict[str, Any]] = {}


def installed() -> list[str]:
    return [name for name in ADDING if not find.why_not(language_called(name))]


def outcomes(attacker, level: str) -> dict[str, Any]:
    if (attacker.name, level) not in FOUND:
        orders = []
        for name in installed():
            recipe = recipe_of(find.toolchain(language_called(name)))
            file = recipe.empty[0]
            orders.append((name, (recipe, Sources(((file, ADDING[name].encode()),), file))))
        given = base64.b64encode(pickle.dumps(orders)).decode()
        FOUND[attacker.name, level] = {
            row["name"]: row for row in attacker.run("native_runs.py", level, given=given)
        }
    return FOUND[attacker.name, level]


def closed_to(attacker, name: str) -> bool:
    """Whether the tools lie where this user may not look, as in somebody's private home."""
    if attacker.name == "root" or os.geteuid() != 0:
        return False
    values = find.toolchain(language_called(name)).values
    paths = [Path(path) for key, path in values.items() if key != "gocache" and Path(path).exists()]
    parts = {part for path in paths for part in (path, *path.parents)}
    return any(not part.stat().st_mode & 0o001 for part in parts if part.is_dir())


@pytest.mark.parametrize("level", ["full", "strong", "limits"])
@pytest.mark.parametrize("name", ADDING)
def test_it_compiles_and_runs(attacker, level, name):
    if name not in installed():
        pytest.skip(find.remedy(language_called(name)))
    attacker.require(level)
    if closed_to(attacker, name):
        pytest.skip(f"this user may not read the tools of {name}")
    found = outcomes(attacker, level)[name]
    assert found.get("output") == "42\n", found
    assert found["level"] == level
