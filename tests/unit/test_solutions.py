"""The one reader of a problem's solutions: what it takes for a program, what it says of the rest."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from judge.languages import is_program
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.problem.solutions import (
    Kind,
    accepted_source,
    is_solution,
    known_mistakes,
    read_solutions,
)

PACK = Path(__file__).parents[1] / "fixtures" / "pack"

TOLD = '''"""floor-division.

Both halves are cut off. Use `/`.

    - one
    - two
"""
'''


@pytest.fixture
def problem(tmp_path):
    """A problem without solutions."""
    shutil.copytree(PACK / "problems" / "middle", tmp_path / "problems" / "middle")
    return load_problem(tmp_path / "problems" / "middle")


@pytest.fixture
def add(problem):
    """Write a file of its solutions."""

    def write(name, content=TOLD):
        path = problem.solutions / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


def test_without_solutions_there_are_no_programs_and_no_faults(problem):
    assert read_solutions(problem) == ((), ())
    assert known_mistakes(problem) == []
    assert accepted_source(problem, "fast.py") is None


def test_programs_are_in_the_order_of_kinds_and_names(problem, add):
    for name in ("wrong/b.py", "slow/z.py", "wrong/a.py", "accepted/c.py"):
        add(name)
    files = [program.file for program in read_solutions(problem).programs]
    assert files == ["accepted/c.py", "wrong/a.py", "wrong/b.py", "slow/z.py"]
    assert [program.file for program in read_solutions(problem, Kind.SLOW).programs] == ["slow/z.py"]


def test_what_a_program_tells_of_itself(problem, add):
    add("wrong/floor-division.py")
    (program,) = read_solutions(problem).programs
    assert (program.name, program.usual) == ("floor-division", True)
    assert program.text == "Both halves are cut off. Use `/`.\n\n    - one\n    - two"
    assert program.advice == "Both halves are cut off. Use `/`. - one - two"
    assert program.sentence == "Both halves are cut off."
    assert program.source == TOLD.encode()


@pytest.mark.parametrize("content", [b"", b"x = 1\n", b'"""  \n  """\n', b"# only a comment\n"])
def test_a_program_that_says_no_name_is_told_and_no_known_mistake(content, problem, add):
    add("wrong/nameless.py", content)
    programs, (fault,) = read_solutions(problem)
    assert [(program.name, program.text) for program in programs] == [("", "")]
    assert (
        str(fault) == "middle/wrong/nameless.py: it has no docstring; begin it with the name of its mistake"
    )
    assert known_mistakes(problem) == []


@pytest.mark.parametrize(
    "content", [b'"""a', b"\xff\xfe", b'"""a\x00b"""', b"# coding: nonsense\n", b"(" * 100_000]
)
def test_a_file_that_is_no_python_is_told_and_no_program(content, problem, add):
    add("accepted/broken.py", content)
    programs, (fault,) = read_solutions(problem)
    assert programs == ()
    assert fault.where in ("middle/accepted/broken.py", "middle/accepted/broken.py:1")
    assert fault.what.startswith("no Python: ")
    assert "<unknown>" not in fault.what
    assert "\n" not in str(fault)


def test_a_program_in_another_encoding_is_read_as_python_reads_it(problem, add):
    add("accepted/old.py", '# coding: latin-1\n"""mitte\n\nÜber die Hälfte."""\n'.encode("latin-1"))
    programs, faults = read_solutions(problem)
    assert (programs[0].name, programs[0].text, faults) == ("mitte", "Über die Hälfte.", ())


def test_what_is_hidden_is_passed_over(problem, add):
    for name in (".#fast.py", "._fast.py", ".DS_Store", "__pycache__/fast.pyc", "__init__.py"):
        add(f"accepted/{name}", b"\x00")
    (problem.solutions / ".git").mkdir()
    assert read_solutions(problem) == ((), ())


def test_a_file_in_no_known_language_is_told(problem, add):
    add("accepted/fast.cob", "STOP RUN.")
    add("wrong/notes.md", "# Notes")
    (problem.solutions / "slow" / "deep").mkdir(parents=True)
    programs, faults = read_solutions(problem)
    assert programs == ()
    assert [str(fault) for fault in faults] == [
        f"middle/{name}: this is no program; end its name as a language does (.py) if it is one, "
        "or move it elsewhere"
        for name in ("accepted/fast.cob", "wrong/notes.md", "slow/deep")
    ]


def test_what_is_in_none_of_the_three_folders_is_told(problem, add):
    add("partial/half.py")
    add("stray.py")
    add("README.md", "Notes are welcome here.")
    assert [str(fault) for fault in read_solutions(problem).faults] == [
        f"middle/{name}: nobody judges this; move it to accepted, wrong or slow"
        for name in ("partial", "stray.py")
    ]
    assert read_solutions(problem, Kind.ACCEPTED).faults == ()


def test_a_link_to_nothing_and_a_folder_that_is_a_file_are_told(problem, add):
    add("accepted", "")
    add("wrong/fine.py")
    (problem.solutions / "wrong" / "gone.py").symlink_to("nowhere.py")
    programs, faults = read_solutions(problem)
    assert [program.file for program in programs] == ["wrong/fine.py"]
    assert [str(fault).partition(": ")[0] for fault in faults] == ["middle/accepted", "middle/wrong/gone.py"]
    assert all("cannot be read: " in str(fault) for fault in faults)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_file_that_may_not_be_read_is_told(problem, add):
    add("wrong/secret.py").chmod(0)
    assert "Permission denied; make it readable" in str(read_solutions(problem).faults[0])


def test_the_usual_program_of_a_mistake_comes_before_its_variants(problem, add):
    for name in ("b-coarse", "a-fine", "b", "a"):
        add(f"wrong/{name}.py", f'"""{name[0]}"""\n')
    assert [each.path.stem for each in known_mistakes(problem)] == ["a", "a-fine", "b", "b-coarse"]


def test_the_source_of_one_accepted_program(problem, add):
    add("accepted/fast.py", b"x = 1\n")
    assert accepted_source(problem, "fast.py") == b"x = 1\n"
    assert accepted_source(problem, "slow.py") is None


@pytest.mark.parametrize(
    ("path", "wanted"),
    [
        ("/home/me/solutions/middle/accepted/fast.py", True),
        ("solutions/middle/wrong/floor.py", True),
        ("/home/me/solutions/other/accepted/fast.py", False),
        ("/home/me/solutions/middle/fast.py", False),
        ("/home/me/middle.py", False),
    ],
)
def test_whether_a_path_is_a_solution_of_the_setters(path, wanted):
    assert is_solution(path, "middle") is wanted


@pytest.mark.parametrize(
    ("name", "wanted"), [("a.py", True), (".a.py", False), ("a.pyc", False), ("a", False), ("py", False)]
)
def test_which_names_are_programs(name, wanted):
    assert is_program(Path("x") / name) is wanted


def test_the_verdicts_that_each_folder_allows():
    allowed = {kind: {verdict.value for verdict in Verdict if kind.allows(verdict)} for kind in Kind}
    assert allowed == {
        Kind.ACCEPTED: {"AC"},
        Kind.WRONG: {"WA", "TLE", "MLE", "OLE", "RTE"},
        Kind.SLOW: {"TLE"},
    }
