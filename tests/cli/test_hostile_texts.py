"""Texts that are made to keep the judge busy cost their own row, wherever they are read."""

from __future__ import annotations

import json

import pytest
from cli_support import FLOOR, MEAN

from judge.languages import find
from judge.languages.model import _HERE, language_called, languages, near_languages

pytestmark = pytest.mark.slow

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
_TAKES_LONG = "takes more than 2 s to look through this text"


@pytest.fixture
def slow_language(tmp_path, monkeypatch):
    """A language of one's own, a head of which is looked for in many ways: as many as any may have."""
    folder = tmp_path / "own"
    folder.mkdir()
    text = (_HERE / "c.toml").read_text(encoding="utf-8")
    text = text.replace('name = "C"', 'name = "Slow"').replace('".c"', '".slow"')
    head = next(line for line in text.splitlines() if line.startswith("defines"))
    (folder / "slow.toml").write_text(text.replace(head, "defines = 'a{0,7000}{entry}'"))
    monkeypatch.setenv("JUDGE_LANGUAGES", str(folder))
    for read in (languages, near_languages):  # which this process may have asked for before
        read.cache_clear()
    yield "a" * 900_000 + " middle"
    for read in (languages, near_languages):
        read.cache_clear()


@pytest.fixture
def handed_in(submit):
    for name, text in {**WITNESSES, "ann/middle.py": MEAN, "zoe/middle.py": FLOOR}.items():
        submit(text, f"homework/{name}")


def verdicts(outcome):
    return {row["file"]: (row["verdict"], row) for row in map(json.loads, outcome.out.splitlines())}


@pytest.mark.timeout(300)
@pytest.mark.nightly
def test_a_class_with_such_files_ends_and_all_others_are_judged(judge, submit, handed_in, slow_language):
    if find.why_not(language_called("c")):
        pytest.skip("no C here")
    for student in ("ben", "cy"):
        submit(slow_language, f"homework/{student}/{'middle' if student == 'ben' else 'any'}.slow")
    found = verdicts(judge("class", "homework", "--json", "--no-name"))
    unplaced = {"two/other.cpp", "cy/any.slow"}
    assert set(found) == {*WITNESSES, "ann/middle.py", "zoe/middle.py", "ben/middle.slow"} - unplaced
    assert found["ann/middle.py"][0] == "AC"
    assert found["zoe/middle.py"][0] == found["nine/middle.py"][0] == "WA"
    assert found["ben/middle.slow"][0] == "JE"
    assert _TAKES_LONG in json.dumps(found["ben/middle.slow"][1])
    assert "AC" not in {verdict for name, (verdict, _) in found.items() if name in WITNESSES}
    told = judge("class", "homework", "--no-name").err
    assert f"judge: not judged: cy/any.slow: it {_TAKES_LONG}" in told
    assert "two/other.cpp: no problem is called so" in told


@pytest.mark.nightly
def test_of_several_files_such_a_one_is_a_row(judge, submit, slow_language):
    files = [
        submit(slow_language, "any.slow"),
        submit(slow_language, "middle.slow"),
        submit(MEAN, "middle.py"),
    ]
    ended = judge("run", *files, "--json")
    assert ended.status == 3
    rows = [json.loads(line) for line in ended.lines]
    assert sorted(row["verdict"] for row in rows) == ["AC", "JE", "JE"]
    assert all((row["verdict"] == "JE") == (_TAKES_LONG in json.dumps(row)) for row in rows)


@pytest.mark.parametrize("size", [60_000, 200_000])
def test_a_mistake_is_named_as_long_as_the_text_is_no_longer_than_a_person_writes(judge, submit, size):
    text = f"{FLOOR}# {'.' * size}\n"
    result = json.loads(judge("run", "middle", submit(text, "middle.py"), "--json", "--no-shrink").out)
    assert result["verdict"] == "WA"
    assert (result["pitfall"] is None) == (size > 65_536)
