"""Katas of other topics: their solutions, data, stubs, kept cases and pages, whatever their types.

What commands say of them is in the transcripts of `topics/`.
"""

from __future__ import annotations

import doctest
import html
import json
import re
import shutil
import subprocess
import sys
import types
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest
from other_topics import BY_ID, KATAS, PROBLEMS, TABLE
from sampling import daily, nightly

from judge.kata.stub import make_stub
from judge.problem.load import load_problem
from judge.testing import judge_problem

pytestmark = pytest.mark.slow

FACT = re.compile(r"<dt>(\w+)</dt><dd[^>]*>(.*?)</dd>", re.DOTALL)
every = pytest.mark.parametrize("name", daily(BY_ID, ("unit-vector", "by-size")))


@pytest.fixture(autouse=True)
def _these_problems(monkeypatch):
    monkeypatch.setenv("JUDGE_PROBLEMS", str(PROBLEMS))


def objects(ended):
    return [json.loads(line) for line in ended.lines]


def test_the_katas_are_short_and_without_a_topic():
    assert sorted(BY_ID) == sorted(path.name for path in PROBLEMS.iterdir())
    for name in BY_ID:
        source = (PROBLEMS / name / "problem.py").read_text(encoding="utf-8")
        assert source.count("\n") < 45
        assert "judge.topics" not in source


@pytest.mark.parametrize("names", [("lamps", "rises"), nightly(tuple(BY_ID))])
def test_the_katas_are_sound_by_the_setters_own_check(names, judge):
    ended = judge("verify", *names, "--matrix", "--json")
    assert (ended.status, ended.err) == (0, "")
    for report in objects(ended):
        assert (report["pins"], report["faults"]) == ("matching", [])
        folders = {each["file"].partition("/")[0] for each in report["solutions"] if each["ok"]}
        assert folders == {"accepted", "wrong"}


@every
def test_the_file_of_results_has_the_smallest_case(name, judge):
    kata = BY_ID[name]
    ended = judge("run", name, kata.wrong, kata.accepted, "--junit", "results.xml", "--json")
    wrong, _ = objects(ended)
    failing, passing = Xml.parse("results.xml").getroot()
    assert [case.get("name") for case in failing.iter("testcase")] == [
        each["name"] for each in wrong["groups"]
    ]
    told, found = next(failing.iter("failure")).text, wrong["counterexample"]
    assert f"    wanted  {found['expected']}\n    got     {found['got']}\n" in told
    assert kata.mistake in told
    assert list(passing.iter("failure")) == []


@every
def test_fresh_cases_are_judged(name, judge):
    kata = BY_ID[name]
    ended = judge("stress", name, kata.wrong, "--for", "20s", "--seed", 1, "--no-name", "--json")
    (found,) = objects(ended)
    assert (ended.status, found["verdict"]) == (1, "WA")
    assert found["counterexample"]
    small = [group.name for group in load_problem(PROBLEMS / name).groups if group.size is None]
    right = judge("stress", name, kata.accepted, "--for", "0.2s", "--seed", 1, "--group", small[-1])
    assert right.status == 0


@every
def test_data_are_what_programs_read_and_print(name, judge):
    kata = BY_ID[name]
    assert judge("data", name, "--out", "data").status == 0
    for group in load_problem(PROBLEMS / name).groups:
        given = Path("data", f"{group.name}.in").read_bytes()
        wanted = Path("data", f"{group.name}.ans").read_text(encoding="ascii").splitlines()
        command = [sys.executable, "-I", str(kata.accepted_program)]
        printed = subprocess.run(command, input=given, capture_output=True, check=True, timeout=60)
        lines = printed.stdout.decode("ascii").splitlines()
        assert len(lines) == len(wanted) == int(given.split(b"\n")[0])
        assert lines == wanted or not kata.exact


@every
def test_the_doctests_of_a_stub_pass_once_it_is_written(name):
    kata, problem = BY_ID[name], load_problem(PROBLEMS / name)
    stub = make_stub(problem)
    module = types.ModuleType("mine")
    exec(compile(stub, "mine.py", "exec"), module.__dict__)
    tests = [test for test in doctest.DocTestFinder().find(module, "mine") if test.examples]
    examples = [each for test in tests for each in test.examples]
    if name == "root-enclosed":  # many are right, and none is asked for
        assert examples == []
        return
    assert len(examples) == len(problem.examples)
    exec(kata.accepted.read_text(encoding="utf-8"), module.__dict__)
    runner, said = doctest.DocTestRunner(verbose=False), []
    for test in tests:
        test.globs = module.__dict__
        runner.run(test, out=said.append)
    assert runner.failures == 0, "".join(said)


@every
def test_routines_of_other_code_are_held_against_the_exact_answers(name):
    kata, judged = BY_ID[name], judge_problem(name)
    judged.check(routine(kata, kata.accepted))
    with pytest.raises(AssertionError) as failed:
        judged.check(routine(kata, kata.wrong))
    assert str(failed.value).startswith(f"{kata.id}: {kata.entry} fails ")
    assert "    wanted  " in str(failed.value)


def routine(kata, path):
    """The function of a solution."""
    names = {}
    exec(path.read_text(encoding="utf-8"), names)
    return names[kata.entry]


def test_kept_cases_fail_on_the_mistakes_and_pass_once_they_are_mended(judge, tmp_path):
    """One file for all of them, as a person would go on with it."""
    for kata in TABLE:
        mine = tmp_path / f"{kata.entry}.py"
        mine.write_bytes(kata.wrong.read_bytes())
        words = ["--no-name", "--save-regression", "test_kept.py", "-q"]
        assert judge("run", kata.id, mine.name, *words).status == 1
    failed = pytest_of("test_kept.py")
    assert (failed.returncode, failed.stdout.splitlines()[-1][:8]) == (1, "8 failed"), failed.stdout
    for kata in TABLE:
        (tmp_path / f"{kata.entry}.py").write_bytes(kata.accepted.read_bytes())
    passed = pytest_of("test_kept.py")
    assert (passed.returncode, passed.stdout.splitlines()[-1][:8]) == (0, "8 passed"), passed.stdout


def pytest_of(file):
    command = [sys.executable, "-m", "pytest", "-q", "--tb=no", "-p", "no:cacheprovider", file]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=120, check=False)


def test_the_report_shows_what_went_wrong_and_draws_nothing(judge, submit):
    found = {}
    for kata in TABLE:
        mine = submit(f"{kata.wrong.read_text(encoding='utf-8')}# mine\n", f"{kata.entry}.py")
        (result,) = objects(judge("run", kata.id, mine, "--json"))
        found[kata.id] = result["counterexample"]
    ended = judge("report", "--no-matrix", "--out", "page.html")
    assert (ended.status, ended.err) == (0, "")
    page = Path("page.html").read_text(encoding="utf-8").partition("<main")[2]
    parts = re.findall(r'<section id="problem-.*?</section>', page, re.DOTALL)
    for kata in TABLE:
        (part,) = (each for each in parts if f'<span class="quiet">{kata.id}, ' in each)
        facts = {name: html.unescape(told) for name, told in FACT.findall(part)}
        assert (facts["wanted"], facts["got"]) == (found[kata.id]["expected"], found[kata.id]["got"])
        assert kata.mistake in part
        assert "<figure" not in part
    assert "lenses" not in page
    assert "drawings" not in page


# -- a setter's slips -------------------------------------------------------------------------------------


# The kata, its file, what is written there instead of what, and what is told.
SLIPS = [
    ("divisors", "toml", "[int; 1..240]", "[int; 1..3]", "4 items where 1 to 3 are meant"),
    (
        "divisors",
        "toml",
        "[int; 1..240]",
        "real",
        "group 'examples' has no tolerance; add a [tolerance] table",
    ),
    ("divisors", "py", "== 0], None", "== 0] * (1 + 300 * (n > 6)), None", "items where 1 to 240 are meant"),
    ("divisors", "py", "== 0], None", "== 0] + [n / 2] * (n > 6), None", "where an int is meant"),
    ("unit-vector", "toml", '"vec3"', '"vec2"', "the example's answer '(0.3333333333333333, "),
    ("unit-vector", "toml", "relative = 1e-9", "relative = 1e-30", "the example contradicts solve: "),
    ("unit-vector", "py", "], 1), None", "][: 3 - (v[0] > 5)], 1), None", "2 parts where 3 are meant"),
    ("larger-fraction", "toml", "less|equal|more", "less|equal", "'more' where less or equal is meant"),
    ("by-size", "py", "each for each in sorted", "-9 for each in sorted", "the example contradicts solve: "),
    ("root-enclosed", "py", "Fraction(1, 10", "-Fraction(1, 10", "no interval has a negative width"),
    ("rises", "toml", '"array(i8; 100000)"', '"array(i8; 3)"', "items where at most 3 are meant"),
    ("rises", "py", "return [0, *(", "return [0 * len(xs), *(300 * ", "00 in an array(i8; 100000)"),
    ("lamps", "py", "enumerate(lit) if each", "enumerate(lit, 1.0) if each", "fails: TypeError: 'float'"),
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
