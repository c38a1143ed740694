"""A file that cannot be run at all is told what is in its way, in five lines at most."""

from __future__ import annotations

import json
import sys

import pytest

from judge.run.result import Obstacle

pytestmark = pytest.mark.slow

DEF = "def middle(a, b):\n    return (a + b) / 2\n"
STUB = (
    '"""middle: x"""\n\n\ndef middle(a, b):\n    """Do it."""\n    raise NotImplementedError("to be done")\n'
)
CASES = {
    Obstacle.STUB: (
        STUB,
        (
            "RTE  mine.py  middle, its function called\n"
            "  line 4  middle is still to be written: fill in its body; 'judge hint middle'\n"
            "          gives a hint\n"
            "RTE  run-time error"
        ),
    ),
    Obstacle.ARITY: (
        "def middle(a, b, c, d=1):\n    return a\n",
        (
            "RTE  mine.py  middle, its function called\n"
            "  line 1  middle takes 3 to 4 arguments and is called with 2: middle(a, b)\n"
            "RTE  run-time error"
        ),
    ),
    Obstacle.MODULE: (
        "import helper\n\n" + DEF,
        (
            "RTE  mine.py  middle, its function called\n"
            "  line 1  helper cannot be imported: a submission is one file; move what it\n"
            "          needs of helper into it\n"
            "RTE  run-time error"
        ),
    ),
    Obstacle.IMPORT: (
        f"{DEF}n = int(input())\nprint(middle(n, 1))\n",
        (
            "RTE  mine.py  middle, its function called\n"
            "  line 3  EOFError: EOF when reading a line (line 3) ends the import; put what\n"
            "          only you need below if __name__ == '__main__':, or use 'judge run\n"
            "          --mode program'\n"
            "RTE  run-time error"
        ),
    ),
    Obstacle.NESTED: (
        "class Solution:\n    def middle(self, a, b):\n        return (a + b) / 2\n",
        (
            "WA  mine.py  middle, run as a program\n"
            "  cause  middle stands in a class or another function: move it out, to the left\n"
            "         margin\n"
            "WA  wrong answer"
        ),
    ),
    Obstacle.MISNAMED: (
        "def midle(a, b):\n    return (a + b) / 2\n",
        (
            "WA  mine.py  middle, run as a program\n"
            "  line 1  there is no middle; is midle meant to be it? Rename it: def\n"
            "          middle(a, b)\n"
            "WA  wrong answer"
        ),
    ),
    Obstacle.NO_ENTRY: (
        "print(1.5)\n",
        (
            "WA  mine.py  middle, run as a program\n"
            "  cause  there is no middle: write def middle(a, b), which returns the answer; a\n"
            "         print at the top level answers nothing\n"
            "WA  wrong answer"
        ),
    ),
}


@pytest.fixture
def narrow(monkeypatch, submit):
    """A terminal's width, and a module beside the submission."""
    monkeypatch.setenv("COLUMNS", "80")
    submit("x = 1\n", "helper.py")


def test_every_obstacle_has_its_golden_text():
    assert set(CASES) == set(Obstacle)


@pytest.mark.parametrize("kind", CASES, ids=lambda kind: kind.name)
def test_at_most_five_lines(kind, judge, submit, narrow):
    source, wanted = CASES[kind]
    ended = judge("run", "middle", submit(source))
    assert ended.status == 1
    assert ended.out.startswith(wanted), ended.out
    assert len(ended.lines) <= 5
    assert ended.err == ""
    result = json.loads(judge("run", "middle", "mine.py", "--json").out)
    assert (result["counterexample"], result["pitfall"]) == (None, None)
    assert result["failure"]["group"] == "examples"


@pytest.mark.parametrize("kind", CASES, ids=lambda kind: kind.name)
def test_stress_and_replay_tell_it_in_the_same_words(kind, judge, submit, narrow):
    file, wrong = submit(CASES[kind][0]), submit("def middle(a, b):\n    return 7\n", "wrong.py")
    wanted = CASES[kind][1].splitlines()[1:-1]
    stressed = judge("stress", "middle", file, "--for", "20s", "--seed", "1")
    found = judge("run", "middle", wrong, "--json")
    replayed = judge("replay", json.loads(found.out)["counterexample"]["replay"], file)
    for ended in (stressed, replayed):
        assert (ended.status, ended.lines[1 : 1 + len(wanted)]) == (1, wanted), ended.out
        assert len(ended.lines) <= 6
        assert "smallest" not in ended.out


@pytest.mark.parametrize(
    ("module", "wanted"),
    [
        ("maths", "did you mean math?"),
        ("numpi", "did you mean numpy?"),
        ("helper.parts", "move what it needs of helper into it"),
        ("shapely", f"To add it: {sys.executable} -m pip install shapely"),
    ],
)
def test_a_module_that_is_not_there(module, wanted, judge, submit, narrow, monkeypatch):
    monkeypatch.delenv("COLUMNS")
    gone = f'raise ModuleNotFoundError("No module named {module!r}")'  # which may be installed here
    ended = judge("run", "middle", submit(f"{gone}\n{DEF}"))
    assert wanted in ended.out
    assert "ubmission is one file" in ended.out


@pytest.mark.parametrize(
    "source",
    [
        "def middle(*numbers):\n    return 0\n",
        "def middle(a, b=1, *, c=2):\n    return 0\n",
        "def middle(a):\n    return a\n\n\nmiddle = lambda a, b: 0\n",
        "import functools\n\n\n@functools.cache\ndef middle(a, b):\n    pass\n",
        "def middle(a, b):\n    raise ValueError\n",
        "def middle(a, b):\n    import helper\n",
        "for _ in range(int(input())):\n    print(0, input()[:0])\n",
    ],
)
def test_what_runs_and_is_wrong_has_no_hurdle(source, judge, submit, narrow):
    ended = judge("run", "middle", submit(source))
    assert (ended.status, "smaller case" in ended.out or "smallest case" in ended.out) == (1, True)
