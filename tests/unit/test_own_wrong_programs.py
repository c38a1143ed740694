"""A pack's own wrong programs are named, however few test groups it has, or it is said why not."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from judge.judging import Session, Terms
from judge.problem.find import find_problem

PACK = Path(__file__).parents[1] / "fixtures" / "pack"
TERMS = Terms(timed=False, diagnosed=False)


@pytest.fixture(autouse=True)
def _own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))


@pytest.fixture
def pack(tmp_path):
    """A pack whose wrong program fails in one group only, of so many cases."""

    def make(count):
        shutil.copytree(PACK, tmp_path / "pack")
        place = tmp_path / "pack" / "problems" / "middle" / "problem.toml"
        text = re.sub(r'(?s)\[\[groups\]\]\nname = "examples".*?(?=\[\[groups\]\])', "", place.read_text())
        text = text.replace("count = 30\npoints = 50", f"count = {count}\npoints = 60")
        place.write_text(text)
        return find_problem("middle", [tmp_path / "pack" / "problems"])

    return make


def judged(problem, source):
    with Session(problem, TERMS) as session:
        return session.judge(source, "mine.py")


@pytest.mark.parametrize(("count", "name"), [(30, "floor-division"), (2, None)])
def test_what_fails_in_the_only_group_that_can_is_named_unless_it_fails_too_seldom(pack, count, name):
    problem = pack(count)
    (path,) = (problem.solutions / "wrong").iterdir()
    result = judged(problem, path.read_bytes())
    assert (result.pitfall and result.pitfall.name) == name
    assert [note.endswith("2 wrong answers are too few to be sure") for note in result.notes] == [True] * (
        not name
    )


def test_two_mistakes_that_answer_alike_are_told_apart_by_nobody(pack):
    problem = pack(30)
    (path,) = (problem.solutions / "wrong").iterdir()
    path.with_name("integer-division.py").write_bytes(path.read_bytes().replace(b"floor", b"integer"))
    result = judged(problem, path.read_bytes())
    assert result.pitfall is None
    (note,) = result.notes
    assert "wrong/floor-division.py, wrong/integer-division.py all answer as this does" in note


def test_what_fails_in_another_way_is_given_no_name_and_no_excuse(pack):
    result = judged(pack(30), b"def middle(a, b):\n    return (a + b) / 2 + ((a + b) % 2) * 7\n")
    assert (result.pitfall, result.notes) == (None, ())
