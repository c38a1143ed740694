"""`judge stress`, through the command line, on the little problem of the tests."""

from __future__ import annotations

import json
import signal
from contextlib import contextmanager

import pytest
from cli_support import FLOOR, MEAN, ROOT
from mistaken import mistaken

pytestmark = pytest.mark.slow

SHORT = ("--for", "0.3s")


def found_by(ended):
    (text,) = ended.lines
    return json.loads(text)


def test_a_right_one_survives_until_the_time_is_up(judge, submit):
    ended = judge("stress", "middle", submit(MEAN), *SHORT)
    assert (ended.status, ended.err) == (0, "")
    assert ended.lines[0].split() == ["AC", "mine.py", "middle,", "its", "function", "called"]
    assert ended.lines[-1].startswith("AC  nothing broke: ")
    assert " from 2 groups, again with --seed " in ended.lines[-1]


def test_a_wrong_one_is_broken_shrunk_and_its_case_can_be_replayed(judge, submit):
    name = submit(FLOOR)
    ended = judge("stress", "middle", name, "--for", "60", "--no-name")
    assert ended.status == 1
    assert "WA  wrong answer in half: " in ended.out
    assert "smallest case found" in ended.out
    (again,) = [line for line in ended.lines if "judge replay" in line]
    assert judge("replay", again.split()[-2], name).status == 1
    assert judge("replay", again.split()[-2], submit(MEAN, "right.py")).status == 0


def test_json_has_one_object_and_the_seed_repeats_it(judge, submit):
    name = submit(FLOOR)
    ended = judge("stress", "middle", name, "--json", "--for", "60", "--no-name")
    first = found_by(ended)
    assert (ended.status, ended.err) == (1, "")
    assert (first["problem"], first["submission"], first["verdict"]) == ("middle", "mine.py", "WA")
    assert first["failure"]["group"] == "half"
    assert first["counterexample"]["replay"].startswith("middle:")
    assert first["cases"] > 0
    assert first["interrupted"] is False
    second = found_by(
        judge("stress", "middle", name, "--json", "--seed", first["seed"], "--no-shrink", "--no-name")
    )
    assert (second["seed"], second["failure"]) == (first["seed"], first["failure"])
    assert second["counterexample"] is None


def test_without_a_seed_each_time_is_another(judge, submit):
    name = submit(MEAN)
    seeds = {found_by(judge("stress", "middle", name, "--json", *SHORT))["seed"] for _ in range(3)}
    assert len(seeds) > 1


def test_only_the_groups_that_are_asked_for(judge, submit):
    found = found_by(judge("stress", "middle", submit(FLOOR), "--json", "--group", "whole", *SHORT))
    assert found["verdict"] == "AC"
    assert [group["name"] for group in found["groups"]] == ["whole"]


def test_the_mistake_is_named_where_the_pinned_cases_show_it(judge, submit):
    name = submit(mistaken("count", "tangent-twice").decode())
    found = found_by(judge("stress", "count", name, "--json", "--no-shrink"))
    assert found["pitfall"]["name"] == "tangent-twice"


def test_the_case_is_drawn_and_kept_as_a_test(judge, submit, tmp_path):
    name = submit(mistaken("count", "tangent-twice").decode())
    ended = judge(
        "stress", "count", name, "--no-name", "--svg", "case.svg", "--save-regression", "test_mine.py"
    )
    assert ended.status == 1
    assert "<svg" in (tmp_path / "case.svg").read_text()
    assert "import" in (tmp_path / "test_mine.py").read_text()


@pytest.mark.parametrize("given", ["", "x", "-5", "1e3", "3 s", "10d", "٣"])
def test_a_duration_that_is_none_is_refused_in_one_line(judge, submit, given):
    ended = judge("stress", "middle", submit(MEAN), "--for", given)
    assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1)
    assert "is no duration: write 30, 30s, 2m or 1h" in ended.err


@pytest.mark.parametrize(
    ("given", "words"), [("0", "no time at all"), ("0.0s", "no time"), ("9999h", "too long")]
)
def test_no_time_and_for_ever_are_refused_too(judge, submit, given, words):
    ended = judge("stress", "middle", submit(MEAN), "--for", given)
    assert (ended.status, ended.out) == (2, "")
    assert words in ended.err


@pytest.mark.parametrize("given", ["300ms", "0.3", "0.3s", "0.005m"])
def test_durations_with_and_without_units(judge, submit, given):
    found = found_by(judge("stress", "middle", submit(MEAN), "--json", "--for", given))
    assert found["seconds"] >= 0.29


def test_what_is_asked_wrongly_is_said_in_one_line(judge, submit):
    name = submit(MEAN)
    for words, wanted in (
        (["middle", name, "--group", "examples"], "name one of whole, half"),
        (["middle", name, "--group", "hlaf"], "did you mean 'half'?"),
        (["middel", name], "did you mean 'middle'?"),
        (["middle", "mien.py"], "did you mean mine.py?"),
        (["middle", str(ROOT / "solutions" / "count" / "accepted")], "this folder holds several submissions"),
    ):
        ended = judge("stress", *words)
        assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1)
        assert wanted in ended.err


def test_a_source_that_does_not_compile(judge, submit):
    ended = judge("stress", "middle", submit("x = (\n"))
    assert ended.status == 1
    assert ended.lines[-1] == "CE  does not compile"
    assert any(line.split()[:1] == ["at"] and "mine.py:1" in line for line in ended.lines)


@pytest.fixture
def pressed_early(monkeypatch):
    """Ctrl-C is pressed when the progress is shown for the third time."""
    shown = []

    @contextmanager
    def stages(_label):
        def stage(what, done, total):
            shown.append(what)
            if len(shown) == 3:
                signal.raise_signal(signal.SIGINT)

        yield stage

    monkeypatch.setattr("judge.cli.commands.stress.stages", stages)
    return shown


def test_ctrl_c_says_how_many_cases_passed(judge, submit, pressed_early):
    ended = judge("stress", "middle", submit(MEAN), "--for", "1h")
    assert (ended.status, ended.err) == (130, "")
    cases = pressed_early[-1].split(" cases, ")[0]
    assert ended.lines[-1].startswith(f"interrupted  nothing broke: {cases} cases in ")


def test_ctrl_c_in_json_still_writes_the_object(judge, submit, pressed_early):
    ended = judge("stress", "middle", submit(MEAN), "--for", "1h", "--json")
    found = found_by(ended)
    assert (ended.status, found["interrupted"], found["failure"]) == (130, True, None)
    assert found["cases"] > 0


def test_ctrl_c_while_a_failure_is_shrunk_keeps_the_failure(judge, submit, monkeypatch):
    def pressed(*_args, **_options):
        raise KeyboardInterrupt

    monkeypatch.setattr("judge.diagnose.shrink.shrink", pressed)
    ended = judge("stress", "middle", submit(FLOOR), "--for", "60", "--json", "--no-name")
    found = found_by(ended)
    assert (ended.status, found["verdict"], found["interrupted"]) == (1, "WA", True)
    assert found["failure"]["group"] == "half"
    assert found["counterexample"] is None
