"""`judge stress`, through the command line, on the little problem of the tests."""

from __future__ import annotations

import json
import signal
from contextlib import contextmanager

import pytest
from cli_support import FLOOR, MEAN

pytestmark = pytest.mark.slow

SHORT = ("--for", "0.3s")


def found_by(ended):
    (text,) = ended.lines
    found = json.loads(text)
    return found | found.pop("result")


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
    (again,) = [line for line in ended.lines if "judge try" in line]
    assert judge("try", again.split()[-2], name).status == 1
    assert judge("try", again.split()[-2], submit(MEAN, "right.py")).status == 0


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
