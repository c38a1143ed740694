"""Boxes of one command: their servers are forked from a seed, which is kept, and ends alone."""

from __future__ import annotations

import os
import signal
import sys

import pytest
from sandboxed import LIMITS, children, require

from judge.sandbox import LEVELS, Containment, container

pytestmark = [pytest.mark.slow, pytest.mark.skipif(sys.platform != "linux", reason="it kills by number")]


def answer(box):
    return box.call("f", [(1,)], LIMITS).replies[0].answer


def source(number):
    return f"import os\nOWN = {number}\ndef f(n):\n    return [n, OWN, os.environ['HOME']]\n".encode()


@pytest.fixture
def starts(monkeypatch):
    real, found = container._STARTER.start, []

    def start(command, **settings):
        found.append(command)
        return real(command, **settings)

    monkeypatch.setattr(container._STARTER, "start", start)
    return found


@pytest.mark.parametrize("level", LEVELS)
def test_one_after_the_other_they_have_one_seed(level, starts):
    require(level)
    starts.clear()
    before, boxes = children(), Containment(level).kept()
    for number in range(3):
        with boxes(source(number), "f.py") as box:
            assert answer(box)[:2] == [1, number]
    assert len(starts) == 1
    boxes.close()
    assert children() == before


@pytest.mark.parametrize(("level", "count"), [("full", 2), ("strong", 1), ("limits", 1)])
def test_beside_each_other_they_share_no_namespaces_and_no_home(level, count, starts):
    require(level)
    starts.clear()
    before, boxes = children(), Containment(level)
    with boxes(source(1), "f.py") as one, boxes(source(2), "g.py") as other:
        homes = {str(answer(box)[2]) for box in (one, other)}
    assert len(starts) == count
    assert len(homes) == (1 if level == "full" else 2)
    assert children() == before


@pytest.mark.parametrize("level", ["strong", "limits"])
def test_one_that_does_not_end_is_killed_and_the_other_goes_on(level, monkeypatch):
    require(level)
    monkeypatch.setattr(container, "END_SECONDS", 0.05)
    boxes = Containment(level).kept()
    with boxes(source(1), "f.py") as other:
        with boxes(source(2), "g.py") as box:
            assert answer(box)[1] == 2
            os.kill(box._here()._pid, signal.SIGSTOP)
        assert answer(other)[1] == 1
    boxes.close()


@pytest.mark.parametrize("level", LEVELS)
def test_a_seed_that_was_killed_costs_nobody_a_verdict(level, starts):
    require(level)
    starts.clear()
    boxes, before = Containment(level).kept(), children()
    with boxes(source(1), "f.py") as box:
        assert answer(box)[1] == 1
    for pid in children() - before:
        os.kill(int(pid), signal.SIGKILL)
    with boxes(source(2), "f.py") as box:
        assert answer(box)[1] == 2
    assert len(starts) == 2
    boxes.close()
