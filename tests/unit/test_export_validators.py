"""The two validators that a package ships, beside the judge's own decisions on types of every kind."""

from __future__ import annotations

import ast
import hashlib
import json
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from export_edges import VALIDATOR, lines, theirs

import judge.packs as packs
from judge.exact import Surd
from judge.packs.schemas import accepted_form, form_of
from judge.values import check, show
from judge.values.answers import AnyOf, Real, Tolerance, vector
from judge.values.check import Accepted, check_line
from judge.values.grammar import parse

FOLDER = Path(packs.__file__).parent / "validators"
ROOT2 = Surd(0, 1, 2)
NARROW = Tolerance(ulps=Fraction(1))
WIDE = Tolerance(extent=Fraction(1, 10**9), relative=Fraction(1, 10**9), zero=Fraction(1, 10**12))
OUT, IN = (Real(1), 3, "out"), (Real(1), 5, "in")
ANSWERS = [  # of every kind, alone and within others
    ("int", 7),
    ("int?", None),
    ("int?", -3),
    ("word(lit|dark)?", "dark"),
    ("bool", True),
    ("[bool?]", [None, False]),
    ("text(0..9)", "a  b"),
    ("text(0..9)?", "none"),
    ("[text?; 0..5]", ["", None, "ab", 'a"b', "c\\\nd"]),
    ("int(0..9)", 7),
    ("real", Real(ROOT2)),
    ("real", Real(Fraction(1, 3), 1)),
    ("real", Real(0, 5)),
    ("real?", None),
    ("vec3?", vector((Surd(1, 1, 3, 2), Fraction(2), 0), 4)),
    ("(real, vec2)?", (Real(Fraction(1, 2)), vector((ROOT2, -1)))),
    ("[vec2; 0..2]?", [vector((ROOT2, 1)), vector((-1, Fraction(1, 7)))]),
    ("[vec2; 0..2]", []),
    ("[int]", [0, 5, 5, 12]),
    ("[(real, int, word(in|out))]", AnyOf([[OUT, IN], [IN, OUT]])),
    ("[(int, real)?; 0..4]", [AnyOf([(1, Real(2)), (2, Real(2))]), None]),
    ("int?", AnyOf([None, 4])),
    ("[[int; 0..2]; 0..3]", [[1], [], [2, 3]]),
    ("{text(0..4): (int, real?); 0..3}?", {"b": (1, Real(2)), "a b": (2, None)}),
    ("{int: [bool]}", {10: [True], 9: []}),
    ("[{word(in|out): int}]", AnyOf([[{"in": 1}], [{}, {"out": 2, "in": AnyOf([3, 4])}]])),
]  # fmt: skip


def test_every_line_is_decided_as_the_judge_does():
    rng = random.Random(3)
    differ = count = 0
    for text, exact in ANSWERS:
        for tolerance in (NARROW, WIDE):
            type_ = parse(text)
            target = check.target(type_, exact, tolerance)
            form, wanted = form_of(type_), accepted_form(type_, exact, tolerance)
            for line in lines(form, json.loads(json.dumps(wanted)), show.line(type_, target), rng, 40):
                outcome = check_line(type_, line, target, lambda exact=exact, own=tolerance: (exact, own))
                differ += isinstance(outcome, Accepted) != theirs(form, line, wanted)
                count += 1
    assert (differ, count) == (0, 2080)


@pytest.mark.parametrize("name", ["declare.py", "input_validator.py", "talk.py", "output_validator.py"])
def test_a_validator_is_for_python_3_6_and_needs_nothing(name):
    tree = ast.parse((FOLDER / name).read_text(encoding="utf-8"), feature_version=(3, 6))
    modules = {each.module for each in ast.walk(tree) if isinstance(each, ast.ImportFrom)}
    modules |= {alias.name for each in ast.walk(tree) if isinstance(each, ast.Import) for alias in each.names}
    known = {
        "ast",
        "queue",
        "threading",
        "decimal",
        "fractions",
        "hashlib",
        "importlib",
        "json",
        "os",
        "re",
        "sys",
        "typing",
    }
    assert modules <= known
    types = ("real", "int", "bool", "text", "tuple", "list", "dict", "optional")
    assert all(f'["{each}"' in VALIDATOR["__doc__"] for each in types)


FORMS = [
    ["int", [-5, 1], [5, 1], [0, 1]],
    ["real", [-3, 1], [3, 1], [1, 10**8]],
    ["list", ["tuple", [["real", [0, 1], [5, 1], [0, 1]], ["real", [0, 1], [5, 1], [0, 1]]]], 0, 1],
    ["optional", ["word", ["up", "down"]]],
    ["optional", ["text", 0, 4, " abdeno"]],
    ["bool"],
    ["dict", ["int", [0, 1], [99, 1], [0, 1]], ["bool"], 0, 2],
    ["dict", ["text", 0, 4, " ab"], ["word", ["up"]], 0, 3],
]
GOOD = (
    '3\n1 2.5 1 0 0 none "none" true 0 0\n-5 1e-07 0 up "a  b" true 2 9 true 10 true 2 "a b" up aa up\n'
    "0 -0.0 1 5 0.5 down none false 0 0\n"
)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("3\n1", "2\n1"), ("3\n1", "03\n1"), ("1 2.5", "1  2.5"), ("1 2.5", "+1 2.5"), ("1 2.5", "1 2.50"),
        ("1e-07", "1e-09"), ("1e-07 0 up", "1e-07 2 0 0 0 0 up"),
        ("1e-07 0 up", "1e-07 1 0 up"), (" up", " left"), (" up", ""),
        ("none", "None"), ("false 0 0\n", "false 0 0"), ("up\n", "up\r\n"), ("up", "\u00fcp"), ("false", "0"),
        ('"a  b"', '"ab"'), ('"a  b"', '"a b'), ('"a  b"', '"a   b"'), ('"a  b"', "z"), ("true", " true"),
        ("9 true 10", "10 true 9"), ("9 true 10", "9 true 9"), ("aa", "a"), ("aa", '"a b"'), ("2 9", "3 9"),
    ],
)  # fmt: skip
def test_the_input_validator_wants_the_one_way_to_write_a_case(old, new, tmp_path):
    source = (FOLDER / "input_validator.py").read_text(encoding="utf-8")
    names = {"__name__": "validator"}
    exec(compile(source.replace("PARAMETERS = []", f"PARAMETERS = {FORMS}"), "v.py", "exec"), names)
    names["validate"](GOOD.encode())
    assert old in GOOD
    with pytest.raises(names["Invalid"]):
        names["validate"](GOOD.replace(old, new, 1).encode())


def validated(tmp_path, table, given, printed):
    """The end of the output validator of a package with that table."""
    (tmp_path / "validate.py").write_bytes((FOLDER / "output_validator.py").read_bytes())
    (tmp_path / "accepted.json").write_text(table)
    (tmp_path / "in").write_text(given)
    (tmp_path / "ans").write_text("")
    return subprocess.run(
        [sys.executable, "validate.py", "in", "ans", f"{tmp_path}/"],
        cwd=tmp_path,
        input=printed,
        capture_output=True,
        text=True,
    )


@pytest.mark.parametrize(
    ("given", "printed", "status"),
    [("2\n1\n2\n", "1\nnone\n", 42), ("2\n1\n2\n", "1\n2\n", 43), ("9\n", "1\nnone\n", 1)],
)
def test_it_ends_as_packages_ask(given, printed, status, tmp_path):
    key = hashlib.sha256(b"2\n1\n2\n").hexdigest()
    table = json.dumps({"answer": ["optional", ["int"]], "files": {key: [1, None]}})
    ended = validated(tmp_path, table, given, printed)
    assert ended.returncode == status
    assert ("export the package again" in ended.stderr) == (status == 1)
    assert (tmp_path / "judgemessage.txt").exists() == (status == 43)


@pytest.mark.parametrize(("printed", "status"), [("1\n", 42), ("1.0000000001\n", 43)])
def test_the_ends_of_a_number_may_be_longer_than_python_reads(printed, status, tmp_path):
    """Since 3.11 it refuses integers of more than 4,300 digits, of whoever does not ask for them."""
    key, one = hashlib.sha256(b"1\n").hexdigest(), f"1{'0' * 5_000}"
    table = f'{{"answer": ["real"], "files": {{"{key}": [[{one}, {one}, {one}]]}}}}'
    assert validated(tmp_path, table, "1\n", printed).returncode == status


@pytest.mark.slow
def test_a_kata_that_no_package_can_hold_is_left_out_of_the_check_of_edges():
    script = Path(__file__).parents[1] / "benchmarks" / "check_export_edges.py"
    command = [sys.executable, script, "--lines", "16", "error-bound"]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert "left out: its checker imports judge.geometry" in ended.stdout
