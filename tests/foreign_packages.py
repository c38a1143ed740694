"""Tiny Kattis packages, made for a test: add two numbers."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from pathlib import Path

RIGHT = "print(sum(map(int, input().split())))\n"
WRONG = "a, b = map(int, input().split())\nprint(abs(a) + abs(b))\n"
RAISES = "raise SystemExit(3)\n"

LEGACY = {
    "problem.yaml": "name: Sum  # of two",
    "data/sample/1.in": "1 2\n",
    "data/sample/1.ans": "3\n",
    "data/secret/1.in": "-1 2\n",
    "data/secret/1.ans": "1\n",
    "submissions/accepted/right.py": RIGHT,
}
NEW = {**LEGACY, "problem.yaml": "problem_format_version: 2025-09\nname: Sum\nlimits: {time_limit: 2}\n"}

CHECKER = """
import sys
given, answer, feedback, *flags = sys.argv[1:]
assert feedback.endswith("/")
ok = sys.stdin.read().split() == open(answer).read().split()
open(feedback + "judgemessage.txt", "w").write(f"flags {flags}, input {open(given).read().split()}")
sys.exit(42 if ok else 43)
"""


def written(folder: Path, *tables: Mapping[str, str | None]) -> Path:
    """A package of these files in that folder, later tables over earlier ones; None leaves a file out."""
    files = {name: text for table in tables for name, text in table.items()}
    for name, text in files.items():
        if text is not None:
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    return folder


def zipped(path: Path, members: Mapping[str, str | bytes]) -> Path:
    """A zip file of these members."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return path
