"""Reading right ways with mistakes beside their lines, and rendering each as a program."""

from __future__ import annotations

from pathlib import Path
from shutil import copytree

import pytest

from judge.errors import ProblemError
from judge.mistakes.catalogue import read_catalogue
from judge.mistakes.routes import read_routes
from judge.problem.find import find_problem
from judge.repair.features import features

TEXT = '''"""How the middle goes wrong."""

from math import floor

HALF = 2


def middle(a, b):
    "right"
    # + one-for-both: a = b
    total = a + b
    # ? sign@s: total = a - b
    # = total = b + a
    found = total / HALF
    # ? floor-division: found = floor(total / HALF)
    # : The half is
    # : dropped.
    # ? sign@s: found = (a - b) / 2
    # ? near: found = total / 2 + {1e-3..1e-1}
    # ? far: found = total / 2 + {1e-4..1e-0/2}
    # ? twice: if total:
    # |     found = total / 2
    # ! it halves all the same
    return found


def other(a, b):
    """last-one

    The last of both is taken.
    """
    return b
'''


def changes(name):
    (route, _) = read_routes(TEXT, "here").routes
    return [change for change in route.changes if change.name == name]


def function(change=None):
    read = read_routes(TEXT, "here")
    space = {}
    exec(read.prelude + "\n" + read.routes[0].source(change), space)
    return space["middle"]


def test_the_right_way_is_read_without_its_marks():
    read = read_routes(TEXT, "here")
    assert [(route.name, route.mistake) for route in read.routes] == [("middle", ""), ("other", "last-one")]
    assert read.prelude == "from math import floor\n\nHALF = 2"
    assert "#" not in read.routes[0].source()
    assert read.routes[1].text == "The last of both is taken."
    assert function()(1, 4) == 2.5


@pytest.mark.parametrize(
    ("name", "answers"),
    [
        ("one-for-both", [4.0]),
        ("floor-division", [2]),
        ("sign", [-1.5]),
        ("near", [2.501, 2.51, 2.6]),
        ("far", [2.5001, 2.51, 3.5]),
        ("", [2.5]),
    ],
)
def test_a_change_is_made(name, answers):
    assert [function(change)(1, 4) for change in changes(name)] == answers


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ("def f(:\n", 1, "not Python"),
        ("", None, "there is no code in it"),
        ('def f(a):\n    """wrong-way"""\n    return a\n', None, "no right way"),
        ('def f(a):\n    "right"\n    # : alone\n    return a\n', 3, "belongs to no change"),
        ('def f(a):\n    "right"\n    return a\n    # ? return -a\n', 4, "without its name"),
        ('def f(a):\n    "right"\n    return a\n        # ? x: return -a\n', 4, "no statement"),
    ],
)
def test_a_fault_is_told_with_its_line(text, line, what):
    with pytest.raises(ProblemError) as caught:
        read_routes(text, "pack/mistakes.py")
    assert what in str(caught.value)
    assert caught.value.where == ("pack/mistakes.py" if line is None else f"pack/mistakes.py:{line}")


@pytest.fixture
def catalogue(tmp_path):
    """Reads a mistakes.toml of that text for a problem of the fixtures."""
    copytree(Path(__file__).parents[1] / "fixtures" / "pack", tmp_path / "pack")

    def read(text):
        (tmp_path / "pack" / "solutions" / "mistakes.toml").write_text(text)
        problem = find_problem("middle", [tmp_path / "pack" / "problems"])
        return read_catalogue(problem)

    return read


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("[a]\nseen = 3\n", "in [a]"),
        ("[a]\nneeds = ['slope']\n", "[a] needs 'slope'"),
    ],
)
def test_a_fault_of_the_words_is_told(catalogue, text, what):
    with pytest.raises(ProblemError) as caught:
        catalogue(text)
    assert what in caught.value.what
    assert caught.value.where.startswith("solutions/mistakes.toml")


@pytest.mark.parametrize(
    ("source", "has", "lacks"),
    [
        ("def f(a):\n    return a // 2\n", {"//", "whole"}, {"/", "root", "state"}),
        ("def f(a):\n    return a ** 0.5\n", {"root", "float"}, {"/"}),
        ("seen = {}\ndef f(a):\n    seen[a] = 1\n    return a\n", {"state"}, {"root"}),
        ("def f(a):\n    seen = {}\n    seen[a] = 1\n    return a\n", set(), {"state"}),
        ("import numpy as np\ndef f(a):\n    return np.float32(a)\n", {"float32"}, {"decimal"}),
    ],
)
def test_features_of_a_program(source, has, lacks):
    found = set(features(source))
    assert has <= found
    assert not lacks & found
