"""What a package says of itself: kinds and formats, limits, arguments for the validator, expectations."""

from __future__ import annotations

import sys

import pytest
from foreign_packages import LEGACY, NEW, written

from judge.errors import ProblemError, UsageError
from judge.packs.foreign.cases import test_files as files_of
from judge.packs.foreign.expected import Demand, own_submissions, tagged
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.package import TimeRule, read_package
from judge.packs.foreign.timing import limit_of
from judge.problem.verdict import Verdict

AC, WA, TLE, RTE, MLE = Verdict.AC, Verdict.WA, Verdict.TLE, Verdict.RTE, Verdict.MLE


def package(folder, *tables):
    return read_package(Opened(str(written(folder, *tables))))


def described(folder, text, base=LEGACY):
    return package(folder, base, {"problem.yaml": text})


NEWER = "problem_format_version: 2025-09\n"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("validation: custom interactive", "interactive problems are not judged"),
        ("validation: custom score", "scoring problems"),
        ("type: scoring", "scoring problems"),
        ("grading: custom", "scoring problems"),
        (f"{NEWER}type: [pass-fail, interactive]", "interactive problems"),
        (f"{NEWER}type: multi-pass", "multi-pass problems"),
        (f"{NEWER}type: submit-answer", "submit-answer problems"),
        (f"{NEWER}constants: {{n: 5}}", "constants"),
        ("problem_format_version: 2023-07-draft", "the format '2023-07-draft'"),
    ],
)
def test_other_kinds_are_refused_in_a_line(tmp_path, text, why):
    with pytest.raises(UsageError, match=why) as refused:
        described(tmp_path, text)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("[1, 2", "this is no YAML"),
        ("just words", "no keys"),
        ("limits: 5", "limits holds no keys"),
        ("limits: {memory: much}", "memory is much"),
        ("limits: {memory: 1e999}", "memory"),
        ("limits: {memory: 1" + "0" * 310 + "}", "from 1 to 1,048,576"),
        ("limits: {memory: .nan}", "memory is nan"),
        ("limits: {output: -1}", "output is -1"),
        ("limits: {time_multiplier: true}", "time_multiplier"),
        ("validation: custom", "output_validators/ is empty"),
        ("validation: own", "neither default nor custom"),
        ("type: puzzle", "'puzzle'"),
        ("validator_flags: {a: 1}", "validator_flags"),
    ],
)
def test_a_broken_description_is_told_in_a_line(tmp_path, text, why):
    with pytest.raises(ProblemError, match=why) as broken:
        described(tmp_path, text)
    assert "problem.yaml" in str(broken.value)


def test_limits_are_those_of_the_formats(tmp_path):
    usual = package(tmp_path, LEGACY)
    assert (usual.memory_bytes >> 20, usual.output_bytes >> 20) == (2048, 8)
    assert usual.time == TimeRule(None, 5, 2)
    own = described(tmp_path, "limits: {memory: 512, output: 1, time_multiplier: 3, time_safety_margin: 4}")
    assert (own.memory_bytes >> 20, own.output_bytes >> 20) == (512, 1)
    assert own.time == TimeRule(None, 3, 4)
    text = f"{NEWER}limits: {{time_limit: 1.5, time_multipliers: {{time_limit_to_tle: 3}}}}"
    limit = limit_of(described(tmp_path, text).time, None)
    assert (limit.seconds, limit.margin) == (1.5, 4.5)


@pytest.mark.parametrize(
    ("rule", "slowest", "seconds", "margin"),
    [
        (TimeRule(None, 5, 2), 0.01, 1, 2),
        (TimeRule(None, 5, 2), 0.2, 1, 2),
        (TimeRule(None, 5, 2), 0.21, 2, 4),  # 1.05, rounded up
        (TimeRule(None, 5, 2), 0.48, 3, 6),
        (TimeRule(None, 2, 1.5, 1), 0.6, 2, 3),
        (TimeRule(None, 2, 1.5, 0.5), 0.6, 1.5, 2.25),
        (TimeRule(None, 2, 1.5, 0.5), 0.01, 0.5, 0.75),
    ],
)
def test_the_time_limit_follows_from_the_slowest_accepted(rule, slowest, seconds, margin):
    limit = limit_of(rule, slowest)
    assert (limit.seconds, limit.margin, limit.slowest) == (seconds, margin, slowest)


def test_the_innermost_file_names_the_validators_arguments(tmp_path):
    more = {
        "problem.yaml": "validator_flags: case_sensitive",
        "data/testdata.yaml": "output_validator_flags: outer",
        "data/secret/a/testdata.yaml": "output_validator_flags: float_tolerance 1e-6",
        "data/secret/b/testdata.yaml": "grading: default",
        **{f"data/secret/{each}.{end}": "" for each in ("a/2", "a/deep/3", "b/4") for end in ("in", "ans")},
    }
    found = {test.name: test.flags for test in files_of(package(tmp_path, LEGACY, more))}
    outer, inner = ("case_sensitive", "outer"), ("case_sensitive", "float_tolerance", "1e-6")
    names = ["sample/1", "secret/1", "secret/a/2", "secret/a/deep/3", "secret/b/4"]
    assert [*found.items()] == [*zip(names, [outer, outer, inner, inner, outer], strict=True)]


def test_in_the_newer_format_a_test_file_may_name_them_itself(tmp_path):
    more = {
        "data/secret/test_group.yaml": "output_validator_args: [float_tolerance, 1e-6]",
        "data/secret/1.yaml": "output_validator_args: [case_sensitive]",
        "data/secret/2.in": "",
        "data/secret/2.ans": "",
        "data/secret/2.yaml": "hint: none",
    }
    found = {test.name: test.flags for test in files_of(package(tmp_path, NEW, more))}
    flags = {"secret/1": ("case_sensitive",), "secret/2": ("float_tolerance", "1e-6")}
    assert found == {"sample/1": ()} | flags


def test_a_test_file_without_an_answer_or_with_arguments_for_the_submission_is_refused(tmp_path):
    with pytest.raises(ProblemError, match="no answer file"):
        files_of(package(tmp_path / "one", LEGACY, {"data/secret/2.in": ""}))
    with pytest.raises(UsageError, match="arguments"):
        files_of(package(tmp_path / "two", NEW, {"data/secret/1.yaml": "args: [x]"}))


def demands(folder, *tables):
    found = own_submissions(package(folder, *tables))
    return {own.name.removeprefix("submissions/"): own.demands for own in found}


def test_what_the_folders_of_submissions_say(tmp_path):
    names = ("wrong_answer/a.py", "odd/b.py", "accepted/README.md", "accepted/.hidden")
    found = demands(tmp_path, LEGACY, {f"submissions/{name}": "" for name in names})
    assert [*found] == ["accepted/right.py", "odd/b.py", "wrong_answer/a.py"]
    assert found["odd/b.py"] == ()
    (wrong,) = found["wrong_answer/a.py"]
    assert [wrong.met(verdict, [AC, verdict]) for verdict in (WA, TLE, AC)] == [True, False, False]


def test_a_tag_goes_before_the_folder(tmp_path):
    (own,) = own_submissions(package(tmp_path, LEGACY))
    (demand,) = tagged(own, [("a.py", b"# @EXPECTED_RESULTS@: TIMELIMIT, RUN_TIME_ERROR\n")]).demands
    assert demand.final == {TLE, RTE}
    assert demand.met(MLE, [])


def test_patterns_of_submissions(tmp_path):
    more = {
        "submissions/submissions.yaml": (
            "time_limit_exceeded:\n  permitted: [AC, WA, TLE]\n"
            "'*/{right,slow}.py':\n  permitted: [AC, TLE]\n  authors: Ada\n"
        ),
        "submissions/time_limit_exceeded/slow.py": "",
        "submissions/time_limit_exceeded/other.py": "",
    }
    found = demands(tmp_path, NEW, more)
    slow = Demand(frozenset({AC, WA, TLE}), frozenset({TLE}))
    more_of_slow = Demand(frozenset({AC, TLE}))
    assert found["time_limit_exceeded/other.py"] == (slow,)
    assert found["time_limit_exceeded/slow.py"] == (slow, more_of_slow)
    assert found["accepted/right.py"] == (Demand(frozenset({AC})), more_of_slow)


def test_judging_goes_on_until_what_is_required_was_met():
    slow = Demand(frozenset({AC, WA, TLE}), frozenset({TLE}))
    assert slow.goes_on([AC, WA])
    assert not slow.goes_on([AC, WA, TLE])
    assert not slow.goes_on([RTE])
    assert slow.met(WA, [AC, WA, TLE])
    assert not slow.met(WA, [AC, WA])
    assert not slow.met(AC, [AC])


def test_a_pattern_with_keys_that_are_not_looked_at_is_told(tmp_path):
    more = {"submissions/submissions.yaml": "accepted:\n  secret/a:\n    permitted: [AC]\n"}
    with pytest.raises(ProblemError, match="not looked at"):
        own_submissions(package(tmp_path, NEW, more))


def test_without_pyyaml_the_command_that_installs_it_is_told(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "yaml", None)
    with pytest.raises(UsageError, match=r"PyYAML.*pip install 'circle-line-judge\[kattis\]'"):
        package(tmp_path, LEGACY)
