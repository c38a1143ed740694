"""Change the judge itself in small ways, one at a time, and see whether its tests notice.

    python tests/mutation/mutate_judge.py                    what the day's tests notice
    python tests/mutation/mutate_judge.py --suite nightly    what all tests do
    python tests/mutation/mutate_judge.py --own              … by the files that name the module, alone

Each mutant is tried in a copy of the checkout: first by the test files that name its module, then by all. The
mutants are drawn from the twelve modules below, five from each, always the same ones.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from judge.holes.mutants import mutants

ROOT = Path(__file__).parents[2]
MODULES = (
    "values/answers",
    "values/wire",
    "values/check",
    "run/group",
    "run/groups",
    "run/timing",
    "run/growth",
    "data/build",
    "mistakes/likeness",
    "diagnose/candidates",
    "practice/history",
    "sandbox/filters",
)
EACH = 5
ALLOWED = {"ptrace": 101, "socket": 41, "mount": 165, "process_vm_readv": 310, "bpf": 321}  # of x86-64
SUITES = {"daily": [], "nightly": ["-m", ""]}
SECONDS = 3600  # for a run of the tests; one that takes longer has noticed


class Edit(NamedTuple):
    """A module's text with one change, and the change in words."""

    module: str
    told: str
    text: str


def edits() -> Iterator[Edit]:
    """The mutants, in order."""
    for module in MODULES:
        text = (ROOT / "judge" / f"{module}.py").read_text(encoding="utf-8")
        if module.endswith("filters"):
            first = "    for first, last in _runs("
            for name, number in ALLOWED.items():
                row = f"    rows += _guarded({number}, [(_RETURN, 0, 0, ALLOW)])\n{first}"
                yield Edit(module, f"{name} is allowed", text.replace(first, row))
            yield Edit(module, "kill is allowed", text.replace('("kill", "tgkill")', '("tgkill",)'))
            continue
        found = {each.was: each for each in mutants(text) if each.kind != "text"}  # one a line
        for was in random.Random(module).sample(sorted(found), min(EACH, len(found))):
            yield Edit(module, f"{was}  →  {found[was].becomes}", found[was].source)


def noticed(copy: Path, edit: Edit, suite: list[str], *, own_alone: bool = False) -> str:
    """Which tests notice the edit: "its own", "all", or "" for none."""
    place = copy / "judge" / f"{edit.module}.py"
    before = place.read_text(encoding="utf-8")
    place.write_text(edit.text, encoding="utf-8")
    name = edit.module.replace("/", ".")
    package, _, last = name.rpartition(".")
    words = (f"judge.{name}", f"from judge.{package} import {last}")
    own = [
        path
        for path in sorted((copy / "tests").rglob("test_*.py"))
        if any(word in path.read_text(encoding="utf-8") for word in words)
    ]
    try:
        if own and _fails(copy, [*map(str, own), *suite]):
            return "its own"
        return "all" if not own_alone and _fails(copy, suite) else ""
    finally:
        place.write_text(before, encoding="utf-8")


def _fails(copy: Path, words: list[str]) -> bool:
    """Whether these tests are red."""
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-n", "auto", "--dist", "loadfile", *words]
    settings = {**os.environ, "PYTHONPATH": str(copy), "JUDGE_CACHE": str(copy / ".cache")}
    try:
        done = subprocess.run(
            command, cwd=copy, env=settings, capture_output=True, timeout=SECONDS, check=False
        )
    except subprocess.TimeoutExpired:
        return True
    return done.returncode not in (0, 5)  # 5: none of these tests is of this suite


def main() -> int:
    """Returns the exit status: 0, whatever was noticed."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--suite", choices=SUITES, default="daily")
    parser.add_argument("--own", action="store_true", help="only by the test files that name the module")
    parser.add_argument("--only", default="", metavar="TEXT", help="only modules with that in their name")
    asked = parser.parse_args()
    chosen = [edit for edit in edits() if asked.only in edit.module]
    count = 0
    with tempfile.TemporaryDirectory(prefix="judge-tests-") as folder:
        copy = Path(folder) / "copy"
        left_out = shutil.ignore_patterns(".git", ".venv", "__pycache__", ".*_cache")
        shutil.copytree(ROOT, copy, ignore=left_out)
        for number, edit in enumerate(chosen, 1):
            begun = time.monotonic()
            by = noticed(copy, edit, SUITES[asked.suite], own_alone=asked.own)
            count += bool(by)
            seconds = time.monotonic() - begun
            print(
                f"{number:2} {edit.module}: {edit.told}\n   noticed by {by or 'NOBODY'}, {seconds:.0f} s",
                flush=True,
            )
    print(f"{count} of {len(chosen)} noticed by the {asked.suite} tests")
    return 0


if __name__ == "__main__":
    sys.exit(main())
