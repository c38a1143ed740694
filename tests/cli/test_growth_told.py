"""How time may grow, and what single groups may take, as `judge show` and `judge why` tell it."""

from __future__ import annotations

import json

import pytest
from cli_support import ROOT
from jsonschema import Draft202012Validator

from judge.schema import schema_of

PACK = str(ROOT / "tests" / "fixtures" / "growth" / "problems")
RULE = {"slope": 0.4, "groups": ["n-2000", "n-6000"]}
OWN = {  # what only some groups have
    "n-2000": {"size": 2000},
    "n-6000": {"size": 6000, "time_limit": 2000.0},
}


def told(judge, *words):
    """The object that the command wrote."""
    ended = judge(*words, "--json", "--problems", PACK)
    assert ended.status == 0
    (line,) = ended.lines
    plain = json.loads(line)
    Draft202012Validator(schema_of(words[0])).validate(plain)
    return plain


def own(group):
    return {key: group[key] for key in ("size", "time_limit") if key in group}


def test_show_writes_the_rule_of_growth_and_the_limits_of_single_groups(judge):
    shown = told(judge, "show", "inversions")
    assert shown["growth"] == RULE
    assert {group["name"]: own(group) for group in shown["groups"] if own(group)} == OWN
    limits = {group["name"]: group["limits"]["cpu_seconds"] for group in shown["groups"] if "limits" in group}
    assert limits == {"n-6000": 40.0}
    assert shown["limits"]["cpu_seconds"] == 10.0


def test_why_writes_the_rule_of_growth_where_a_group_counts_for_it(judge):
    whole = told(judge, "why", "inversions")
    assert whole["growth"] == RULE
    assert {group["name"]: own(group) for group in whole["groups"] if own(group)} == OWN
    one = told(judge, "why", "inversions", "n-6000")
    assert one["growth"] == RULE
    assert one["groups"][0]["limits"]["cpu_seconds"] == 40.0
    few = told(judge, "why", "inversions", "few")
    assert "growth" not in few
    assert own(few["groups"][0]) == {}


@pytest.mark.parametrize("command", ["show", "why"])
def test_a_problem_without_the_rule_has_no_growth(judge, command):
    ended = judge(command, "middle", "--json")
    assert ended.status == 0
    plain = json.loads(ended.lines[0])
    assert "growth" not in plain
    assert not any({"size", "limits", "time_limit"} & set(group) for group in plain["groups"])


@pytest.mark.parametrize("command", ["show", "why"])
def test_people_are_told_the_rule_and_the_limits_too(judge, command):
    text = " ".join(judge(command, "inversions", "--problems", PACK).out.split())
    assert "at most n^0.4 faster than the reference, over n-2000, n-6000" in text
    assert "2000 × the reference" in text
