"""A new atom is one file of a pack; types that the katas of other topics have not go through the commands."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parent.parent.parent

# The one file that a new atom takes, as the manual has it.
_PAGE = (ROOT / "judge" / "manual" / "new-type.md").read_text(encoding="utf-8")
TRUTH = re.search(r"^## `problems/types/truth\.py`$.*?^```py\n(.*?)^```$", _PAGE, re.MULTILINE | re.DOTALL)[1]

TOML = """\
title = "{title}"
tier = "junior"
summary = "{title}."
entry = "{entry}"
answer = "{answer}"

[limits]
cpu_seconds = 5
wall_seconds = 10
memory_mb = 512
output_mb = 8
{tolerance}
{parameters}
[[groups]]
name = "examples"
about = "The worked examples."
builder = "examples"
points = 40

[[groups]]
name = "drawn"
about = "Drawn ones."
builder = "drawn"
seed = 1
count = 12
points = 60
kills = ["mistaken"]
"""
PARAMETER = '[[parameters]]\nname = "{}"\ntype = "{}"\nlow = {}\nhigh = {}\nabout = "it"\n'


class Kata:
    """A kata by its parts; the right solution, with `changes` made to it, is the mistake."""

    def __init__(self, answer, parameters, example, problem, solution, change, tolerance=""):
        self.answer, self.parameters, self.example = answer, parameters, example
        self.problem, self.tolerance = textwrap.dedent(problem), tolerance
        self.right = textwrap.dedent(solution)
        self.wrong = self.right.replace(*change)
        assert self.wrong != self.right

    def write(self, pack, name):
        folder, solutions = pack / "problems" / name, pack / "solutions" / name
        for each in (folder, solutions / "accepted", solutions / "wrong"):
            each.mkdir(parents=True)
        entry = name.replace("-", "_")
        parameters = "\n".join(PARAMETER.format(*each) for each in self.parameters)
        tolerance = f"\n[tolerance]\n{self.tolerance}\n" if self.tolerance else ""
        toml = TOML.format(
            title=name.capitalize(),
            entry=entry,
            answer=self.answer,
            parameters=parameters,
            tolerance=tolerance,
        )
        (folder / "problem.toml").write_text(toml)
        (folder / "problem.py").write_text(self.problem + '\n\nBUILDERS = {"drawn": drawn}\n')
        (folder / "statement.md").write_text(
            f"# {name}\n\nIt takes {{{{{self.parameters[0][0]}.type}}}}, gives {{{{answer}}}}.\n\n"
            + "".join(f"    >>> {entry}{call}\n    {wanted}\n" for call, wanted in self.example)
        )
        (solutions / "accepted" / "right.py").write_text(f'"""right\n\nAs told.\n"""\n{self.right}')
        (solutions / "wrong" / "mistaken.py").write_text(
            f'"""mistaken\n\nIt errs. Do not.\n"""\n{self.wrong}'
        )


KATAS = {
    "oddness": Kata(
        "[truth]",
        [("ns", "[integer; 1..5]", -9, 9), ("flip", "truth", 0, 0)],
        [("([1, 2], False)", "[True, False]"), ("([4], True)", "[True]")],
        """
        def solve(ns, flip):
            return [(n % 2 == 1) != flip for n in ns], None


        def drawn(draw):
            ns = tuple(draw.integer(-9, 9) for _ in range(draw.integer(1, 5)))
            return ns, draw.boolean()
        """,
        """
        def oddness(ns, flip):
            assert isinstance(ns, list)
            return [(n % 2 == 1) != flip for n in ns]
        """,
        ("n % 2 == 1", "n % 3 == 1"),
    ),
    "sorted-by-size": Kata(
        "[(real, int, word(even|odd))]",
        [("boxes", "[(number, number, word(big|small)); 0..4]", -9, 9)],
        [
            (
                '([(3, 4, "big"), (5, 0, "small"), (0, 1, "small")])',
                '[(1, 2, "odd"), (5, 0, "odd"), (5, 1, "odd")]',
            )
        ],
        """
        from fractions import Fraction
        from itertools import groupby

        from judge.exact import Surd
        from judge.values import Real, Run


        def solve(boxes):
            keyed = sorted((x * x + y * y, at) for at, (x, y, _) in enumerate(boxes))
            answer = []
            for square, ties in groupby(keyed, lambda each: each[0]):
                size = Fraction(square)
                root = Surd(0, 1, size.numerator * size.denominator, size.denominator)
                tag = "odd" if square % 2 else "even"
                ties = [(Real(root, 1), at, tag) for _, at in ties]
                answer.append(Run(ties) if len(ties) > 1 else ties[0])
            return answer, None


        def drawn(draw):
            words = ("big", "small")
            boxes = [(draw.integer(-3, 3), draw.integer(-3, 3), draw.choice(words)) for _ in range(4)]
            return (tuple(boxes[: draw.integer(0, 4)]),)
        """,
        """
        def sorted_by_size(boxes):
            found = [((x * x + y * y) ** 0.5, -at, x * x + y * y) for at, (x, y, _) in enumerate(boxes)]
            return [(size, -at, "odd" if square % 2 else "even") for size, at, square in sorted(found)]
        """,
        ('"odd"', '"even"'),
        "relative = 1e-9\nzero = 1e-9",
    ),
    "signs": Kata(
        "array(i8; 5000)",
        [("xs", "array(f64; 5000)", -9, 9)],
        [("([1.0, 0.0, -2.0])", "[1, 0, -1]")],
        """
        def solve(xs):
            return [(x > 0) - (x < 0) for x in xs], None


        def drawn(draw):
            count = draw.choice((0, 3, 5000))
            first = draw.integer(-3, 3)
            return (tuple(float((first + 7 * at) % 7 - 3) for at in range(count)),)
        """,
        """
        def signs(xs):
            import numpy

            return numpy.sign(numpy.asarray(xs)).astype(numpy.int8)
        """,
        ("xs)).a", "xs) + 1).a"),
    ),
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    pack = tmp_path_factory.mktemp("types")
    for name, kata in KATAS.items():
        kata.write(pack, name)
    (pack / "problems" / "types").mkdir()
    (pack / "problems" / "types" / "truth.py").write_text(TRUTH)
    return pack


@pytest.mark.parametrize("name", KATAS)
def test_a_kata_is_sound_by_the_setters_own_check(name, folder, judge):
    ended = judge("verify", "--problems", folder / "problems", name, "--pin")
    assert (ended.status, ended.err) == (0, ""), ended.out


@pytest.mark.slow
@pytest.mark.parametrize("name", KATAS)
def test_a_mistake_is_told_shrunk_named_and_kept(name, folder, judge, tmp_path):
    wrong, kept = folder / "solutions" / name / "wrong" / "mistaken.py", tmp_path / "test_kept.py"
    ended = judge("run", "--json", "--problems", folder / "problems", name, wrong, "--save-regression", kept)
    result = json.loads(ended.out)
    assert result["verdict"] == "WA"
    assert result["pitfall"]["name"] == "mistaken"
    found = result["counterexample"]
    again = judge("replay", "--json", "--problems", folder / "problems", found["replay"], wrong)
    assert json.loads(again.out)["failure"]["input"] == found["input"]
    shown = judge("run", "--problems", folder / "problems", name, wrong).out
    assert "smallest case found" in shown or "no smaller case found" in shown
    assert "internal" not in shown
    right = folder / "solutions" / name / "accepted" / "right.py"
    for program, status in ((wrong, 1), (right, 0)):
        text = (
            kept.read_text().replace(wrong.name, program.name).replace("/wrong/", f"/{program.parent.name}/")
        )
        (tmp_path / "test_again.py").write_text(text)
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            str(tmp_path / "test_again.py"),
        ]
        ended = subprocess.run(command, capture_output=True, timeout=120, cwd=tmp_path, check=False)
        assert ended.returncode == status, ended.stdout


@pytest.mark.parametrize("name", KATAS)
def test_fresh_cases_are_judged_too(name, folder, judge):
    for program, status in (("accepted/right.py", 0), ("wrong/mistaken.py", 1)):
        file = folder / "solutions" / name / program
        ended = judge("stress", "--problems", folder / "problems", name, file, "--for", "0.3s", "--seed", 1)
        assert ended.status == status, ended.out + ended.err


@pytest.mark.parametrize("name", KATAS)
def test_a_program_that_prints_what_is_wanted_is_accepted(name, folder, judge, tmp_path):
    """It knows the answers: the files of `judge data` are what programs read and print."""
    judge("data", "--problems", folder / "problems", name, "--out", tmp_path / "data")
    program = tmp_path / "program.py"
    program.write_text(
        "import sys\nANSWERS = {}\n"
        + "".join(
            f"ANSWERS[{(tmp_path / 'data' / f'{group}.in').read_text()!r}] = "
            f"{(tmp_path / 'data' / f'{group}.ans').read_text()!r}\n"
            for group in ("examples", "drawn")
        )
        + "print(ANSWERS[sys.stdin.read()], end='')\n"
    )
    ended = judge("run", "--json", "--problems", folder / "problems", name, program)
    result = json.loads(ended.out)
    assert (result["verdict"], result["mode"]) == ("AC", "program"), result["failure"]
    document = json.loads((tmp_path / "data" / "drawn.json").read_text())
    assert len(document["cases"]) == 12


@pytest.mark.parametrize("name", KATAS)
def test_the_stub_and_the_statement_tell_the_types(name, folder, judge, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert judge("init", "--problems", folder / "problems", name).status == 0
    (stub,) = tmp_path.glob("*.py")
    compile(stub.read_text(), str(stub), "exec")
    shown = judge("show", "--json", "--problems", folder / "problems", name)
    problem = json.loads(shown.out)
    assert problem["answer"] == KATAS[name].answer
    assert [each["type"] for each in problem["parameters"]] == [each[1] for each in KATAS[name].parameters]
    assert f"It takes {KATAS[name].parameters[0][1]}, gives {KATAS[name].answer}." in problem["statement"]
    assert KATAS[name].answer in judge("show", "--problems", folder / "problems", name).out


def test_a_type_that_cannot_be_loaded_is_the_setters_fault(folder, judge, tmp_path):
    pack = tmp_path / "pack"
    KATAS["oddness"].write(pack, "oddness")
    types = pack / "problems" / "types"
    missing = judge("verify", "--problems", pack / "problems", "oddness")
    assert "oddness/problem.toml:5: answer = '[truth]' is no type: 'truth' is unknown" in missing.out
    types.mkdir()
    (types / "truth.py").write_text("TYPE = 1 / 0\n")
    broken = judge("verify", "--problems", pack / "problems", "oddness")
    assert "types/truth.py cannot be loaded: ZeroDivisionError" in broken.out
