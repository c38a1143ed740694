"""Trusted programs in one container: alike there and here to the bit, or judged by themselves."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from judge.data.load import load_data
from judge.mistakes.computed import Computer, Program
from judge.mistakes.contained import Contained
from judge.problem.load import load_problem
from judge.sandbox import Boxes

MIDDLE = Path(__file__).parents[1] / "fixtures" / "pack" / "problems" / "middle"
ALIKE = {
    "right": "def middle(a, b):\n    return (a + b) / 2\n",
    "wrong": "def middle(a, b):\n    return a\n",
    "no number": "def middle(a, b):\n    return float('nan') if a > b else [None, 'x', -0.0, {1}]\n",
    "raises": "def middle(a, b):\n    raise ArithmeticError(f'{a}: {b}')\n",
    "raises without a word": "def middle(a, b):\n    return 1 // 0 if a > b else [][1]\n",
    "imports": "import fractions\ndef middle(a, b):\n    from math import floor\n    return floor(a)\n",
    "counts its calls": "n = 0\ndef middle(a, b):\n    global n\n    n += 1\n    return n\n",
}
OTHERWISE = {
    "another process": "import os\ndef middle(a, b):\n    return os.getpid()\n",
    "another type": "import os\ndef middle(a, b):\n    return 1.0 if os.getpid() == HERE else 1\n",
    "another exception": "import os\ndef middle(a, b):\n    return [][0] if os.getpid() == HERE else 1 / 0\n",
    "ends its process": "import os\ndef middle(a, b):\n    os.getpid() == HERE or os._exit(0)\n",
}


@pytest.fixture(scope="module")
def data():
    return load_data(load_problem(MIDDLE), cache=False)


def test_what_answers_alike_and_what_does_not(data):
    sources = ALIKE | {name: text.replace("HERE", str(os.getpid())) for name, text in OTHERWISE.items()}
    programs = {name: Program(text.encode(), f"{name}.py", trusted=True) for name, text in sources.items()}
    computer = Computer(data)
    with Contained(data, list(programs.values()), Boxes()) as contained:
        found = {name: contained.agrees(each, computer.ended(each)[1]) for name, each in programs.items()}
    assert found == {name: name in ALIKE for name in sources}


def test_how_calls_ended_beside_what_they_answer(data):
    for name, text in ALIKE.items():
        program = Program(text.encode(), f"{name}.py", trusted=True)
        does, ends = Computer(data).ended(program)
        assert does == Computer(data).behaviour(program)
        assert list(ends) == [group.group.name for group in data.groups]


def test_a_program_that_cannot_be_compiled_does_not_keep_the_others_from_it(data):
    right, broken = (
        Program(text.encode(), "mine.py", trusted=True) for text in (ALIKE["right"], "def middle(a, b:\n")
    )
    with Contained(data, [broken, right], Boxes()) as contained:
        assert contained.agrees(right, Computer(data).ended(right)[1])
