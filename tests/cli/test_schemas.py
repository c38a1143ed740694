"""The published JSON Schemas: each is whole, and refuses what is not what its command writes.

What commands write is held against them where the transcripts of `json/` are played; here are the
commands that measure or ask the machine.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest
from cli_support import FLOOR, ROOT
from jsonschema import Draft202012Validator

from judge.cli.app import app
from judge.cli.table import COMMANDS
from judge.problem import Verdict
from judge.problem.model import KataLevel
from judge.run.result import (
    Failure,
    GroupResult,
    LevelResult,
    Pitfall,
    Ratio,
    Result,
    Timing,
    earned,
    judge_fault,
)
from judge.schema import schema_of

pytestmark = pytest.mark.slow

SAMPLES = [
    "list junior",
    "hack middle",
    "hint middle",
    "solution middle --give-up --times",
    "help quiz",
    "help tolerance zero",
    "new pack two-points",
    "verify middle --matrix",
    "export middle --out packages --zip",
    "export middle --out data --format files",
    "doctor",
]
OPTIONAL = {"matrix", "unreliable", "busy", "level", "levels", "growth", "size"}  # keys that may be missing
FREE = {"input", "bands", "rejected", "cases", "mistakes", "broken"}  # whose keys are names of the problem


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


def test_every_command_with_json_has_a_sound_schema():
    for name in COMMANDS:
        command = app.get_command(None, name)
        if any("--json" in option.opts for option in command.params):
            schema = schema_of(command)
            Draft202012Validator.check_schema(schema)
            for part in parts(schema):
                if "$ref" in part:
                    assert part["$ref"].removeprefix("#/$defs/") in schema["$defs"], name
                if part.get("type") == "object" and "properties" in part:
                    assert part["additionalProperties"] is False, name


def test_what_every_command_with_json_writes_is_held_against_its_schema():
    played = {path.stem for path in (ROOT / "tests" / "golden" / "transcripts" / "json").glob("*.txt")}
    held = played | {words.split()[0] for words in SAMPLES} | {"show", "site"}  # tested elsewhere
    assert {name for name in COMMANDS if hasattr(app.get_command(None, name), "writes")} - held == set()


@pytest.mark.parametrize("words", SAMPLES)
def test_a_schema_takes_what_its_command_writes_and_nothing_that_differs(words, judge, submit):
    submit(FLOOR)
    command = words.split()[0]
    line = judge(*words.split(), "--json").lines[0]
    refuses(validator_of(command), shortened(json.loads(line)), command)


def test_a_kata_in_full_keeps_to_its_schema(judge):
    for name in ("middle", "exact-count", "nearest"):  # numbers of any size, limits of one group
        validator_of("show").validate(json.loads(judge("show", name, "--json").out))


def validator_of(command: str) -> Draft202012Validator:
    return Draft202012Validator(schema_of(app.get_command(None, command)))


def refuses(validator: Draft202012Validator, value: Any, command: str) -> None:
    """It takes the value, and none that differs from it in one place."""
    validator.validate(value)
    for what, changed in wrong(value, command):
        assert not validator.is_valid(changed), what


def parts(schema: Any) -> Iterator[dict[str, Any]]:
    if isinstance(schema, dict):
        yield schema
    for part in schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else ():
        yield from parts(part)


GROUP = GroupResult(
    name="grid", verdict=Verdict.WA, cases=5, passed=4, points=100, level=KataLevel.PRODUCTION
)
FAILURE = Failure("off", "grid", 1, {"cx": 10**400, "A": [-0.0, 1e-308]}, "2", "1", given=[1, {"word": "b"}])
REJECTED = Result(
    problem="count",
    submission="a.py",
    verdict=Verdict.WA,
    failure=FAILURE,
    counterexample=FAILURE,
    pitfall=Pitfall(("a", "b"), 0.75, ("", "")),
    time=Timing(ratio=Ratio(1.2, 1.1, 1.4, 9, unreliable="too short"), borderline=True),
    levels=(
        LevelResult(KataLevel.INTERVIEW, True, 3, 3, 3),
        LevelResult(KataLevel.PRODUCTION, False, 1, 1, 0),
    ),
    **earned([GROUP]),
)


@pytest.mark.parametrize("result", [REJECTED, judge_fault("count", "a.py", "it fails")])
def test_every_part_of_a_result(result):
    validator, plain = validator_of("run"), json.loads(json.dumps(result.as_json()))
    validator.validate(plain)
    for key in plain:
        assert not validator.is_valid({name: value for name, value in plain.items() if name != key}), key
    assert not validator.is_valid({**plain, "surplus": 1})
    assert not validator.is_valid({**plain, "verdict": "??"})
    assert not validator.is_valid({**plain, "time": {**plain["time"], "ratio": 1.0}})
