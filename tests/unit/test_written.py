"""`judge verify` asks a setter's own code again: a draw, a type of the pack; and reads what editors write."""

import shutil
from pathlib import Path

import pytest

import judge
from judge.problem.load import load_problem
from judge.verify.gate import Options, verify_problem

pytestmark = pytest.mark.slow

KATAS = Path(judge.__file__).parent / "manual" / "katas"
TYPE = """
from judge.values.atoms import Atom


class Lines(Atom):
    text, noun, plural, annotation, samples = "lines", "lines", "lines", "str", ("", "a")

    def why_not(self, value):
        return None if type(value) is str else "no lines"

    def value_of(self, raw):
        return raw["word"]

    def text_of(self, value):
        return TOKEN

    def value_from(self, token):
        return BACK


TYPE = Lines
"""


@pytest.fixture
def runs(tmp_path):
    """The folder of a copy of the kata of texts, to be changed."""
    for kind in ("problems", "solutions"):
        shutil.copytree(KATAS / kind / "runs", tmp_path / kind / "runs")
    return tmp_path / "problems" / "runs"


def faults(folder):
    return [str(each) for each in verify_problem(load_problem(folder), Options(pin=True)).faults]


def test_a_draw_that_takes_chances_of_its_own_is_told(runs):
    source = (runs / "problem.py").read_text()
    row = 'group("alone"'
    line = source[: source.index(row)].count("\n") + 1
    own = f'group("own", "By chance.", lambda draw: ("ab" * random.randrange(1, 30),), cases=5),\n    {row}'
    (runs / "problem.py").write_text("import random\n" + source.replace(row, own))
    told = "group 'own': its draw is not the same twice; take all choices from draw"
    assert f"runs/problem.py:{line + 1}: {told}" in faults(runs)


@pytest.mark.parametrize(
    ("token", "back", "told"),
    [
        ('value.replace(" ", ".") or "_"', '"" if token == "_" else token.replace(".", " ")', None),
        ('value + " x"', "token", "has a blank"),
        ('value.replace(" ", ".") or "_"', "token + 'x'", "comes back as"),
        ('value.replace(" ", ".") or "_"', "int('x')", "is refused"),
    ],
)
def test_a_token_stands_for_its_value(runs, token, back, told):
    (runs.parent / "types").mkdir()
    (runs.parent / "types" / "lines.py").write_text(TYPE.replace("TOKEN", token).replace("BACK", back))
    toml = (
        (runs / "problem.toml")
        .read_text()
        .replace('{ type = "text(0..60)", letters = "a-z ",', '{ type = "lines",')
    )
    (runs / "problem.toml").write_text(toml)
    statement = (runs / "statement.md").read_text().replace("{{s.high}}", "60")
    (runs / "statement.md").write_text(statement)
    (runs / "problem.py").write_text((runs / "problem.py").read_text().replace('" a b"', '"_ab"'))
    found = [each for each in faults(runs) if each.startswith("types/lines.py")]
    assert len(found) == (told is not None), found
    assert told is None or told in found[0]


@pytest.mark.parametrize("name", ["statement.md", "hints.md", "problem.py"])
def test_a_byte_order_mark_is_read_over(runs, name):
    file = runs / name
    file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes())
    assert faults(runs) == []
