"""Naming the mistake in `judge run`: what is learnt for it, and kept in a cache that others may spoil."""

from __future__ import annotations

import json

import pytest
from cli_support import FLOOR, MEAN
from sampling import nightly

pytestmark = pytest.mark.slow


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
    assert "mistake: floor-division" in ended.out
    assert "the known mistakes' answers are not kept" in ended.err


# -- texts made to keep the judge busy -------------------------------------------------------------------


WITNESSES = {  # the first took 49 s, and eight times that for each doubling
    "one/middle.cpp": "auto middle()->" * 800,
    "two/other.cpp": "auto middle()->" * 8000,
    "three/middle.c": "x middle(" * 6000 + ")" * 60_000,
    "four/middle.go": "/" * 5000 + "\nx; func middle(",
    "five/middle.js": "\nimport {" * 10_000 + "function middle(",
    "six/middle.rs": "struct Pt {" + "a" * 100_000 + "} fn middle(",
    "seven/middle.java": "int middle(" * 10_000 + "<" * 5000 + ">" * 5000 + ") {",
    "eight/middle.py": "a,\n" * 300_000,
    "nine/middle.py": f"{FLOOR}x = [{'0,' * 60_000}]\n",
}


@pytest.fixture
def handed_in(submit):
    for name, text in {**WITNESSES, "ann/middle.py": MEAN, "zoe/middle.py": FLOOR}.items():
        submit(text, f"homework/{name}")


@pytest.mark.nightly
def test_a_class_with_such_files_ends_and_all_others_are_judged(judge, handed_in):
    *rows, _ = map(json.loads, judge("class", "homework", "--json").lines)  # the last is of the class
    found = {row["file"]: row["verdict"] for row in rows}
    assert set(found) == {*WITNESSES, "ann/middle.py", "zoe/middle.py"} - {"two/other.cpp"}
    assert found["ann/middle.py"] == "AC"
    assert found["zoe/middle.py"] == found["nine/middle.py"] == "WA"
    assert "AC" not in {verdict for name, verdict in found.items() if name in WITNESSES}


@pytest.mark.parametrize("size", [60_000, 200_000])
def test_a_mistake_is_named_as_long_as_the_text_is_no_longer_than_a_person_writes(judge, submit, size):
    text = f"{FLOOR}# {'.' * size}\n"
    result = json.loads(judge("run", "middle", submit(text, "middle.py"), "--json", "--no-shrink").out)
    assert result["verdict"] == "WA"
    assert (result["pitfall"] is None) == (size > 65_536)
