"""A cache that several users share: nobody's file is taken for what another one has made."""

from __future__ import annotations

import os
import shutil
import stat

import pytest

from judge.kept import KeptFile
from judge.languages.store import CacheStore

STRANGER = 65534
RIGHT, WRONG = [("main", b"right")], [("main", b"wrong")]


@pytest.fixture
def store(tmp_path):
    found = CacheStore(lambda: tmp_path)
    found.keep_artifact("right", RIGHT)
    found.keep_artifact("wrong", WRONG)
    return found


@pytest.fixture
def compiled(tmp_path, store):
    return tmp_path / "languages" / "compiled"


def given_away(path):
    """The file is another user's, as one that another user has put there."""
    if os.geteuid():
        pytest.skip("needs root, who gives files away")
    os.chown(path, STRANGER, STRANGER)


@pytest.mark.parametrize("put", [shutil.copy, os.link, os.symlink])
def test_a_program_under_anothers_name_is_none(store, compiled, put):
    (compiled / "right.bin").unlink()
    put(compiled / "wrong.bin", compiled / "right.bin")
    assert store.artifact("right") is None
    assert store.artifact("wrong") == WRONG


def test_what_another_user_has_forged_is_none(store, compiled):
    """Anybody can make a right digest: there is nothing secret in it."""
    store.keep_artifact("right", WRONG)
    assert store.artifact("right") == WRONG
    given_away(compiled / "right.bin")
    assert store.artifact("right") is None
    store.keep_artifact("right", RIGHT)
    assert store.artifact("right") == RIGHT


def test_what_the_folders_owner_has_made_is_believed(store, tmp_path):
    """Who sets a cache up for others fills it too."""
    given_away(tmp_path)
    given_away(tmp_path / "languages" / "compiled" / "right.bin")
    assert store.artifact("right") == RIGHT


def test_data_of_another_user_are_built_again(tmp_path):
    kept = KeptFile(lambda: tmp_path, "data", "numbers-", "key")
    assert kept.write([1, 2]) is None
    assert kept.read() == [1, 2]
    given_away(tmp_path / "data" / "numbers-key.json")
    assert kept.read() is None


def test_nothing_is_written_where_a_link_leads(store, compiled, tmp_path):
    mine = tmp_path / "mine.txt"
    mine.write_text("dear")
    (compiled / "right.bin").unlink()
    (compiled / "right.bin").symlink_to(mine)
    store.keep_artifact("right", RIGHT)
    assert mine.read_text() == "dear"
    assert store.artifact("right") == RIGHT


def test_a_file_that_anybody_may_write_passes_that_not_on(store, compiled):
    (compiled / "right.bin").chmod(0o666)
    store.keep_artifact("right", RIGHT)
    assert not stat.S_IMODE((compiled / "right.bin").stat().st_mode) & 0o002
