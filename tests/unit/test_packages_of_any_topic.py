"""Packages of katas of any topic: checkers, formats, classes and growth, decided as the judge decides."""

import io
import itertools
import json
import shutil
import subprocess
import sys
from collections import Counter
from decimal import Decimal
from fractions import Fraction
from functools import partial
from pathlib import Path

import pytest
from export_edges import VALIDATOR, judged
from msgspec.structs import replace

import judge
from judge.data.load import load_data
from judge.packs import cases
from judge.packs.driver import as_program
from judge.packs.export import brought_along
from judge.packs.metadata import Version, problem_yaml
from judge.packs.package import Contents
from judge.packs.programs import Programs
from judge.packs.schemas import NotExportable, accepted_form, check_forms, form_of
from judge.packs.statement import latex
from judge.problem.load import load_problem
from judge.run.formatted import FormatRunner, Talk
from judge.sandbox.boundary import ProgramResult, Stop, Usage
from judge.sandbox.encode import encode
from judge.values import check
from judge.values.answers import AnyOf, Judged, Real, Tolerance
from judge.values.check import Accepted
from judge.values.grammar import parse

pytestmark = pytest.mark.slow

KATAS = Path(judge.__file__).parent / "manual" / "katas"
CALLS = """

from judge.problem.declare import Format


def write(capacity, calls):
    return "".join(" ".join(map(str, call)) + "\\n" for call in (("cache", capacity), *calls))


def read(output):
    words = output.split()
    return [None if each == "-" else int(each) for each in words]


def show(answer):
    return "".join("-\\n" if each is None else f"{each}\\n" for each in answer)


FORMAT = Format(write, read, show)
"""
ENTRY_JUDGED = """

from judge.problem.declare import Judged

count = solve


def solve(stock, moves):
    def entry(least):
        return Judged(lambda value, _: f"below {least}, of {stock}" if value < least else None, least)

    return {thing: entry(each) for thing, each in count(stock, moves).items()}
"""


class Packed:
    """A kata's package of one version in a folder, without programs."""

    def __init__(self, problem, folder):
        self.problem, self.folder = problem, folder
        self.data = load_data(problem, store=None)
        self.tests = tuple(cases.tests_in(self.data, []))
        brought = brought_along(problem, self.tests)
        files = Contents(problem, self.tests, Programs((), {}, (), 1), "", brought).files(Version.NEW)
        for path, content in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_bytes(content)

    def _run(self, words, given):
        words = [sys.executable, "-B", *words]
        return subprocess.run(words, cwd=self.folder, input=given, capture_output=True, check=False)

    def takes(self, given):
        """Whether the input validator takes an input."""
        return self._run(["input_validators/validate.py"], given).returncode == 42

    def accepts(self, test, output):
        """Whether the output validator accepts an output for a test."""
        base = f"data/{test.folder}/{test.stem}"
        ended = self._run(["output_validator/validate.py", f"{base}.in", f"{base}.ans", "."], output)
        assert ended.returncode in (42, 43), ended.stderr
        return ended.returncode == 42

    @property
    def said(self):
        """What the last rejection said."""
        return (self.folder / "judgemessage.txt").read_text().splitlines()[-1]


def kata(name, folder, changes=()):
    """A copy of one of the manual's katas, some of its texts replaced; in place of none, more of them."""
    place = folder / "problems" / name
    shutil.copytree(KATAS / "problems" / name, place)
    for file, old, new in changes:
        text = (place / file).read_text()
        assert old in text
        (place / file).write_text(text.replace(old, new, 1) if old else text + new)
    return load_problem(place)


def test_a_checker_travels_and_decides_as_here(tmp_path):
    packed = Packed(kata("tasks-in-order", tmp_path), tmp_path / "package")
    tried = set()
    for test in packed.tests:
        lines = test.answer.decode().splitlines()
        at, row = next(
            (at, row.split()) for at, row in enumerate(lines) if row != "none" or test.stem[:2] == "04"
        )
        orders = [
            " ".join((row[0], *order)) for order in itertools.islice(itertools.permutations(row[1:]), 9)
        ]
        for other in (*orders[1:], "none", "1 8", "8 0 1 2 3 4 5 6 9", " ".join(row)):
            output = "\n".join([*lines[:at], other, *lines[at + 1 :], ""]).encode()
            right = judged(packed.data, test.group, output)
            assert packed.accepts(test, output) is right, (test.stem, other, packed.said)
            tried.add((right, other == " ".join(row)))
        assert packed.takes(test.input)
    assert (True, False) in tried  # another order than the sample's
    assert (False, False) in tried
    first, *rest = packed.tests[2].answer.split(b"\n")
    count, *row = first.split()
    assert not packed.accepts(packed.tests[2], b"\n".join([b" ".join([count, *row[::-1]]), *rest]))
    assert "and comes before it" in packed.said


def test_a_checker_is_asked_about_a_dict_and_its_entries_as_here(tmp_path):
    problem = kata("inventory", tmp_path, [("problem.py", "", ENTRY_JUDGED)])
    packed = Packed(problem, tmp_path / "package")
    test = packed.tests[0]
    assert packed.takes(test.input)
    assert not packed.takes(test.input.replace(b"1 nut 3", b"2 nut 3 nut 3", 1))
    for old, new in (
        (b"2 cog 1 nut 5", new) for new in (b"2 nut 5 cog 1", b"2 nut 8 cog 1", b"2 nut 4 cog 1")
    ):
        output = test.answer.replace(old, new)
        assert packed.accepts(test, output) is judged(packed.data, test.group, output) is (b" 4 " not in new)
    assert packed.said == "case 1: entry 'nut' of the answer: below 5, of {'nut': 3}"
    for line, why in (
        (b"1 nut 5", "has no entry 'cog'"),
        (b"3 cog 1 nut 5 a 1", "has an entry 'a' too many"),
    ):
        assert not packed.accepts(test, test.answer.replace(b"2 cog 1 nut 5", line))
        assert packed.said == f"case 1: the answer {why}"


def test_with_a_format_each_case_is_a_test_which_its_read_decides(tmp_path):
    packed = Packed(kata("depot", tmp_path), tmp_path / "package")
    assert (packed.folder / "data/secret/03-some-shelves-07.in").is_file()
    assert len(packed.tests) == 54
    runner = FormatRunner(packed.problem)
    for test in packed.tests[:6]:
        answer, ((case, target),) = (
            test.answer.decode(),
            zip(test.group.cases, test.group.targets, strict=True),
        )
        exact = partial(packed.data.exact, case, test.group.group)
        for output in (answer, answer.replace("\n", "\r\n"), answer + "refused\n", "two\n", "", "\xff"):
            right = isinstance(runner.decide(output.replace("\r\n", "\n"), target, exact), Accepted)
            assert packed.accepts(test, output.encode()) is right
    assert not packed.accepts(packed.tests[0], b"two\n")
    assert packed.said == "a line is a number or 'refused', not 'two'"
    assert packed.takes(packed.tests[5].input)
    assert not packed.takes(packed.tests[5].input.replace(b"end", b"end "))


def test_without_read_the_words_of_the_whole_output_are_the_answer(tmp_path):
    plain = [("problem.py", "Format(write, read, show)", "Format(write)")]
    packed = Packed(kata("depot", tmp_path, plain), tmp_path / "package")
    assert not list((packed.folder / "output_validator").glob("*problem.py"))
    assert packed.tests[0].answer == b"3 3 none 2\n"
    assert packed.accepts(packed.tests[0], packed.tests[0].answer.replace(b" ", b"\n\n"))
    assert not packed.accepts(packed.tests[0], packed.tests[0].answer + b"1")


def test_a_class_needs_a_format(tmp_path):
    with pytest.raises(NotExportable, match="a class has no form for programs; give it a FORMAT"):
        check_forms(kata("least-recently-used", tmp_path / "without"))
    packed = Packed(kata("least-recently-used", tmp_path, [("problem.py", "", CALLS)]), tmp_path / "package")
    test = packed.tests[0]
    assert packed.accepts(test, test.answer)
    assert not packed.accepts(test, test.answer.replace(b"20", b"21"))
    assert not packed.accepts(test, test.answer + b"-\n")
    first, *rest = test.answer.split()
    assert first == b"-"  # of a put, whose answer nobody looks at
    assert packed.accepts(test, b" ".join([b"7", *rest]))


class Printed:
    """A program that prints what it prints, whatever it reads."""

    def __init__(self, output):
        self._lines = io.BytesIO(output)
        self.hear, self.say = self._lines.readline, lambda _: None

    def told(self, packed, test):
        """Why the judge says that it is wrong; "" where it is right."""
        (case,) = test.group.cases
        talk = Talk(packed.problem, packed.data.module.format, case)
        talk(self)
        return talk.reply(ProgramResult(Stop.ANSWERED, self._lines.read(), b"", "", Usage())).answer


def test_a_talk_decides_as_here(tmp_path):
    packed = Packed(kata("higher-lower", tmp_path), tmp_path / "package")
    assert "\ntype: interactive\n" in (packed.folder / "problem.yaml").read_text()
    assert "\nvalidation: custom interactive\n" in problem_yaml(packed.problem, Version.LEGACY, 1)
    test = packed.tests[0]  # 5 of 6
    assert (test.input, test.answer) == (b"1\n6 5\n", b"")
    assert packed.takes(test.input)
    assert not packed.takes(b"1\n6 0\n")
    told = set()
    for output in (b"3\n5\n", b"3\r\n5", b"1\n2\n3\n", b"3\n7\n", b"3\n", b"", b"5\n6\n", b"x\xff y\n5\n"):
        why = Printed(output).told(packed, test)
        assert packed.accepts(test, output) is (why == ""), output
        assert why in ("", why and packed.said)
        told.add(why)
    assert len(told) == 6


def test_both_sides_of_a_talk_may_say_much_before_they_hear(tmp_path):
    says, count = "    program.say(high)", 99999
    long = f"    program.say('higher\\n' * {count})\n    [program.hear() for _ in range({count})]\n{says}"
    packed = Packed(kata("higher-lower", tmp_path, [("problem.py", says, long)]), tmp_path / "package")
    words = "output_validator/validate.py", "data/sample/01-examples-01.in", "no.ans", "."
    program = "import sys; print('1\\n' * 99999 + '3\\n5', flush=True); sys.stdin.read()"
    talk = subprocess.Popen(
        [sys.executable, *words], cwd=packed.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    with subprocess.Popen([sys.executable, "-c", program], stdin=talk.stdout, stdout=talk.stdin):
        talk.stdin.close()
        talk.stdout.close()
        assert talk.wait(60) == 42


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("import numpy", "its checker imports numpy"),
        ("from judge.exact import Surd", "its checker imports judge.exact"),
        ("from judge.problem.declare import decided", "its checker imports judge.problem.declare.decided"),
        ("pairs = zip((), (), strict=True)", "its checker needs a newer Python than PyPy's 3.9"),
    ],
)
def test_a_checker_that_needs_more_stays(line, why, tmp_path):
    problem = kata("tasks-in-order", tmp_path)
    tests = tuple(cases.tests_in(load_data(problem, store=None), []))
    file = problem.folder / "problem.py"
    file.write_text(f"{file.read_text()}\n{line}\n")
    with pytest.raises(NotExportable) as told:
        brought_along(problem, tests)
    assert str(told.value) == why


def test_what_is_too_large_for_a_package_is_told(tmp_path, monkeypatch):
    data = load_data(kata("hops", tmp_path), store=None)
    monkeypatch.setattr(cases, "MOST_INPUT", 0.05)
    large = []
    assert [each.stem for each in cases.tests_in(data, large)][-1] == "05-n-5000"
    assert large == ["06-n-20000, 0 MB", "07-n-80000, 0 MB"]


@pytest.mark.parametrize(
    ("name", "file"), [("runs", "one_loop"), ("inventory", "loop"), ("inventory", "counter")]
)
def test_a_function_of_texts_or_dicts_becomes_a_program(name, file, tmp_path):
    data = load_data(kata(name, tmp_path), store=None)
    source = (KATAS / f"solutions/{name}/accepted/{file}.py").read_text()
    (tmp_path / "program.py").write_text(as_program(data.problem, source))
    for test in cases.tests_in(data, []):
        words = [sys.executable, tmp_path / "program.py"]
        printed = subprocess.run(words, input=test.input, stdout=subprocess.PIPE, check=True).stdout
        assert printed == test.answer or judged(data, test.group, printed)  # a dict may be in another order


def test_a_statement_names_the_parts_of_a_point_and_of_nothing_else(tmp_path):
    problem = kata("tasks-in-order", tmp_path)
    parameters = [
        replace(problem.parameters[0], name=name, type=parse(text))
        for name, text in (("A", "point"), ("span", "(int, int)"), ("r", "real"))
    ]
    told = latex(replace(problem, parameters=tuple(parameters)))
    assert "\\texttt{ax ay span \\ensuremath{\\ldots} r}" in told


READ = [  # an answer's type, the exact answer, what FORMAT.read may return
    ("int", 3, [3, 3.0, True, "3", None]),
    ("real", Real(2), [2, 2.0, True, float("nan"), "2", [2]]),
    ("bool", True, [True, 1, False, "true"]),
    ("text(0..5)?", "a b", ["a b", "a", None, 3]),
    ("[int?; 0..2]", [1, None], [[1, None], (1, None), [1], [1, None, 2], None, {1}]),
    (
        "{text(0..3): real; 0..2}",
        {"b": Real(2), "a": Real(1)},
        [{"a": 1, "b": 2.0}, Counter(b=2, a=1), {"a": 1}, {"a": 1, "b": 2, "c": 3}, {"a": 2, "b": 2}],
    ),
    ("{int: bool}", {1: True}, [{1: True}, {True: True}, {"1": True}, {1: 1}, [(1, True)], [1], {}, None]),
    ("(int, word(a|b))", AnyOf([(1, "a"), (2, "b")]), [(2, "b"), [1, "a"], (1, "b"), (1,), ("a", 1)]),
]


@pytest.mark.parametrize(("text", "exact", "values"), READ)
def test_what_read_returns_is_taken_as_here(text, exact, values):
    type_ = parse(text)
    target, form = check.target(type_, exact, Tolerance()), form_of(type_)
    wanted = json.loads(json.dumps(accepted_form(type_, exact, Tolerance())))
    for value in values:
        here = check.check(type_, encode(value), target, lambda: (exact, Tolerance()))
        try:
            VALIDATOR["held"](form, VALIDATOR["given"](form, value), wanted, "the answer")
            there = True
        except VALIDATOR["Wrong"]:
            there = False
        assert there is isinstance(here, Accepted), value


BEYOND = [  # an answer's type, a right value, values within the bounds or beyond them
    ("int(0..9)", 7, [0, 9, 10, -1]),
    ("real(0..1)?", Real(1), [1, 1.0000000000000002, None, Fraction(1, 3), Decimal("1.0"), Decimal("1.1")]),
    ("[text(1..2)]", ["a"], [["ab", ""], ["ab"], ["\u00fc"], []]),
    ("(word(a|b), bool)", ("a", True), [("b", False), ("c", False)]),
    ("[{int(0..9): real(0..1)}]", [{1: Real(1)}], [[{2: 0.5, 0: 1}, {}], [{10: 1}], [{1: 2}]]),
]


@pytest.mark.parametrize(("text", "sample", "values"), BEYOND)
def test_a_checker_is_not_asked_about_what_is_beyond_the_bounds(text, sample, values):
    type_, exact, asked = parse(text), Judged(lambda value, _group: asked.append(value), sample), []
    target, form = check.target(type_, exact, Tolerance()), form_of(type_)
    for value in values:
        asked.clear()
        check.check(type_, encode(value), target, lambda: (exact, Tolerance()))
        found = VALIDATOR["given"](form, value)
        try:
            there = [VALIDATOR["plain"](form, found)]
        except VALIDATOR["Wrong"]:
            there = []
        assert there == asked
