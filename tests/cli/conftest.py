from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable

import pytest
from broken_problems import FAULTS, broken
from cli_support import BROKEN, PACK, ROOT, Outcome

from judge.cli import main
from judge.judging.containment import keep_level
from judge.sandbox.available import levels_here


@pytest.fixture(scope="session")
def pack(tmp_path_factory):
    """A pack of problems with one problem, `middle`, whose data are pinned."""
    folder = tmp_path_factory.mktemp("pack")
    shutil.copytree(PACK, folder, dirs_exist_ok=True)
    return folder


@pytest.fixture(scope="session")
def broken_pack(tmp_path_factory):
    """A folder of problems, every one of them broken."""
    folder = tmp_path_factory.mktemp("broken")
    for name in FAULTS:
        broken(name, folder)
    return folder


@pytest.fixture(scope="session")
def cache(shared):
    """A cache like that of somebody who has run `judge doctor`: no command has a note on isolation then."""
    folder = shared / "cache"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("JUDGE_CACHE", str(folder))
        keep_level(next(level.name for level in levels_here() if level.available))
    return folder


@pytest.fixture(autouse=True)
def _own_settings(pack, cache, tmp_path, monkeypatch):
    """The person's own cache and settings stay out of it; what is written lands in a temporary folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(ROOT))  # of the processes that are started there
    monkeypatch.setenv("JUDGE_CACHE", str(cache))
    monkeypatch.setenv("JUDGE_PROBLEMS", str(pack / "problems"))
    for name in ("NO_COLOR", "COLUMNS", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)


@pytest.fixture
def judge(capsys, monkeypatch, broken_pack) -> Callable[..., Outcome]:
    """Run the command line in this process; the word BROKEN is the folder of broken problems."""

    def run(*words: object) -> Outcome:
        told = [str(broken_pack if word == BROKEN else word) for word in words]
        monkeypatch.setattr(sys, "argv", ["judge", *told])
        with pytest.raises(SystemExit) as left:
            main()
        written = capsys.readouterr()
        return Outcome(int(left.value.code), written.out, written.err)

    return run


@pytest.fixture
def process() -> Callable[..., Outcome]:
    """Run the command line as a process of its own, piped."""

    def run(*words: object, **settings: str) -> Outcome:
        ended = subprocess.run(
            [sys.executable, "-m", "judge", *map(str, words)],
            capture_output=True,
            encoding="utf-8",
            timeout=120,
            env={**os.environ, **settings},
        )
        return Outcome(ended.returncode, ended.stdout, ended.stderr)

    return run


@pytest.fixture
def submit(tmp_path) -> Callable[..., str]:
    """Write a submission into the current folder, which is the test's own."""

    def write(source: str | bytes, name: str = "mine.py") -> str:
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(source if isinstance(source, bytes) else source.encode())
        return name

    return write
