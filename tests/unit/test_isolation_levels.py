"""Choosing a level of isolation, and refusing one that cannot be had."""

from __future__ import annotations

import threading
import time

import pytest
from bubblewraps import pretend
from sandboxed import LIMITS

from judge.errors import UsageError
from judge.sandbox import launch, levels, open_box
from judge.sandbox import probe as probing

pytestmark = pytest.mark.slow


def test_probe_names_every_level_best_first():
    found = levels()
    assert [level.name for level in found] == ["full", "strong", "limits"]
    assert found[-1].available
    assert all(level.available or level.why_not for level in found)


def test_the_best_level_is_taken():
    best = next(level.name for level in levels() if level.available)
    with open_box(b"", "f.py") as box:
        assert box.isolation == best


def test_an_unknown_level_is_a_usage_error():
    with pytest.raises(UsageError, match="did you mean strong"):
        open_box(b"", "f.py", level="storng")


def test_a_demanded_level_is_not_lowered(monkeypatch):
    monkeypatch.setattr(launch, "bubblewrap_path", lambda: None)
    probing.missing.cache_clear()
    try:
        with pytest.raises(UsageError, match="bubblewrap is not installed") as caught:
            open_box(b"", "f.py", level="full")
        assert "bubblewrap" in (caught.value.remedy or "")
        with open_box(b"", "f.py") as box:
            assert box.isolation in ("strong", "limits")
    finally:
        probing.missing.cache_clear()


def test_a_level_that_fails_in_the_background_leaves_the_next_one_whole(monkeypatch, tmp_path):
    pretend(tmp_path, monkeypatch, "sleep 0.2\necho 'bwrap: no' >&2\nexit 1")
    box = open_box(b"def f(n): return n", "f.py")
    box.warm_up()
    with box:
        assert box.isolation != "full"
        for _ in range(2):
            assert box.call_many("f", [(1,)], LIMITS).replies[0].answer == 1


@pytest.mark.parametrize("seconds", [0, 0.01, 0.03, 0.06])
def test_a_box_may_be_closed_while_it_warms_up(seconds):
    for _ in range(5):
        box = open_box(b"def f(n): return n", "f.py")
        box.warm_up()
        time.sleep(seconds)
        box.__exit__(None, None, None)
    assert not [thread for thread in threading.enumerate() if "prepare" in thread.name]
