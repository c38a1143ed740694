"""Naming the mistake in `judge run`: what is learnt for it, and kept in a cache that others may spoil."""

from __future__ import annotations

import json
import threading

import pytest
from cli_support import FLOOR, MEAN
from sampling import nightly


@pytest.fixture
def own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "own"))
    return tmp_path / "own" / "mistakes"


@pytest.mark.parametrize(
    ("source", "options"),
    [
        (FLOOR, ["--no-name"]),
        (MEAN, []),
        ("def middle(a, b: pass\n", ["--json"]),
    ],
)
def test_nothing_is_learnt_where_nothing_is_to_be_named(judge, submit, own_cache, source, options):
    ended = judge("run", "middle", submit(source), *options)
    assert "score" not in ended.out.replace('"score"', "")
    assert not own_cache.exists()


@pytest.mark.parametrize("content", [b"not it\n[]", nightly(b""), nightly(b"\xff\x00" * 99)])
def test_a_spoilt_cache_is_built_anew(judge, submit, own_cache, content):
    name = submit(FLOOR)
    first = judge("run", "middle", name, "--json")
    (file,) = own_cache.iterdir()
    kept = file.read_bytes()
    file.write_bytes(content)
    again = judge("run", "middle", name, "--json")
    assert json.loads(first.out)["pitfall"] == json.loads(again.out)["pitfall"] is not None
    assert file.read_bytes() == kept


def test_a_cache_that_cannot_be_written_costs_a_note(judge, submit, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "file"))
    ended = judge("run", "middle", submit(FLOOR))
    assert "  floor-division" in ended.out
    assert "the known mistakes' answers are not kept" in ended.err


@pytest.mark.slow
def test_two_runs_at_once_leave_one_sound_file(process, submit, own_cache, tmp_path):
    submit(FLOOR)
    found = []
    runs = [
        threading.Thread(
            target=lambda: found.append(process("run", "middle", tmp_path / "mine.py", "--json"))
        )
        for _ in range(2)
    ]
    for run in runs:
        run.start()
    for run in runs:
        run.join()
    assert [json.loads(each.out)["pitfall"]["name"] for each in found] == ["floor-division"] * 2
    assert len(list(own_cache.iterdir())) == 1
