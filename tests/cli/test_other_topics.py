"""Katas of other topics go through every command: whatever their types, and without a word of circles."""

from __future__ import annotations

import doctest
import html
import json
import re
import subprocess
import sys
import types
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest
from other_topics import BY_ID, PROBLEMS, TABLE, checked

from judge.kata.stub import make_stub
from judge.problem.load import load_problem

pytestmark = pytest.mark.slow

FACT = re.compile(r"<dt>(\w+)</dt><dd[^>]*>(.*?)</dd>", re.DOTALL)
every = pytest.mark.parametrize("kata", TABLE, ids=lambda kata: kata.id)


@pytest.fixture(autouse=True)
def _these_problems(monkeypatch):
    monkeypatch.setenv("JUDGE_PROBLEMS", str(PROBLEMS))


def test_the_katas_are_short_and_without_a_topic():
    assert sorted(BY_ID) == sorted(path.name for path in PROBLEMS.iterdir())
    for name in BY_ID:
        source = (PROBLEMS / name / "problem.py").read_text(encoding="utf-8")
        assert source.count("\n") < 45
        assert "judge.topics" not in source


def test_the_katas_are_sound_by_the_setters_own_check(judge):
    ended = judge("verify", *BY_ID, "--matrix", "--json")
    assert (ended.status, ended.err) == (0, "")
    reports = {report["problem"]: report for report in checked("verify", ended.out)}
    for kata in TABLE:
        report = reports[kata.id]
        assert (report["pins"], report["faults"]) == ("matching", [])
        folders = {each["file"].partition("/")[0] for each in report["solutions"] if each["ok"]}
        assert folders == {"accepted", "wrong"}
        kata.sound(json.dumps(report))


@every
def test_functions_are_judged_shrunk_named_and_kept(kata, judge):
    files = [kata.wrong, kata.accepted]
    words = ["--json", "--junit", "results.xml", "--save-regression", "test_kept.py"]
    ended = judge("run", kata.id, *files, *words)
    assert ended.status == 1
    wrong, right = checked("run", ended.out)
    assert (wrong["verdict"], wrong["mode"]) == ("WA", "function")
    assert (right["verdict"], right["mode"], right["score"]) == ("AC", "function", 100)
    assert wrong["pitfall"]["name"] == kata.mistake
    found = wrong["counterexample"]
    assert found["input"] == kata.smallest
    assert (found["expected"], found["got"], found["message"]) == (kata.wanted, kata.got, kata.why)
    assert ended.err == f"judge: test_kept.py now holds {found['replay']}\n"
    junit, kept = Path("results.xml").read_text(encoding="utf-8"), Path("test_kept.py").read_text("utf-8")
    kata.sound(ended.out, ended.err, junit, kept)

    failing, passing = Xml.fromstring(junit)
    names = [group["name"] for group in wrong["groups"]]
    assert [case.get("name") for case in failing.iter("testcase")] == names
    told = next(failing.iter("failure")).text
    assert f"    wanted  {kata.wanted}\n    got     {kata.got}\n" in told
    assert kata.mistake in told
    assert list(passing.iter("failure")) == []

    again = judge("replay", found["replay"], kata.wrong, "--json")
    (replayed,) = checked("replay", again.out)
    assert (again.status, again.err) == (1, "")
    assert replayed["failure"]["input"] == kata.smallest
    assert replayed["failure"]["got"] == kata.got
    shown = judge("replay", found["replay"], kata.accepted)
    assert (shown.status, shown.err) == (0, "")
    kata.sound(again.out, shown.out)


@every
def test_programs_are_judged_shrunk_and_named(kata, judge, submit):
    right = judge("run", kata.id, kata.accepted_program, "-q")
    assert (right.status, right.out[:17], right.err) == (0, "AC  accepted, 100", "")
    ended = judge("run", kata.id, submit(kata.wrong_program, "own.py"))
    assert (ended.status, ended.err) == (1, "")
    kata.sound(ended.out)
    assert ended.lines[0] == f"WA  own.py  {kata.id}, run as a program"
    smallest = ended.out.partition("smallest case found")[2]
    wanted, got = kata.printed
    assert f"    wanted  {wanted}\n    got     {got}\n" in smallest
    named = re.findall(r"^  (\S+)  likely, score", ended.out, re.MULTILINE)
    assert named == ([kata.program_mistake] if kata.program_mistake else [])


@every
def test_fresh_cases_are_judged(kata, judge):
    ended = judge("stress", kata.id, kata.wrong, "--for", "20s", "--seed", 1, "--no-name", "--json")
    (found,) = checked("stress", ended.out)
    assert (ended.status, found["verdict"]) == (1, "WA")
    assert found["counterexample"]["input"] == (kata.fresh or kata.smallest)
    shown = judge("stress", kata.id, kata.accepted, "--for", "0.2s", "--seed", 1, "--group", last_small(kata))
    assert shown.status == 0
    kata.sound(ended.out, ended.err, shown.out, shown.err)


def last_small(kata):
    """The last test group of small cases."""
    groups = load_problem(PROBLEMS / kata.id).groups
    return [group.name for group in groups if group.size is None][-1]


@every
def test_data_are_written_and_are_what_programs_read_and_print(kata, judge, tmp_path):
    ended = judge("data", kata.id, "--out", "data", "--json")
    (written,) = checked("data", ended.out)
    assert ended.status == 0
    problem = load_problem(PROBLEMS / kata.id)
    for group in problem.groups:
        given = (tmp_path / "data" / f"{group.name}.in").read_bytes()
        wanted = (tmp_path / "data" / f"{group.name}.ans").read_text(encoding="ascii")
        command = [sys.executable, "-I", str(kata.accepted_program)]
        printed = subprocess.run(command, input=given, capture_output=True, check=True, timeout=60)
        lines = printed.stdout.decode("ascii").splitlines()
        assert len(lines) == len(wanted.splitlines()) == int(given.split(b"\n")[0])
        if kata.answer.startswith(("[int", "word", "int", "array")):
            assert lines == wanted.splitlines()
    document = json.loads((tmp_path / "data" / "examples.json").read_text(encoding="utf-8"))
    assert len(document["cases"]) == len(problem.examples)
    assert list(document["cases"][0]["input"]) == [parameter.name for parameter in problem.parameters]
    kata.sound(ended.out, ended.err, json.dumps(document), json.dumps(written))


@every
def test_what_is_asked_is_shown(kata, judge):
    (shown,) = checked("show", judge("show", kata.id, "--json").out)
    problem = load_problem(PROBLEMS / kata.id)
    assert shown["answer"] == kata.answer
    assert [each["type"] for each in shown["parameters"]] == [str(each.type) for each in problem.parameters]
    assert len(shown["examples"]) == len(problem.examples)
    printed = judge("show", kata.id)
    assert f"{kata.entry}(" in printed.out
    assert problem.title in printed.out
    why, hint = judge("why", kata.id), judge("hint", kata.id)
    assert (printed.status, why.status, hint.status) == (0, 0, 0)
    assert kata.mistake in why.out
    kata.sound(json.dumps(shown), printed.out, printed.err, why.out, why.err, hint.out, hint.err)


@every
def test_the_stub_fails_and_its_doctests_pass_once_it_is_written(kata, judge):
    ended = judge("init", kata.id, "mine.py", "--json")
    checked("init", ended.out)
    stub = Path("mine.py").read_text(encoding="utf-8")
    kata.sound(ended.out, ended.err, stub)
    assert stub == make_stub(load_problem(PROBLEMS / kata.id))
    rejected = judge("run", "-q")
    assert (rejected.status, rejected.out[:3]) == (1, "RTE")
    module = types.ModuleType("mine")
    exec(compile(stub, "mine.py", "exec"), module.__dict__)
    tests = [test for test in doctest.DocTestFinder().find(module, "mine") if test.examples]
    examples = [each for test in tests for each in test.examples]
    if kata.answer == "enclosure":  # many are right, and none is asked for
        assert examples == []
        assert "    enclose(4, 0) may return (1.5, 2.25)\n" in stub
        return
    assert len(examples) == len(load_problem(PROBLEMS / kata.id).examples)
    exec(kata.accepted.read_text(encoding="utf-8"), module.__dict__)
    runner, said = doctest.DocTestRunner(verbose=False), []
    for test in tests:
        test.globs = module.__dict__
        runner.run(test, out=said.append)
    assert runner.failures == 0, "".join(said)


def test_the_regression_files_fail_on_the_mistakes_and_pass_once_they_are_mended(judge, tmp_path):
    """One file for all of them, as a person would go on with it."""
    for kata in TABLE:
        mine = tmp_path / f"{kata.entry}.py"
        mine.write_bytes(kata.wrong.read_bytes())
        words = ["--no-name", "--save-regression", "test_kept.py", "-q"]
        assert judge("run", kata.id, mine.name, *words).status == 1
    failed = pytest_of("test_kept.py")
    assert (failed.returncode, failed.stdout.splitlines()[-1][:8]) == (1, f"{len(TABLE)} failed"[:8]), (
        failed.stdout
    )
    BY_ID["divisors"].sound(failed.stdout.replace("Circle", ""))
    for kata in TABLE:
        (tmp_path / f"{kata.entry}.py").write_bytes(kata.accepted.read_bytes())
    passed = pytest_of("test_kept.py")
    assert (passed.returncode, passed.stdout.splitlines()[-1][:8]) == (0, f"{len(TABLE)} passed"[:8]), (
        passed.stdout
    )


def pytest_of(file):
    command = [sys.executable, "-m", "pytest", "-q", "--tb=no", "-p", "no:cacheprovider", file]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=120, check=False)


def test_the_report_shows_what_went_wrong_and_draws_nothing(judge, submit):
    for kata in TABLE:
        mine = submit(f"{kata.wrong.read_text(encoding='utf-8')}# mine\n", f"{kata.entry}.py")
        assert judge("run", kata.id, mine, "--json").status == 1
    ended = judge("report", "--no-matrix", "--out", "page.html", "--json")
    checked("report", ended.out)
    assert (ended.status, ended.err) == (0, "")
    page = Path("page.html").read_text(encoding="utf-8").partition("<main")[2]
    parts = re.findall(r'<section id="problem-.*?</section>', page, re.DOTALL)
    for kata in TABLE:
        (part,) = (each for each in parts if f'<span class="quiet">{kata.id}, ' in each)
        facts = {name: html.unescape(told) for name, told in FACT.findall(part)}
        assert facts["input"] == kata.called
        assert (facts["wanted"], facts["got"]) == (kata.wanted, kata.got)
        assert facts.get("why", kata.why) == kata.why
        assert kata.mistake in part
        kata.sound(html.unescape(re.sub(r"<[^>]*>", " ", part)))
        assert "<figure" not in part
    assert "lenses" not in page
