"""`judge run --fresh`, through the command line, on the little problem of the tests."""

from __future__ import annotations

import json
import re
import signal
from contextlib import contextmanager

import pytest
from cli_support import FLOOR, MEAN

pytestmark = pytest.mark.slow


def found_by(ended):
    (text,) = ended.lines
    return json.loads(text)


def test_a_right_one_survives_until_the_time_is_up(judge, submit):
    ended = judge("run", "middle", submit(MEAN), "--fresh", "0.3s")
    assert ended.status == 0
    assert ended.lines[0] == "AC  Accepted  mine.py"
    assert re.search(r"fresh  [\d,]+ fresh cases in \d+ s; the same again: --seed \d+", ended.out)


def test_a_wrong_one_is_broken_shrunk_and_its_case_can_be_tried(judge, submit):
    name = submit(FLOOR)
    ended = judge("run", "middle", name, "--fresh", "60", "--json", "--no-name")
    first = found_by(ended)
    assert ended.status == 1
    assert (first["problem"], first["verdict"], first["failure"]["group"]) == ("middle", "WA", "half")
    case = first["counterexample"]["replay"]
    assert judge("try", case, name).status == 1
    assert judge("try", case, submit(MEAN, "right.py")).status == 0
    (seed,) = re.findall(r"--seed (\d+)", " ".join(first["notes"]))
    second = found_by(
        judge("run", "middle", name, "--fresh", "60", "--json", "--seed", seed, "--no-shrink", "--no-name")
    )
    assert second["failure"] == first["failure"]
    assert second["counterexample"] is None


def test_a_mistake_is_named_from_the_katas_own_cases_and_that_is_said(judge, submit):
    ended = judge("run", "middle", submit(FLOOR), "--fresh", "60")
    assert re.search(
        r"a change here mends (\d+) of \1 failures in the kata's own cases$", ended.out, re.MULTILINE
    )


def test_ctrl_c_keeps_what_was_found(judge, submit, monkeypatch):
    """It is pressed when the progress is shown for the third time, and then while a failure is shrunk."""
    shown = []

    @contextmanager
    def stages(_label):
        def stage(what, _done, _total):
            shown.append(what)
            if len(shown) == 3:
                signal.raise_signal(signal.SIGINT)

        yield stage

    monkeypatch.setattr("judge.cli.commands.run.stages", stages)
    ended = judge("run", "middle", submit(MEAN), "--fresh", "1h", "--json")
    assert (ended.status, found_by(ended)["verdict"]) == (130, "AC")

    def pressed(*_args, **_options):
        raise KeyboardInterrupt

    monkeypatch.setattr("judge.diagnose.shrink.shrink", pressed)
    ended = judge("run", "middle", submit(FLOOR), "--fresh", "60", "--json", "--no-name")
    found = found_by(ended)
    assert (ended.status, found["verdict"], found["failure"]["group"]) == (1, "WA", "half")
    assert found["counterexample"] is None


@pytest.mark.parametrize("text", ["", "soon", "0", "-1", "1e9h"])
def test_what_is_no_duration_is_refused(text, judge, submit):
    ended = judge("run", "middle", submit(MEAN), "--fresh", text)
    assert (ended.status, ended.out) == (2, "")
    assert "write 30, 30s, 2m or 1h" in ended.err
