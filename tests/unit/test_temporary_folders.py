"""The folders that programs are compiled and run in: gone afterwards, also those of a killed judge."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from judge.sandbox.temporary import TemporaryFolder, sweep

ROOT = Path(__file__).parents[2]


@pytest.fixture(autouse=True)
def own(monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))


def aged(path):
    os.utime(path, (0, 0))


def test_nobody_else_lists_it_and_in_use_it_stays_however_old_and_then_is_gone_with_all_in_it(tmp_path):
    with TemporaryFolder() as folder:
        assert folder.stat().st_mode & 0o777 == 0o711
        (folder / "inner").mkdir()
        (folder / "inner" / "file").write_text("")
        aged(folder)
        sweep(folder.parent)
        assert folder.is_dir()
    assert list(tmp_path.iterdir()) == []


def test_a_killed_judge_s_folder_goes_with_the_next(tmp_path):
    code = (
        f"import sys, tempfile; sys.path.insert(0, {str(ROOT)!r}); tempfile.tempdir = {str(tmp_path)!r}\n"
        "from judge.sandbox.temporary import TemporaryFolder\n"
        "print(TemporaryFolder().path, flush=True); sys.stdin.read()"
    )
    killed = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    left = killed.stdout.readline().strip()
    killed.send_signal(signal.SIGKILL)
    killed.communicate(timeout=60)
    assert Path(left).is_dir()
    with TemporaryFolder():
        assert Path(left).is_dir()  # young: it might be about to be locked
    aged(left)
    with TemporaryFolder():
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
