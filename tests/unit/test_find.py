"""Finding problems: the order of the places, and what is said of a folder or a pack that is broken.

Names that nobody knows are in golden/transcripts: refused/show.txt.
"""

from __future__ import annotations

import importlib.metadata
import os
import shutil
from pathlib import Path

import pytest

from judge.errors import ProblemError, UsageError
from judge.problem.find import find_problem, problem_folders

SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"


@pytest.fixture
def pack(tmp_path):
    """Makes a folder of problems with these names."""

    def make(place, *names):
        for name in names:
            shutil.copytree(SOUND, tmp_path / place / "problems" / name)
        return (tmp_path / place / "problems").resolve()

    return make


@pytest.fixture(autouse=True)
def _no_other_packs(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)


def test_a_named_folder_comes_first(pack, monkeypatch):
    named, variable = pack("a", "segment"), pack("b", "segment", "roots")
    monkeypatch.setenv("JUDGE_PROBLEMS", f"{variable}{os.pathsep}")
    assert find_problem("segment", [named]).folder == named / "segment"
    assert find_problem("segment").folder == variable / "segment"
    assert find_problem("roots", [named]).solutions == variable.parent / "solutions" / "roots"
    folders = problem_folders([named])
    assert [folder for folder in folders if folder.name == "segment"] == [named / "segment"]


@pytest.mark.parametrize("name", ["gone", "x" * 5000, "a\0b", ""])
def test_a_name_that_is_no_folders_is_refused(name, monkeypatch):
    with pytest.raises(UsageError, match=r"^--problems: .* is not a folder"):
        find_problem("segment", [Path(name or "no\nfolder")])
    monkeypatch.setenv("JUDGE_PROBLEMS", name.replace("\0", "\udcff"))
    if name:
        with pytest.raises(UsageError, match=r"(?s)^\$JUDGE_PROBLEMS: .* is not a folder"):
            find_problem("segment")


def test_a_problem_without_its_toml_is_broken_rather_than_unknown(pack):
    named = pack("a", "roots")
    (named / "roots" / "problem.toml").unlink()
    with pytest.raises(ProblemError, match=r"^roots/problem.toml: the file is missing"):
        find_problem("roots", [named])


class Point:
    """An entry point as an installed pack declares it."""

    name, value = "more", "more.problems"

    def __init__(self, pack):
        self.pack = pack

    def load(self):
        if isinstance(self.pack, BaseException):
            raise self.pack
        return self.pack


@pytest.fixture
def _a_pack_is_installed(tmp_path, monkeypatch):
    told = tmp_path / "site" / "more-1.0.dist-info" / "entry_points.txt"
    told.parent.mkdir(parents=True)
    told.write_text("[judge.problems]\nmore = more.problems\n")
    monkeypatch.syspath_prepend(tmp_path / "site")


@pytest.mark.usefixtures("_a_pack_is_installed")
def test_installed_packs_are_asked_only_on_a_miss(pack, monkeypatch):
    installed = pack("c", "roots")
    asked = []

    def entry_points(group):
        asked.append(group)
        return [Point(str(installed))]

    monkeypatch.setattr(importlib.metadata, "entry_points", entry_points)
    find_problem("segment")
    assert asked == []
    assert find_problem("roots").folder == installed / "roots"
    assert asked == ["judge.problems"]


@pytest.mark.usefixtures("_a_pack_is_installed")
@pytest.mark.parametrize("broken", [ImportError("no module more"), SystemExit(0), "/nowhere/at/all", 7])
def test_a_broken_pack_is_named(broken, monkeypatch):
    monkeypatch.setattr(importlib.metadata, "entry_points", lambda group: [Point(broken)])
    with pytest.raises(ProblemError, match=r"^entry point more.problems: the pack 'more' .*uninstall it$"):
        find_problem("roots")
