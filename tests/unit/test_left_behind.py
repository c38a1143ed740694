"""What a killed judge or another user leaves: folders, processes, files of a shared cache."""

from __future__ import annotations

import os
import shutil
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from judge.cache import CacheFolder
from judge.languages.store import CacheStore
from judge.sandbox.parcels import sweep, temporary_folder

ROOT = Path(__file__).parents[2]


@pytest.fixture(autouse=True)
def own(monkeypatch, tmp_path):
    monkeypatch.setenv("TMPDIR", str(tmp_path))


def aged(path):
    os.utime(path, (0, 0))


def test_nobody_else_lists_it_and_in_use_it_stays_however_old_and_then_is_gone_with_all_in_it(tmp_path):
    with temporary_folder() as folder:
        assert folder.stat().st_mode & 0o777 == 0o711
        (folder / "inner").mkdir()
        (folder / "inner" / "file").write_text("")
        aged(folder)
        sweep(folder.parent)
        assert folder.is_dir()
    assert list(tmp_path.iterdir()) == []


def test_a_killed_judge_s_folder_goes_with_the_next(tmp_path):
    code = (
        f"import os, sys; sys.path.insert(0, {str(ROOT)!r}); os.environ['TMPDIR'] = {str(tmp_path)!r}\n"
        "from judge.sandbox.parcels import temporary_folder\n"
        "with temporary_folder() as folder: print(folder, flush=True); sys.stdin.read()"
    )
    killed = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    left = killed.stdout.readline().strip()
    killed.send_signal(signal.SIGKILL)
    killed.communicate(timeout=60)
    assert Path(left).is_dir()
    with temporary_folder():
        assert Path(left).is_dir()  # young: it might be about to be locked
    aged(left)
    with temporary_folder():
        assert not Path(left).exists()


def test_links_and_what_is_called_otherwise_stay(tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    (tmp_path / "judge-box-link").symlink_to(other)
    (tmp_path / "judge-suite").mkdir()
    for path in (other, tmp_path / "judge-suite"):
        aged(path)
    sweep(tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["judge-box-link", "judge-suite", "other"]


def test_however_deep_and_closed_its_folders_are_they_go_and_what_a_link_leads_to_stays(tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    with temporary_folder() as folder:
        here = os.open(folder, os.O_RDONLY)
        for _ in range(3000):
            for name in ("a", "b" * 200):
                os.mkdir(name, dir_fd=here)
            os.symlink(other, "link", dir_fd=here)
            here, above = os.open("b" * 200, os.O_RDONLY, dir_fd=here), here
            os.chmod("a", 0, dir_fd=above)
            os.close(above)
        os.close(here)
        (folder / "b").mkdir(mode=0o300)
    assert list(tmp_path.iterdir()) == [other]


SCRIPT = """
import os, sys, time
from judge.sandbox.inside.confine import Confinement

config = {"threads": 0, "uid": None, "parent": None, "level": "limits"}
confinement = Confinement(config)
server = os.getpid()
if os.fork() == 0:
    while os.getppid() == server:  # until it has died, as one that is killed right after the fork
        time.sleep(0.001)
    CONFINED
    print("it lives on", flush=True)
os._exit(0)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere the hang-up has to do")
@pytest.mark.parametrize("how", ['confine_child({"RLIMIT_AS": 1 << 30})', "confine_child({}, starts=True)"])
def test_it_ends_before_anything_foreign_runs(how):
    script = SCRIPT.replace("CONFINED", f"confinement.{how}")
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False
    )
    assert (done.stdout, done.stderr) == ("", "")
    alive = subprocess.run(
        [sys.executable, "-c", SCRIPT.replace("CONFINED", "pass")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert alive.stdout == "it lives on\n"  # without the check


STRANGER = 65534
RIGHT, WRONG = [("main", b"right")], [("main", b"wrong")]


@pytest.fixture
def store(tmp_path):
    found = CacheStore(CacheFolder(lambda: tmp_path))
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
    (compiled / "right").unlink()
    put(compiled / "wrong", compiled / "right")
    assert store.artifact("right") is None
    assert store.artifact("wrong") == WRONG


def test_what_another_user_has_forged_is_none(store, compiled):
    """Anybody can make a right digest: there is nothing secret in it."""
    store.keep_artifact("right", WRONG)
    assert store.artifact("right") == WRONG
    given_away(compiled / "right")
    assert store.artifact("right") is None
    store.keep_artifact("right", RIGHT)
    assert store.artifact("right") == RIGHT


def test_what_the_folders_owner_has_made_is_believed(store, tmp_path):
    """Who sets a cache up for others fills it too."""
    given_away(tmp_path)
    given_away(tmp_path / "languages" / "compiled" / "right")
    assert store.artifact("right") == RIGHT


def test_data_of_another_user_are_built_again(tmp_path):
    kept = CacheFolder(lambda: tmp_path)
    assert kept.write("data/numbers", "key", [1, 2]) is None
    assert kept.read("data/numbers", "key", list) == [1, 2]
    given_away(tmp_path / "data" / "numbers")
    assert kept.read("data/numbers", "key", list) is None


def test_nothing_is_written_where_a_link_leads(store, compiled, tmp_path):
    mine = tmp_path / "mine.txt"
    mine.write_text("dear")
    (compiled / "right").unlink()
    (compiled / "right").symlink_to(mine)
    store.keep_artifact("right", RIGHT)
    assert mine.read_text() == "dear"
    assert store.artifact("right") == RIGHT


def test_a_file_that_anybody_may_write_passes_that_not_on(store, compiled):
    (compiled / "right").chmod(0o666)
    store.keep_artifact("right", RIGHT)
    assert not stat.S_IMODE((compiled / "right").stat().st_mode) & 0o002
