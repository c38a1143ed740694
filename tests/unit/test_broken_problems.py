"""The registry of broken problems: each is refused with one line that says what, where and what to do."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from judge.data import load_data
from judge.errors import ExitCode, ProblemError
from judge.spec.load import load_problem

BROKEN = Path(__file__).parent.parent / "fixtures" / "broken_problems"

# For each fault: the file with its line, and words of the complaint and of the remedy.
REFUSED = {
    "absurd-bound": ("problem.toml:17", "high is absurdly large or small", "stay within 1e±4000"),
    "bad-answer": ("problem.toml:5", "answer = 'complex' is unknown", "use one of count, points, parameter"),
    "bad-bound": ("problem.toml:16", "the bounds of 'c' leave nothing: low is above high", "swap them"),
    "bad-builder-argument": (
        "problem.toml:30",
        "a builder cannot take datetime.date(2020, 1, 1)",
        "give a number, text, true or false, or a list",
    ),
    "bad-entry": ("problem.toml:4", "entry 'root count' is no function's name", "use a plain Python name"),
    "bad-group-name": (
        "problem.toml:27",
        "'Small ones' is no name for a group",
        "use small letters, digits and single hyphens",
    ),
    "bad-parameter-name": ("problem.toml:14", "'class' is no parameter's name", "use a plain Python name"),
    "bad-parameter-type": ("problem.toml:15", "type = 'interger' is unknown", "did you mean 'integer'?"),
    "bad-tier": ("problem.toml:2", "tier = 'junoir' is unknown", "did you mean 'junior'?"),
    "bad-toml": ("problem.toml:17", "no TOML: invalid value", "repair this line"),
    "builder-always-rejects": (
        "problem.toml:29",
        "1000 of them rejected by the builder",
        "correct its parameters, or lower count",
    ),
    "builder-breaks-its-word": (
        "problem.toml:30",
        "a builder broke its word: the reach is 4",
        "check its parameters in problem.toml",
    ),
    "builder-gives-a-bool": (
        "problem.py",
        "c has True, a bool, where a number is meant",
        "correct what it returns",
    ),
    "builder-gives-no-case": (
        "problem.py",
        "a case must be a tuple of 1 arguments",
        "correct what it returns",
    ),
    "builder-out-of-bounds": (
        "problem.toml:29",
        "of them out of bounds (c has 15, outside -9 to 9)",
        "correct its parameters, or lower count",
    ),
    "builder-raises": ("problem.py:13", "ZeroDivisionError", "repair it there"),
    "count-with-tolerance": ("problem.toml:7", "a count is right or wrong and has no tolerance", "remove it"),
    "duplicate-group": ("problem.toml:27", "'examples' is there twice in groups", "rename or remove one"),
    "duplicate-parameter": ("problem.toml:21", "'c' is there twice in parameters", "rename or remove one"),
    "example-answer-not-plain": (
        "statement.md:5",
        "the example's answer 'nothing' is no plain value",
        "write numbers, points (x, y), lists or None",
    ),
    "example-answer-text": (
        "statement.md:5",
        "the example's answer '\"0\"' is neither a whole number nor None",
        "correct it, or the answer that problem.toml declares",
    ),
    "example-contradicts": (
        "statement.md:5",
        "the example contradicts the reference: ",
        "correct the example's answer, or the reference",
    ),
    "example-keywords": (
        "statement.md:5",
        "the example 'root_count(c=-1)' is no plain call",
        "write root_count(c) with plain values",
    ),
    "example-no-call": (
        "statement.md:5",
        "the example 'root_count(-1' is no Python call",
        "write root_count(c) with plain values",
    ),
    "example-not-plain": (
        "statement.md:5",
        "the example's arguments are no plain numbers and points",
        "write root_count(c) with plain values",
    ),
    "example-of-another": (
        "statement.md:5",
        "the example calls 'rootcount', not the entry",
        "write root_count(c) with plain values",
    ),
    "example-out-of-bounds": (
        "statement.md:5",
        "the example is invalid: c has -10, outside -9 to 9",
        "correct the example",
    ),
    "example-too-long": (
        "statement.md:5",
        "the example gives 2 arguments where 1 are wanted",
        "write root_count(c) with plain values",
    ),
    "example-without-answer": (
        "statement.md:5",
        "the example shows no answer",
        "write it on the next line (None as None)",
    ),
    "example-wrong-type": (
        "statement.md:5",
        "the example is invalid: c has the float -1.0 where an int",
        "correct the example",
    ),
    "examples-with-seed": ("problem.toml:24", "the examples take no seed", "remove seed"),
    "infinite-bound": ("problem.toml:17", "high is Infinity", "give a finite number"),
    "missing-builder-parameter": (
        "problem.toml:26",
        "missing a required argument: 'reach'",
        "its parameters are reach",
    ),
    "missing-key": ("problem.toml:1", "the key 'summary' is missing in the file", "add summary = …"),
    "missing-seed": ("problem.toml:26", "group 'small' has no seed", "add seed = …"),
    "misspelt-group-key": ("problem.toml:31", "unknown key 'sede'", "did you mean 'seed'?"),
    "misspelt-key": ("problem.toml:4", "unknown key 'enrty'", "did you mean 'entry'?"),
    "misspelt-table": ("problem.toml:7", "unknown key 'limit'", "did you mean 'limits'?"),
    "mistake-twice": ("problem.toml:34", "group 'small' names a mistake twice", "remove one"),
    "module-raises": (
        "problem.py:16",
        "problem.py cannot be loaded: NameError: name 'undefined' is",
        "repair it there",
    ),
    "module-syntax": ("problem.py:12", "syntax error: expected ':'", "repair this line"),
    "negative-points": ("problem.toml:33", "group 'small' has negative points", "give 0 to 100"),
    "negative-seed": ("problem.toml:31", "the seed of group 'small' is negative", "give 0 or more"),
    "negative-tolerance": ("problem.toml:37", "the tolerance relative is negative", "give 0 or more"),
    "no-builders": (
        "problem.py",
        "problem.py defines no BUILDERS",
        'define BUILDERS = {"name": function, …}',
    ),
    "no-cases": ("problem.toml:32", "group 'small' has 0 cases", "give 1 to 1000000"),
    "no-examples": (
        "statement.md",
        "a group wants the worked examples, and there are none",
        "add a line >>> root_count(…) and the ans",
    ),
    "no-module": ("problem.py", "the file is missing", "create "),
    "no-parameters": ("problem.toml:5", "the entry has no parameters", "add a [[parameters]] table for each"),
    "no-promise": ("problem.py", "problem.py defines no function 'promise'", "define promise(c)"),
    "no-reference": ("problem.py", "problem.py defines no function 'reference'", "define reference(c)"),
    "no-statement": ("statement.md", "the file is missing", "create "),
    "no-tolerance": ("problem.toml:20", "group 'examples' has no tolerance", "add a [tolerance] table"),
    "no-toml": ("problem.toml", "the file is missing", "create "),
    "not-utf8": ("problem.toml", "byte 11 is not UTF-8", "save the file as UTF-8"),
    "parameter-with-extent": (
        "problem.toml:8",
        "a parameter has no tolerance in extents",
        "use relative and zero",
    ),
    "points-not-100": ("problem.toml:24", "the groups' points sum to 110", "make them sum to 100"),
    "promise-broken": (
        "problem.toml:29",
        "of them against the promise (c is even)",
        "correct its parameters, or lower count",
    ),
    "promise-raises": (
        "problem.py:9",
        "the promise fails on an example: AttributeError",
        "repair it there",
    ),
    "reference-arity": (
        "problem.py:4",
        "reference does not take the 1 parameters of problem.toml",
        "define reference(c)",
    ),
    "reference-gives-no-answer": (
        "problem.py",
        "a Count is wanted, not 2",
        "repair it there",
    ),
    "reference-of-other-kind": (
        "problem.py",
        "a Count is wanted, not Points(",
        "repair it there",
    ),
    "reference-raises": (
        "problem.py:5",
        "the reference fails: ZeroDivisionError",
        "repair it there",
    ),
    "too-few-cases": (
        "problem.toml:29",
        "no case 4 of 5 in 1000 attempts, 1000 of them already in the group",
        "correct its parameters, or lower count",
    ),
    "unknown-builder": (
        "problem.toml:29",
        "group 'small' wants the unknown builder 'smal'",
        "did you mean 'small'?",
    ),
    "unknown-builder-parameter": (
        "problem.toml:30",
        "cannot take its parameters",
        "did you mean 'reach'?",
    ),
    "unknown-key": ("problem.toml:2", "unknown key 'colour'", "the keys are title, tier, summary, entry"),
    "unknown-placeholder": ("statement.md:1", "unknown placeholder {{c.hihg}}", "did you mean {{c.high}}?"),
    "wrong-type": ("problem.toml:32", "groups.count is text", "give a whole number"),
    "zero-band": ("problem.toml:8", "the band 'snap' has no width", "give a number above 0"),
    "time-limit-too-low": (
        "problem.toml:14",
        "the reference itself would be too slow",
        "give a multiple above 1",
    ),
    "time-reference-not-a-file": (
        "problem.toml:15",
        "'../exact.py' is no solution's file",
        "name a file of the accepted solutions",
    ),
    "zero-limit": ("problem.toml:10", "memory_mb allows nothing", "give a number above 0"),
    "zero-tolerance": (
        "problem.toml:7",
        "the tolerance is 0, which no double can meet",
        "give relative, extent or ulps",
    ),
}


def test_every_broken_problem_is_in_the_registry():
    assert {folder.name for folder in BROKEN.iterdir()} == set(REFUSED)


@pytest.mark.parametrize("fault", sorted(REFUSED))
def test_a_broken_problem_is_refused_in_one_line(fault):
    place, what, remedy = REFUSED[fault]
    with pytest.raises(ProblemError) as caught:
        load_data(load_problem(BROKEN / fault), cache=False)
    error = caught.value
    assert error.where == f"{fault}/{place}"
    assert what in error.what
    assert remedy in (error.remedy or "")
    assert re.fullmatch(r"[^\n]{20,300}", str(error))
    assert error.exit_code is ExitCode.FAULT
