"""A new atom is one file of a pack; a kata of it goes through the commands.

Katas of the other types are in test_other_topics.py.
"""

from __future__ import annotations

import json
import shutil

import pytest

pytestmark = pytest.mark.slow

TRUTH = '''\
"""`truth`: True or False; on a line, yes or no."""

from judge.values.atoms import Atom

_SENT = {"True": True, "False": False}


class Truth(Atom):
    """A bool."""

    text = "truth"  # its name
    noun = "True or False"  # in messages, one and several
    plural = "truths"
    annotation = "bool"  # in Python
    samples = (False, True)  # the simplest first; without any it is for answers only

    def why_not(self, value):
        """Why this is not a value of the type, or None."""
        return None if type(value) is bool else f"{value!r} is not True or False"

    def value_of(self, raw):
        """The value of an answer as it arrives: JSON, a bool by its type's name and its text."""
        if type(raw) is bool:
            return raw
        if type(raw) is dict and raw.get("type") == "bool" and raw.get("text") in _SENT:
            return _SENT[raw["text"]]
        raise ValueError("not a bool")

    def sent(self, value):
        """How a value arrives."""
        return {"type": "bool", "text": str(value)}

    def text_of(self, value):
        """As a token of a program, without blanks."""
        return "yes" if value else "no"

    def value_from(self, token):
        """The value of a token."""
        if token not in ("yes", "no"):
            raise ValueError("not yes or no")
        return token == "yes"


TYPE = Truth
'''
TOML = """\
title = "Oddness"
tier = "junior"
summary = "Which are odd."
entry = "oddness"
answer = "[truth]"

[limits]
cpu_seconds = 5
wall_seconds = 10
memory_mb = 512
output_mb = 8

[parameters]
ns = { type = "[integer; 1..5]", low = -9, high = 9, about = "numbers" }
flip = { type = "truth", low = 0, high = 0, about = "whether the even ones are asked for" }
"""
STATEMENT = """\
# Oddness

It takes {{ns.type}}, gives {{answer}}.

    >>> oddness([1, 2], False)
    [True, False]
    >>> oddness([4], True)
    [True]
"""
MODULE = """\
from judge.problem.declare import group


def solve(ns, flip):
    return [(n % 2 == 1) != flip for n in ns]


def drawn(draw):
    return tuple(draw.integer(-9, 9) for _ in range(draw.integer(1, 5))), draw.boolean()


GROUPS = [group("drawn", "Drawn ones.", drawn, cases=12, points=60)]
"""
RIGHT = """\
def oddness(ns, flip):
    assert isinstance(ns, list)
    return [(n % 2 == 1) != flip for n in ns]
"""
WRONG = RIGHT.replace("n % 2", "n % 3")
FILES = {
    "problems/oddness/problem.toml": TOML,
    "problems/oddness/problem.py": MODULE,
    "problems/oddness/statement.md": STATEMENT,
    "problems/types/truth.py": TRUTH,
    "solutions/oddness/accepted/right.py": f'"""right\n\nAs told.\n"""\n{RIGHT}',
    "solutions/oddness/wrong/mistaken.py": f'"""mistaken\n\nIt errs. Do not.\n"""\n{WRONG}',
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    pack = tmp_path_factory.mktemp("types")
    for name, text in FILES.items():
        (pack / name).parent.mkdir(parents=True, exist_ok=True)
        (pack / name).write_text(text)
    return pack


@pytest.fixture(autouse=True)
def _its_problems(folder, monkeypatch):
    monkeypatch.setenv("JUDGE_PROBLEMS", str(folder / "problems"))


def test_the_kata_is_sound_by_the_setters_own_check(judge):
    ended = judge("verify", "oddness", "--pin")
    assert (ended.status, ended.err) == (0, ""), ended.out


def test_a_mistake_is_told_shrunk_and_named(folder, judge):
    wrong = folder / "solutions" / "oddness" / "wrong" / "mistaken.py"
    ended = judge("run", "oddness", wrong, "--json")
    result = json.loads(ended.out)
    assert (result["verdict"], result["pitfall"]["names"]) == ("WA", ["mistaken"])
    found = result["counterexample"]
    again = judge("try", "--json", found["replay"], wrong)
    assert json.loads(again.out)["case"]["input"] == found["input"]
    assert judge("run", "oddness", wrong, "--fresh", "20s", "--seed", 1, "--no-name").status == 1
    right = folder / "solutions" / "oddness" / "accepted" / "right.py"
    assert judge("run", "oddness", right, "--fresh", "0.1s", "--seed", 1).status == 0


def test_the_stub_and_the_statement_tell_the_types(judge, tmp_path):
    assert judge("start", "oddness").status == 0
    compile((tmp_path / "oddness.py").read_text(), "oddness.py", "exec")
    problem = json.loads(judge("show", "oddness", "--json").out)
    assert problem["answer"] == "[truth]"
    assert [each["type"] for each in problem["parameters"]] == ["[integer; 1..5]", "truth"]
    assert "It takes [integer; 1..5], gives [truth]." in problem["statement"]


def test_a_type_that_cannot_be_loaded_is_the_setters_fault(folder, judge, tmp_path, monkeypatch):
    shutil.copytree(folder, tmp_path / "pack")
    monkeypatch.setenv("JUDGE_PROBLEMS", str(tmp_path / "pack" / "problems"))
    truth = tmp_path / "pack" / "problems" / "types" / "truth.py"
    truth.write_text("TYPE = 1 / 0\n")
    assert "types/truth.py cannot be loaded: ZeroDivisionError" in judge("verify", "oddness").out
    truth.unlink()
    missing = judge("verify", "oddness").out
    assert "oddness/problem.toml:5: answer = '[truth]' is not a type: 'truth' is unknown" in missing
