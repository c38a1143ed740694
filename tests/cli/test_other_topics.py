"""Katas of other topics: their solutions, data, stubs, kept cases and pages, whatever their types.

What commands say of them is in the transcripts of `topics/`.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest
from cli_support import ROOT
from sampling import daily, nightly

from judge.problem.load import load_problem

pytestmark = pytest.mark.slow

KATAS = ROOT / "tests" / "fixtures" / "katas"
PROBLEMS, SOLUTIONS = KATAS / "problems", KATAS / "solutions"


@dataclass(frozen=True)
class Kata:
    """A kata, its right solution and a wrong one; `exact` where only one text is right for a program."""

    id: str
    entry: str
    right: str
    mistake: str
    exact: bool = True

    @property
    def accepted(self) -> Path:
        return SOLUTIONS / self.id / "accepted" / f"{self.right}.py"

    @property
    def wrong(self) -> Path:
        return SOLUTIONS / self.id / "wrong" / f"{self.mistake}.py"


BY_ID = {
    kata.id: kata
    for kata in (
        Kata("divisors", "divisors", "trial", "as-found"),
        Kata("positive-root", "positive_root", "formula", "two-roots-only", exact=False),
        Kata("unit-vector", "unit_vector", "hypot", "flat", exact=False),
        Kata("larger-fraction", "compare", "crosswise", "sign-forgotten"),
        Kata("by-size", "by_size", "sorted", "remainder", exact=False),
        Kata("root-enclosed", "enclose", "isqrt", "one-wide", exact=False),
        Kata("rises", "rises", "pairs", "no-standstill"),
        Kata("lamps", "first_lamp", "squares", "last-one"),
    )
}

FACT = re.compile(r"<dt>(\w+)</dt><dd[^>]*>(.*?)</dd>", re.DOTALL)
every = pytest.mark.parametrize("name", daily(BY_ID, ("unit-vector",)))


@pytest.fixture(autouse=True)
def _these_problems(monkeypatch):
    monkeypatch.setenv("JUDGE_PROBLEMS", str(PROBLEMS))


def objects(ended):
    return [json.loads(line) for line in ended.lines]


@pytest.mark.parametrize("names", [("lamps",), nightly(tuple(BY_ID))])
def test_the_katas_are_sound_by_the_setters_own_check(names, judge):
    ended = judge("verify", *names, "--matrix", "--json")
    assert (ended.status, ended.err) == (0, "")
    for report in objects(ended):
        assert (report["pins"], report["faults"]) == ("matching", [])
        folders = {each["file"].partition("/")[0] for each in report["solutions"] if each["ok"]}
        assert folders == {"accepted", "wrong"}


@every
def test_data_are_what_programs_read_and_print(name, judge):
    kata = BY_ID[name]
    assert judge("export", name, "--out", "data", "--format", "files").status == 0
    for group in load_problem(PROBLEMS / name).groups:
        given = Path("data", name, f"{group.name}.in").read_bytes()
        wanted = Path("data", name, f"{group.name}.ans").read_text(encoding="ascii").splitlines()
        command = [sys.executable, "-I", str(kata.accepted.with_name("program.py"))]
        printed = subprocess.run(command, input=given, capture_output=True, check=True, timeout=60)
        lines = printed.stdout.decode("ascii").splitlines()
        assert len(lines) == len(wanted) == int(given.split(b"\n")[0])
        assert lines == wanted or not kata.exact


# -- a setter's slips -------------------------------------------------------------------------------------


# The kata, its file, what is written there instead of what, and what is told.
SLIPS = [
    ("divisors", "toml", "[int; 1..240]", "[int; 1..3]", "4 items where 1 to 3 are expected"),
    ("divisors", "py", "== 0]", "== 0] + [n / 2] * (n > 6)", "and a float is not exact"),
    ("unit-vector", "toml", "relative = 1e-9", "relative = 1e-30", "the example contradicts solve: "),
    ("larger-fraction", "toml", "less|equal|more", "less|equal", "'more' where less or equal is expected"),
    ("root-enclosed", "py", "high - low <= width", "high - low < 0", "the example contradicts solve: "),
    ("rises", "py", "return [0, *(", "return ['x', *(", "'x', a str, where an int is expected"),
    ("lamps", "toml", "[circle; 1..6]", "[circle; 1..2]", "lamps has "),
]


@pytest.mark.parametrize(("name", "file", "old", "new", "told"), SLIPS)
def test_a_slip_is_one_line_and_no_fault_of_the_judge(name, file, old, new, told, judge, tmp_path):
    shutil.copytree(KATAS, tmp_path / "pack")
    place = tmp_path / "pack" / "problems" / name / f"problem.{file}"
    text = place.read_text(encoding="utf-8")
    assert text.count(old) == 1
    place.write_text(text.replace(old, new), encoding="utf-8")
    ended = judge("run", name, BY_ID[name].accepted, "--problems", tmp_path / "pack" / "problems", "-q")
    assert (ended.status, ended.err.count("\n")) == (3, 1)
    assert told in ended.err
    assert name in ended.err


@pytest.mark.parametrize("text", ["a:b", "a:b:c", "at:12:v0:0", "brackets::"])
def test_a_text_with_colons_is_a_case_and_no_replay_id(text, judge, tmp_path):
    shutil.copytree(ROOT / "judge" / "manual" / "katas" / "problems" / "runs", tmp_path / "problems" / "runs")
    place = tmp_path / "problems" / "runs" / "problem.toml"
    place.write_text(place.read_text().replace('letters = "a-z "', 'letters = "a-z0-9: "'))
    ended = judge("try", "runs", text, "--problems", tmp_path / "problems", "--json")
    assert (ended.status, ended.err) == (0, "")
    assert objects(ended)[0]["case"]["input"] == {"s": text}


def test_the_files_of_a_kata_with_a_format_are_an_input_and_an_output_for_each_case(judge):
    """Its own program prints just that; a second export writes over nothing."""
    katas = ROOT / "judge" / "manual" / "katas"
    words = "export", "depot", "--out", "data", "--format", "files", "--problems", katas / "problems"
    ended = judge(*words, "--json")
    names = sorted(path.name for path in Path("data", "depot").iterdir())
    assert (ended.status, names) == (0, sorted(objects(ended)[0]["files"]))
    assert {"one-shelf-12.in", "one-shelf-12.ans", "refusals.json"} < set(names)
    assert "one-shelf.in" not in names
    program = katas / "solutions" / "depot" / "accepted" / "exact.py"
    for given in sorted(Path("data", "depot").glob("*-01.in")):
        command = [sys.executable, "-I", str(program)]
        case = given.read_bytes()
        printed = subprocess.run(command, input=case, capture_output=True, check=True, timeout=60)
        assert printed.stdout == given.with_suffix(".ans").read_bytes()
    assert judge(*words).status == 2
