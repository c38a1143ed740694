"""A result names the isolation that held it, and none where nothing was held."""

from __future__ import annotations

import json
import shutil

import pytest
from cli_support import MEAN
from jsonschema import Draft202012Validator

from judge.schema import schema_of

pytestmark = pytest.mark.slow
HELD = ("full", "strong", "limits")


def rows(ended, command="run"):
    found = [json.loads(line) for line in ended.lines]
    for row in found:
        Draft202012Validator(schema_of(command)).validate(row)
    return found


def test_what_could_not_be_read_was_held_nowhere(judge, submit):
    submit(MEAN, "class/ann/middle.py")
    submit("#" * (5 << 20), "class/bob/middle.py")
    submit("def middle(a, b) return a\n", "class/eve/middle.py")
    found = {
        row["submission"]: row for row in rows(judge("run", "middle", "class", "--json", "--no-history"))
    }
    assert found["class/bob/middle.py"]["isolation"] is None
    assert {found[f"class/{name}/middle.py"]["isolation"] in HELD for name in ("ann", "eve")} == {True}
    found = {row["student"]: row for row in rows(judge("class", "class", "--json", "--no-name"), "class")}
    assert (found["bob"]["isolation"], found["bob"]["result"]["isolation"]) == (None, None)
    assert found["eve"]["isolation"] == found["ann"]["isolation"] in HELD


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no C compiler")
def test_what_is_seen_without_any_compiler_was_held_nowhere(judge, submit):
    names = [
        submit("bool other(double a) { return a; }\n", "a.c"),
        submit("bool middle(double a, double b, double *out) { return oops; }\n", "b.c"),
        submit("bool middle(double a, double b, double *out) { *out = (a + b) / 2; return true; }\n", "c.c"),
    ]
    for _ in range(2):  # the second time from the store
        seen, compiled, run = rows(judge("run", "middle", *names, "--json", "--no-history"))
        assert (seen["verdict"], seen["isolation"]) == ("CE", None)
        assert (compiled["verdict"], compiled["isolation"] in HELD) == ("CE", True)
        assert (run["verdict"], run["isolation"] in HELD) == ("AC", True)
