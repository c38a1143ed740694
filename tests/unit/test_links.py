"""Links in folders that others fill: nobody gets another's file by one, not even by exchanging it in time."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from judge.batch.folder import read_class
from judge.files import RefusedError, read_inside, read_ordinary, real_within

PACK = Path(__file__).parents[1] / "fixtures" / "pack" / "problems"
OWN, OTHERS = "def middle(a, b):\n    return a\n", "def middle(a, b):\n    return (a + b) / 2\n"


@pytest.fixture
def place(tmp_path):
    """A class of two; the second student's file is right."""
    root = tmp_path / "class"
    for name, text in (("ada/middle.py", OWN), ("bob/middle.py", OTHERS), ("bob/old/middle.py", OTHERS)):
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


def class_of(root):
    found = read_class(root, folders=[PACK])
    return {each.file: each for each in found.submissions}, {each.file: each.why for each in found.unplaced}


def linked(path, target):
    path.unlink(missing_ok=True)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.symlink_to(target)


@pytest.mark.parametrize("target", ["../bob/middle.py", "../bob/old/../old/middle.py", "more"])
def test_a_link_to_another_students_file_is_refused_in_its_row(place, target):
    if target == "more":  # a link to a link
        linked(place / "ada/more.py", "../bob/middle.py")
        target = "more.py"
    linked(place / "ada/middle.py", target)
    rows, _ = class_of(place)
    assert rows["ada/middle.py"].why.startswith("it is a link to another student's folder, which")
    assert rows["ada/middle.py"].source == b""
    assert (rows["bob/middle.py"].why, rows["bob/middle.py"].source) == ("", OTHERS.encode())


def test_and_one_out_of_the_class_or_to_nobodys_file(place, tmp_path):
    (tmp_path / "outside.py").write_text(OTHERS)
    (place / "model.py").write_text(OTHERS)
    linked(place / "ada/middle.py", tmp_path / "outside.py")
    linked(place / "ada/deep/middle.py", "../../model.py")
    rows, _ = class_of(place)
    assert "a link out of the folder" in rows["ada/middle.py"].why
    assert "a link to a file of nobody" in rows["ada/deep/middle.py"].why
    assert not any(each.source for each in rows.values() if each.student == "ada")


def test_a_hard_link_is_nobodys_where_nothing_tells_whose_it_is(place):
    (place / "ada/middle.py").unlink()
    os.link(place / "bob/middle.py", place / "ada/middle.py")
    rows, _ = class_of(place)
    assert "the same file as another student's (a hard link)" in rows["ada/middle.py"].why
    assert "the same file as another student's (a hard link)" in rows["bob/middle.py"].why


@pytest.mark.skipif(os.geteuid() != 0, reason="needs root, who gives files away")
def test_and_its_owners_where_the_system_knows(place):
    for path in (place / "bob", place / "bob/middle.py"):
        os.chown(path, 4321, 4321)
    os.chown(place / "ada", 4322, 4322)
    (place / "ada/middle.py").unlink()
    os.link(place / "bob/middle.py", place / "ada/middle.py")
    rows, _ = class_of(place)
    assert "a hard link" in rows["ada/middle.py"].why
    assert rows["bob/middle.py"].source == OTHERS.encode()


@pytest.mark.parametrize("which", ["the file", "its folder"])
def test_a_link_that_is_set_between_looking_and_reading_leads_nowhere(place, monkeypatch, which):
    (place / "ada/sub").mkdir()
    (place / "ada/middle.py").rename(place / "ada/sub/middle.py")

    def exchanged(root, path):
        found = real_within(root, path)
        if path == "ada/sub/middle.py":
            if which == "the file":
                linked(place / path, "../../bob/middle.py")
            else:
                (place / "ada/sub").rename(place / "ada/away")
                (place / "ada/sub").symlink_to("../bob")
        return found

    monkeypatch.setattr("judge.files.real_within", exchanged)
    rows, _ = class_of(place)
    assert rows["ada/sub/middle.py"].source == b""
    assert rows["ada/sub/middle.py"].why


def test_reading_below_a_folder(tmp_path):
    (tmp_path / "a/b").mkdir(parents=True)
    (tmp_path / "a/b/c").write_text("text")
    (tmp_path / "link").symlink_to("a/b")
    root = str(tmp_path)
    assert real_within(root, "link/c") == "a/b/c"
    assert read_inside(root, "a/b/c", 2)[0] == b"te"
    for path in ("link/c", "a", "a/b", "a/b/c/d"):
        with pytest.raises(OSError):
            read_inside(root, path)
    for path in ("..", "link/../../..", "/etc/passwd"):
        with pytest.raises(RefusedError):
            real_within(root, path)


def test_what_is_no_ordinary_file_is_not_even_opened(tmp_path, monkeypatch):
    """Opening some devices does something."""
    os.mkfifo(tmp_path / "pipe.py")
    monkeypatch.setattr("judge.files.os.open", lambda *_, **__: pytest.fail("it was opened"))
    with pytest.raises(OSError, match="it is not an ordinary file"):
        read_ordinary(tmp_path / "pipe.py")


def test_a_file_that_is_exchanged_for_a_link_before_it_is_opened_is_not_read(tmp_path, monkeypatch):
    (tmp_path / "bob.py").write_text("bob's")
    mine = tmp_path / "mine.py"
    mine.write_text("mine")
    look = os.stat

    def exchanged(*path, **how):
        found = look(*path, **how)
        monkeypatch.undo()
        mine.unlink()
        mine.symlink_to("bob.py")
        return found

    monkeypatch.setattr("judge.files.os.stat", exchanged)
    with pytest.raises(OSError, match="symbolic links"):
        read_inside(str(tmp_path), "mine.py")
    assert mine.is_symlink()
