"""A stub is good Python, says what is wanted, fails its problem, and its doctests pass once it is solved."""

from __future__ import annotations

import doctest
import shutil
import types
from pathlib import Path

import pytest

from judge.practice.solutions import approaches
from judge.practice.stub import make_stub, write_stub
from judge.problem.find import sound_problems
from judge.problem.load import load_problem

ROOT = Path(__file__).parents[2]
PROBLEMS = [problem for problem in sound_problems()[0] if problem.folder.parent == ROOT / "problems"]
MIDDLE = load_problem(ROOT / "tests" / "fixtures" / "pack" / "problems" / "middle")
every = pytest.mark.parametrize("problem", [*PROBLEMS[::3], MIDDLE], ids=lambda problem: problem.id)


def loaded(source):
    module = types.ModuleType("stub")
    exec(compile(source, "stub.py", "exec"), module.__dict__)
    return module


def doctested(source):
    """How many of the doctests fail, how many there are, and what is said of them."""
    said: list[str] = []
    runner = doctest.DocTestRunner(verbose=False)
    for test in doctest.DocTestFinder().find(loaded(source), "stub"):
        runner.run(test, out=said.append)
    return runner.failures, runner.tries, "".join(said)


@every
def test_it_holds_the_contract_with_its_numbers_and_the_examples_as_doctests_that_fail(problem):
    stub = make_stub(problem)
    failed, tried, said = doctested(stub)
    assert failed == tried == _doctests(problem)
    assert said.count(f"NotImplementedError: {problem.entry} is still to be written") == failed
    for example in problem.examples:
        with pytest.raises(NotImplementedError, match=f"{problem.entry} is still to be written"):
            getattr(loaded(stub), problem.entry)(*example.case)
    text = " ".join(stub.split())
    assert " ".join(problem.summary.split()) in text
    assert "{{" not in stub
    for word in ("stdin", "as a program", "Function or program", "Write a function"):
        assert word not in stub
    assert max(map(len, stub.splitlines())) <= 88
    assert stub.count("def ") == 1 + bool(problem.answer.measured and problem.parameters)


def _doctests(problem):
    """How many examples are tests: none where many answers are right."""
    return len(problem.examples) if problem.answer.settled and problem.parameters else 0


PLAIN = [problem for problem in PROBLEMS if problem.id != "vector"]  # whose model answers by numpy


@pytest.mark.parametrize("problem", [*PLAIN, MIDDLE], ids=lambda problem: problem.id)
def test_its_examples_pass_once_the_function_is_written(problem):
    module = loaded(make_stub(problem))
    model = {"__name__": "model"}
    exec(compile(approaches(problem)[0].program, "model.py", "exec"), model)
    setattr(module, problem.entry, model[problem.entry])
    said: list[str] = []
    runner = doctest.DocTestRunner(verbose=False)
    for test in doctest.DocTestFinder().find(loaded(make_stub(problem)), "stub"):
        test.globs = vars(module)
        runner.run(test, out=said.append, clear_globs=False)
    assert (runner.tries, said) == (_doctests(problem), [])


def test_the_commands_in_its_head_name_the_folder_of_a_kata_elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copytree(MIDDLE.folder.parents[1], tmp_path / "a pack")
    write_stub(load_problem(tmp_path / "a pack" / "problems" / "middle"), Path("middle.py"))
    head = Path("middle.py").read_text().partition("def ")[0]
    for command in ("show", "start"):
        assert f"\n`judge {command} middle --problems 'a pack/problems'`" in head
    assert "--problems" not in make_stub(MIDDLE)  # of a site, which knows no folder
