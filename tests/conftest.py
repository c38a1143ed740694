"""What all tests share: the person's own history is left alone, nothing piles up, what is dear is built once.

Ctrl-C reaches the processes that tests start, however the tests themselves were started.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
import skips

_OWN = "JUDGE_DB"
_LEFT = re.compile(r"judge-(tests|suite|attacked|home)-\w{8}")  # folders that tests make and take away
_TESTS = Path(__file__).parent
_SLOW = ("security", "packaging", "mutation", "fuzz")
_A_DAY = 24 * 3600  # longer than any run of the tests


def pytest_configure(config: pytest.Config) -> None:
    """Let the processes that tests start hear Ctrl-C where we do not, in the background or under nohup."""
    if "SKIPPED" in os.environ:
        config.pluginmanager.register(skips)
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, lambda *_: None)  # a handler is not inherited; we stay as we were


def pytest_sessionstart() -> None:
    """Take away the folders of runs that were killed before they could; those of this user, and old ones."""
    with contextlib.suppress(OSError), os.scandir(tempfile.gettempdir()) as entries:
        for entry in entries:
            if _LEFT.fullmatch(entry.name) and entry.is_dir(follow_symlinks=False):
                found = entry.stat(follow_symlinks=False)
                if found.st_uid == os.geteuid() and time.time() - found.st_mtime > _A_DAY:
                    shutil.rmtree(entry.path, ignore_errors=True)  # which follows no link


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark as slow what whole folders are for: attacks, distributions, changed solutions, invented input;
    and what only the nightly run does."""
    for item in items:
        if item.get_closest_marker("nightly"):
            item.add_marker(pytest.mark.slow)
        if item.path.is_relative_to(_TESTS) and item.path.relative_to(_TESTS).parts[0] in _SLOW:
            item.add_marker(pytest.mark.slow)


@pytest.fixture(scope="session")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of this run of the tests, the same one for all its workers."""
    folder = tmp_path_factory.getbasetemp()
    return folder.parent if "PYTEST_XDIST_WORKER" in os.environ else folder


@pytest.fixture(scope="session")
def built(shared: Path) -> Path:
    """A cache for who wants our problems' data and known mistakes: made once, whichever worker is first.

    It is that of the environment where one is named there; a person's own stays out of it.
    """
    return Path(os.environ.get("JUDGE_CACHE") or shared / "built")


@pytest.fixture(scope="session", autouse=True)
def _session_history(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Processes that tests start inherit it, so it is set before the first test. pytest clears it away."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(_OWN, str(tmp_path_factory.mktemp("history") / "history.sqlite3"))
        yield


@pytest.fixture(scope="session", autouse=True)
def _own_locks(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Tests wait for no other judge on this machine, and no other judge for them."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("JUDGE_LOCKS", str(tmp_path_factory.mktemp("locks")))
        yield


@pytest.fixture(scope="session", autouse=True)
def _compiled_once(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Hundreds of processes import the judge; compiled it is, if not beside its files then elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        if os.environ.get("PYTHONDONTWRITEBYTECODE"):
            patch.delenv("PYTHONDONTWRITEBYTECODE")
            patch.setenv("PYTHONPYCACHEPREFIX", str(tmp_path_factory.mktemp("compiled")))
        yield


@pytest.fixture(autouse=True)
def own_history(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A history of the test's own, empty; its file is made when something is kept."""
    path = tmp_path_factory.getbasetemp() / "histories" / os.urandom(8).hex() / "history.sqlite3"
    monkeypatch.setenv(_OWN, str(path))
    return path


@pytest.fixture(scope="session")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of this checkout."""
    pytest.importorskip("hatchling")
    target = tmp_path_factory.mktemp("dist")
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(target)]
    subprocess.run(command, cwd=Path(__file__).parents[1], check=True, capture_output=True, timeout=120)
    (built,) = target.glob("*.whl")
    return built
