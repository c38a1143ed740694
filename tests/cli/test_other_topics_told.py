"""What is told of answers of the wrong form, and of a setter's slips, in katas of other topics."""

from __future__ import annotations

import shutil

import pytest
from other_topics import BY_ID, KATAS, PROBLEMS, TABLE, checked

from judge.testing import judge_problem

FAST = ("--no-shrink", "--no-name", "--no-history", "--group", "examples")

# The body of the function, and what is told of it on the first of the worked examples.
RETURNED = {
    "divisors": [
        ("{1, 2, 3, 6}", "a set where a list of ints is meant: a set has no order, and list(...) "),
        ("(d for d in (1, 2, 3, 6))", "a generator where a list of ints is meant: wrap it in list(...)"),
        ("n", "6 where a list of ints is meant"),
        ("[1, 2, 3.0, 6]", "the float 3.0 where item 3 is meant as an int"),
        ("[1, 3, 2, 6]", "the right items in the wrong order: the divisors come smallest first"),
        ("[1, 2, 3, 6, 6]", "4 items wanted, 5 given"),
    ],
    "positive-root": [
        ("[1.0]", "a list where a number or None is meant"),
        ("1.5", "x is off by 0.5, relative error 0.5"),
        ("None", "None given, a positive root is there: x = 1.0"),
        ("float('nan')", "nan where a number or None is meant: it is not a finite number"),
    ],
    "unit-vector": [
        ("v[:2]", "the answer has 2 coordinates where (x, y, z) is meant"),
        ("1j", "the complex 1j where (x, y, z) is meant: return a point as (x, y, z)"),
        ("(1 / 3, 2 / 3, 1)", "z is off by 0.33, relative error 0.5"),
    ],
    "larger-fraction": [
        ("'Less'", "'Less' where less, equal or more is meant"),
        ("-1", "-1 where less, equal or more is meant"),
        ("'more'", "'less' wanted, 'more' given"),
    ],
    "by-size": [
        ("{(1, 'odd')}, 1", "a set where part 1 is meant to be a list of tuples: a set has no order"),
        ("[1, 2, 0], 1", "1 where item 1 of part 1 is meant to be "),
        ("[(1, 'odd'), (1, 'odd'), (0, 'odd')], 1", "part 1 of item 2 of part 1: 2 wanted, 1 given"),
        ("[(2, 'odd'), (1, 'odd'), (0, '')], 1", "part 2 of item 3 of part 1: '' where even or odd is meant"),
        ("[(0, 'odd')] * 9, 1", "part 1: 9 items given where at most 8 are meant"),
    ],
    "root-enclosed": [
        ("2.0", "2.0 where (lo, hi) is meant"),
        ("0, None", "None where hi is meant"),
        ("2.25, 1.5", "lo is above hi"),
        ("2.1, 2.2", "lo is above the exact number, 2.0"),
        ("1.0, 1.9", "hi is below the exact number, 2.0"),
    ],
    "rises": [
        ("{0}", "a set where array(i8; 100000) is meant: a set has no order, and list(...) gives it none"),
        ("[0, 1, 0]", "4 items wanted, 3 given"),
        ("[0, 1, 0, 1000]", "item 4: -1 wanted, 1000 given"),
        ("[0.0, 1, 0, -1]", "0.0 where item 1 is meant as an int"),
    ],
    "lamps": [
        ("(2,)", "the tuple (2,) where an int is meant"),
        ("(each for each in lamps)", "a generator where an int is meant"),
        ("'1'", "the str '1' where an int is meant"),
        ("1.0", "the float 1.0 where an int is meant"),
        ("None", "1 wanted, None given"),
    ],
}  # fmt: skip
# A line that a program prints for the first of the worked examples, and what is told of it.
PRINTED = {
    "divisors": ("1 2 3 6", "k = 1 needs 1 more, 3 given"),
    "positive-root": ("None", '"None" where x or none is meant: write none in lower case'),
    "unit-vector": ("1 2", "the line ends too early: it holds x y z"),
    "larger-fraction": ("less more", '"more" after the answer: one line holds less, equal or more'),
    "by-size": ("1 0 odd", "it holds k and then k times (an int, even or odd), an int or none"),
    "root-enclosed": ("1.5", "the line ends too early: it holds lo hi"),
    "rises": ("4 0 1 0", "k = 4 where 3 numbers follow"),
    "lamps": ("1 2", '"2" after the answer: one line holds an int or none'),
}


@pytest.fixture(autouse=True)
def _these_problems(monkeypatch):
    monkeypatch.setenv("JUDGE_PROBLEMS", str(PROBLEMS))


@pytest.mark.parametrize("kata", TABLE, ids=lambda kata: kata.id)
def test_what_is_told_of_wrong_answers(kata, judge, submit):
    names = [
        submit(f"def {kata.entry}(*arguments):\n    {given(kata)}\n    return {body}\n", f"{number}.py")
        for number, (body, _) in enumerate(RETURNED[kata.id])
    ]
    line, told = PRINTED[kata.id]
    names.append(submit(f"for _ in range(int(input())):\n    print({line!r})\n", "printing.py"))
    ended = judge("run", kata.id, *names, "--json", *FAST)
    assert (ended.status, ended.err) == (1, "")
    failures = [result["failure"] for result in checked("run", ended.out)]
    wanted = [*(message for _, message in RETURNED[kata.id]), told]
    for failure, message in zip(failures, wanted, strict=True):
        assert message in failure["message"]
        assert failure["case"] == 1
    kata.sound(ended.out)


@pytest.mark.parametrize("kata", TABLE, ids=lambda kata: kata.id)
def test_routines_of_other_code_are_held_against_the_exact_answers(kata):
    judged = judge_problem(kata.id)
    judged.check(routine(kata, kata.accepted))
    with pytest.raises(AssertionError) as failed:
        judged.check(routine(kata, kata.wrong))
    assert str(failed.value).startswith(f"{kata.id}: {kata.entry} fails ")
    assert "    wanted  " in str(failed.value)
    kata.sound(str(failed.value))


def routine(kata, path):
    """The function of a solution."""
    names = {}
    exec(path.read_text(encoding="utf-8"), names)
    return names[kata.entry]


def given(kata):
    """The arguments by their names."""
    return f"{', '.join(kata.smallest)}, = arguments"


# -- a pack's kata is gone on with, wherever it is --------------------------------------------------------


def test_a_kata_is_gone_on_with_where_only_its_own_folder_leads_to_it(judge, submit, tmp_path, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS")
    kata = BY_ID["by-size"]
    assert judge("init", kata.id, "mine.py", "--problems", PROBLEMS).status == 0
    submit(kata.wrong.read_bytes(), "mine.py")
    ended = judge("run")
    assert (ended.status, ended.err) == (1, "")
    assert f"  {kata.mistake}  likely, score" in ended.out
    assert f"    why     {kata.why}\n" in ended.out
    assert judge("hint").lines[0].endswith(f"{kata.id}, hint 1 of 1")
    submit(kata.accepted.read_bytes(), "mine.py")
    assert judge("run", "-q").out.startswith("AC  accepted, 100 of 100 points")
    shown = judge("solution")
    assert shown.status == 0
    assert "by-size: sorted" in shown.out


# -- a setter's slips -------------------------------------------------------------------------------------


# The kata, its file, what is written there instead of what, and what is told.
SLIPS = [
    ("divisors", "toml", "[int; 1..240]", "[int; 1..3]", "4 items where 1 to 3 are meant"),
    (
        "divisors",
        "toml",
        "[int; 1..240]",
        "real",
        "group 'examples' has no tolerance; add a [tolerance] table",
    ),
    ("divisors", "py", "== 0], None", "== 0] * (1 + 300 * (n > 6)), None", "items where 1 to 240 are meant"),
    ("divisors", "py", "== 0], None", "== 0] + [n / 2] * (n > 6), None", "where an int is meant"),
    ("unit-vector", "toml", '"vec3"', '"vec2"', "the example's answer '(0.3333333333333333, "),
    ("unit-vector", "toml", "relative = 1e-9", "relative = 1e-30", "the example contradicts solve: "),
    ("unit-vector", "py", "], 1), None", "][: 3 - (v[0] > 5)], 1), None", "2 parts where 3 are meant"),
    ("larger-fraction", "toml", "less|equal|more", "less|equal", "'more' where less or equal is meant"),
    ("by-size", "py", "each for each in sorted", "-9 for each in sorted", "the example contradicts solve: "),
    ("root-enclosed", "py", "Fraction(1, 10", "-Fraction(1, 10", "no interval has a negative width"),
    ("rises", "toml", '"array(i8; 100000)"', '"array(i8; 3)"', "items where at most 3 are meant"),
    ("rises", "py", "return [0, *(", "return [0 * len(xs), *(300 * ", "00 in an array(i8; 100000)"),
    (
        "lamps",
        "py",
        "in enumerate(lit) if each",
        "in enumerate(lit, 1.0) if each",
        "fails: TypeError: 'float'",
    ),
    ("lamps", "toml", "[circle; 1..6]", "[circle; 1..2]", "lamps has "),
]


@pytest.mark.parametrize(("name", "file", "old", "new", "told"), SLIPS)
def test_a_slip_is_one_line_and_no_fault_of_the_judge(name, file, old, new, told, judge, tmp_path):
    shutil.copytree(KATAS, tmp_path / "pack")
    place = tmp_path / "pack" / "problems" / name / f"problem.{file}"
    text = place.read_text(encoding="utf-8")
    assert text.count(old) == 1
    place.write_text(text.replace(old, new), encoding="utf-8")
    ended = judge("run", name, BY_ID[name].accepted, "--problems", tmp_path / "pack" / "problems", "-q")
    assert (ended.status, ended.err.count("\n")) == (3, 1)
    assert told in ended.err
    assert name in ended.err
    BY_ID[name].sound(ended.out, ended.err)
