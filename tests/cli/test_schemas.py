"""The published JSON Schemas: every command's --json keeps to its own, which refuses what is not it.

A command with --json that has no schema, or no sample here, is a failed test.
"""

from __future__ import annotations

import copy
import io
import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import pytest
from cli_support import BROKEN, FLOOR, MEAN, ROOT
from jsonschema import Draft202012Validator

from judge.cli.app import app
from judge.cli.table import COMMANDS
from judge.problem import Verdict
from judge.problem.level import KataLevel
from judge.run import Failure, GroupResult, LevelResult, Mode, Pitfall, Ratio, Result, Timing, judge_fault
from judge.schema import commands, schema_of, whole

pytestmark = pytest.mark.slow

DIALECT = "https://json-schema.org/draft/2020-12/schema"
FIXTURES = str(ROOT / "tests" / "fixtures" / "problems")
PROGRAM = "for _ in range(int(input())):\n    print(sum(map(float, input().split())) / 2)\n"
RIGHT = {  # a program of one's own that passes: the shipped ones show nobody's progress
    problem: (ROOT / "solutions" / problem / "accepted" / "quadratic.py").read_text(encoding="utf-8")
    + "# mine\n"
    for problem in ("count", "segment", "ray-nearest", "exact-count")
}
FILES = {  # what the samples below name
    "mean.py": MEAN,
    "floor.py": FLOOR,
    "raises.py": "def middle(a, b):\n    return a / 0\n",
    "broken.py": "def middle(a, b)\n",
    "strange.py": "def middle(a, b):\n    return '\\ud800' if a else 10 ** 400\n",
    "program.py": PROGRAM,
    "homework/ada/middle.py": MEAN,
    "homework/bob/middle.py": "def middle(a, b):\n    return '\\ud800' if a else 10 ** 400\n",
    "homework/bob/misspelt-key.py": "x = 1\n",
    "one.py": "def line_count(cx, cy, r, A, B):\n    return 1\n",
    "none.py": "def ray_nearest(cx, cy, r, O, D):\n    return None\n",
    **{f"right/{problem}.py": source for problem, source in RIGHT.items()},
}
PATH = [f"! run {problem} right/{problem}.py -q" for problem in RIGHT]  # every kata passed
# The command's words for each sample of its output, in their order; {replay} is the id of a failing case of
# floor.py. What begins with `!` goes before, and its output is left alone.
SAMPLES: dict[str, list[str]] = {
    "run": [
        "run middle mean.py floor.py raises.py broken.py strange.py program.py",
        "run middle floor.py --group half --no-shrink",
        "run count one.py --no-name --group examples",
        "run ray-nearest none.py --no-name --group examples",
        f"run misspelt-key mean.py --problems {BROKEN}",
    ],
    "try": [
        "try middle 1,2",
        "try middle 1 2 mean.py",
        "try middle 1 2 broken.py",
        "try middle 1 2 program.py --group half",
        "try segment 0,0,5,(-6,3),(6,3)",
        "try ray-nearest 0,0,1,(3,0),(1,0) none.py",
    ],
    "hack": [
        "hack middle",
        "hack middle 1,1",
        "hack middle 1 2000",
        "hack middle 1,2",
        "hack middle --give-up",
        "hack middle --list",
        "hack segment 3 --give-up",
    ],
    "explore": ["explore count", "explore segment 0 0 5 -6 3 6 3 --out page.html"],
    "replay": ["replay {replay} floor.py", "replay {replay} mean.py"],
    "list": ["list"],
    "show": [
        "show middle",
        "show count",
        "show segment",
        "show ray-nearest",
        "show exact-count",
        "show nearest",
    ],
    "why": ["why middle", "why segment", "why count grid", "why nearest", "why nearest n-500"],
    "data": ["data middle --out data"],
    "export": [
        "export middle --out packages --zip",
        "! export middle --out packages --zip --no-submissions",
    ],
    "new": ["new pack", "new pack another"],
    "verify": [
        f"verify root-count --matrix --problems {FIXTURES}",
        "verify middle",
        f"verify bad-toml --problems {BROKEN}",
    ],
    "doctor": ["doctor"],
    "help": ["help", "help time", "help --search exit status"],
    "init": ["init middle", "init count mine.py"],
    "hint": ["hint count", "hint count --all"],
    "next": ["next", "next --init", *PATH, "next"],
    "solution": ["solution count --give-up", PATH[0], "solution count"],
    "class": ["class homework", f"class homework --problems {BROKEN}"],
    "bench": ["bench middle mean.py broken.py floor.py --rounds 1", "bench middle --rounds 2 --languages py"],
    "stress": [
        "stress middle mean.py --for 0.2s",
        "stress middle floor.py --for 1s",
        "stress middle program.py --for 0.2s --group half --seed -1",
        "stress middle raises.py --for 1s --no-shrink --no-name",
        "stress middle broken.py --for 1s",
        f"stress misspelt-key mean.py --problems {BROKEN}",
    ],
    "watch": [],  # it does not end by itself: below
    "history": [
        "! run middle floor.py",
        "! run middle mean.py",
        "history",
        "history middle --limit 1",
        "history --restore 1 --out again.py",
    ],
    "diff": [
        "! run middle floor.py --no-shrink",
        "! run middle mean.py",
        "diff 1 2",
        "diff 2 1",
        "diff 2 2",
    ],
    "practice": ["! run count one.py -q", "practice", "practice junior", PATH[0], "practice junior"],
    "progress": [
        "! hack count 1 0,0,1,(-1,1),(1,1)",
        "! run count one.py --no-shrink",
        "progress",
        "progress senior",
        PATH[0],
        "progress junior",
        "! run count one.py -q",
        "progress junior",
        "progress --row J1",
        "progress professional --rows",
    ],
    "due": ["due", "! run count one.py -q", "! run middle mean.py", "! quiz halves", "due"],
    "quiz": [
        "quiz halves --seed 1",
        "quiz --card middle/half-b --seed 1",
        "quiz --card junior/dot-product",
        "quiz --card junior/points-drawn --cards 2",
        "quiz --card senior/tags-drawn --cards 1",
        "quiz --card middle/spot-segment --cards 1",
        "quiz --interview --cards 0 --kata middle --file floor.py",
        "quiz --interview --cards 3 --kata middle --file mean.py",
        "quiz halves --list",
        "quiz halves --check",
    ],
    "report": ["! run middle floor.py", "report --no-matrix"],
    "worker": ["worker --new-keys keys"],
    "schema": ["schema", "schema run"],
    "completion": ["completion bash", "completion zsh", "completion fish"],
}
OPTIONAL = {"matrix", "unreliable", "busy", "level", "levels", "growth", "size"}  # keys that may be missing
TYPED = "x\n3.5\na\n1\n2\n?\n2\nnone\n\nq\n"  # what a person types; a command that asks nothing leaves it
FREE = {
    "input",
    "bands",
    "rejected",
    "cases",
    "mistakes",
    "broken",
}  # objects whose keys are names of the problem


def with_json() -> list[str]:
    """The commands that have an option --json."""
    found = [(name, app.get_command(None, name)) for name in COMMANDS]
    return [
        name
        for name, command in found
        if command and any("--json" in option.opts for option in command.params)
    ]


@pytest.fixture
def objects(judge, submit, monkeypatch):
    """The objects that a command's samples write."""
    for name, source in FILES.items():
        submit(source, name)

    def write(command: str) -> list[Any]:
        written = []
        for words in SAMPLES[command]:
            monkeypatch.setattr(sys, "stdin", io.StringIO(TYPED))
            if words.startswith("! "):
                assert judge(*words.split()[1:]).status < 2, words
                continue
            if "{replay}" in words:
                failed = json.loads(judge("run", "middle", "floor.py", "--json", "--no-name").out)
                words = words.format(replay=failed["counterexample"]["replay"])
            ended = judge(*words.split(), "--json")
            assert ended.out, (words, ended.err)
            written += [json.loads(line) for line in ended.lines]
        return written or [watched()]

    return write


def watched() -> Any:
    """The first line of a watch that nobody tells to end."""
    command = [sys.executable, "-m", "judge", "watch", "middle", "floor.py", "--json"]
    settings = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, env=settings) as running:
        line = running.stdout.readline()
        running.send_signal(signal.SIGINT)
        running.stdout.read()
    return json.loads(line)


def wrong(value: Any, place: str = "") -> Iterator[tuple[str, Any]]:
    """Values that differ from a right one in one place: a key too many or too few, another type."""
    yield f"{place} of another type", {"wrong": {}}
    if isinstance(value, dict):
        yield f"{place} with a key too many", {**value, "surplus": {}}
        for key, part in value.items():
            if key not in OPTIONAL and place.rpartition(".")[2] not in FREE:
                yield f"{place} without {key}", {k: v for k, v in value.items() if k != key}
            for what, changed in wrong(part, f"{place}.{key}"):
                yield what, {**value, key: changed}
    elif isinstance(value, list):
        for index, part in enumerate(value):
            for what, changed in wrong(part, f"{place}[{index}]"):
                yield what, [*value[:index], changed, *value[index + 1 :]]


def shortened(value: Any) -> Any:
    """The value with at most two items in each list of objects: the others are like them."""
    if isinstance(value, dict):
        return {key: shortened(part) for key, part in value.items()}
    if isinstance(value, list):
        return [shortened(part) for part in value[:2]]
    return value


def test_every_command_with_json_has_a_schema_and_samples_and_no_other_has():
    assert sorted(with_json()) == commands(), "add judge/schema/<command>.json"
    assert sorted(with_json()) == sorted(SAMPLES), "add a sample of the command's output to SAMPLES"


@pytest.mark.parametrize("command", sorted(SAMPLES))
def test_what_a_command_writes_keeps_to_its_schema(command, objects):
    validator = Draft202012Validator(schema_of(command))
    either = Draft202012Validator(whole())
    for value in objects(command):
        validator.validate(value)
        if command != "schema":
            either.validate(value)


@pytest.mark.parametrize("command", sorted(set(SAMPLES) - {"schema"}))
def test_a_schema_refuses_what_a_command_does_not_write(command, objects):
    validator = Draft202012Validator(schema_of(command))
    for value in map(shortened, objects(command)):
        validator.validate(value)
        for what, changed in wrong(value, command):
            assert not validator.is_valid(changed), what


@pytest.mark.parametrize("command", [*sorted(SAMPLES), None])
def test_a_schema_is_one_and_complete_in_itself(command):
    schema = whole() if command is None else schema_of(command)
    Draft202012Validator.check_schema(schema)
    assert schema["$schema"] == DIALECT
    assert schema["title"]
    for part in parts(schema):
        reference = part.get("$ref")
        if isinstance(reference, str) and reference != DIALECT:
            assert reference.removeprefix("#/$defs/") in schema["$defs"], reference
        if part.get("type") == "object" and "properties" in part:
            assert part["additionalProperties"] is False


def parts(schema: Any) -> Iterator[dict[str, Any]]:
    if isinstance(schema, dict):
        yield schema
    for part in schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else ():
        yield from parts(part)


def test_no_shared_definition_is_called_like_a_command():
    shared = json.loads((ROOT / "judge" / "schema" / "shared.json").read_text(encoding="utf-8"))["$defs"]
    assert not set(shared) & set(COMMANDS)


RATIO = Ratio(1.2, 1.1, 1.4, 9, unreliable="too short", busy="busy machine, 50% waiting")
ACCEPTED = Result(
    "count",
    "a.py",
    Mode.PROGRAM,
    Verdict.AC,
    (GroupResult("grid", Verdict.AC, 5, 5, 0.25, 0.1, 100),),
    time=Timing(0.1, 0.2, RATIO, borderline=True),
    memory_bytes=1,
    isolation="full",
)
FAILURE = Failure("off", "grid", 1, {"cx": 10**400, "A": [-0.0, 1e-308]}, "2", "1")
FOUND = {"input": {"cx": 0}, "expected": "2", "got": "1", "message": "off", "replay": None}
REJECTED = Result(
    "count",
    "a.py",
    Mode.FUNCTION,
    Verdict.WA,
    (GroupResult("grid", Verdict.WA, 5, 4, None, 0.1, 100, level=KataLevel.PRODUCTION),),
    FAILURE,
    counterexample=FOUND,
    pitfall=Pitfall(("a", "b"), 0.75, ("", "")),
    levels=(LevelResult(KataLevel.INTERVIEW, 3, 3, 3), LevelResult(KataLevel.PRODUCTION, 1, 1, 0)),
)


@pytest.mark.parametrize("result", [ACCEPTED, REJECTED, judge_fault("count", "a.py", "it fails")])
def test_every_part_of_a_result(result):
    validator = Draft202012Validator(schema_of("run"))
    value = json.loads(json.dumps(result.as_json()))
    validator.validate(value)
    for what, changed in wrong(value, "run"):
        assert not validator.is_valid(changed), what


@pytest.mark.parametrize(
    ("key", "value"),
    [("verdict", "OK"), ("score", 101), ("score", 1.5), ("schema", 2), ("failure", FAILURE.as_json())],
)
def test_values_that_an_accepted_result_cannot_have(key, value):
    changed = copy.deepcopy(ACCEPTED.as_json()) | {key: value}
    assert not Draft202012Validator(schema_of("run")).is_valid(changed)


def test_a_rejection_has_a_failure():
    assert not Draft202012Validator(schema_of("run")).is_valid(REJECTED.as_json() | {"failure": None})


# -- the command -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", [*sorted(SAMPLES), None])
def test_it_is_printed_for_a_person_and_for_a_script(command, judge):
    words = ["schema"] if command is None else ["schema", command]
    printed, line = judge(*words), judge(*words, "--json")
    assert (printed.status, line.status) == (0, 0)
    assert len(line.lines) == 1
    wanted = whole() if command is None else schema_of(command)
    assert json.loads(printed.out) == json.loads(line.out) == wanted


def test_an_unknown_command(judge):
    ended = judge("schema", "rnu")
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == "judge: there is no schema of 'rnu'; did you mean 'run'?\n"
