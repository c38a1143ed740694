"""What all tests share: a history of their own, and Ctrl-C for the processes that they start."""

from __future__ import annotations

import os
import shutil
import signal
import tempfile
from pathlib import Path

import pytest

_OWN = "JUDGE_DB"


def pytest_configure(config: pytest.Config) -> None:
    """What processes that tests start inherit is set for the whole session, before the first test."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # started by nohup or &: such a child is deaf too
        signal.signal(signal.SIGINT, lambda *_: None)  # a handler is not inherited; we stay as we were
    folder = tempfile.mkdtemp(prefix="judge-tests-")
    config.add_cleanup(lambda: shutil.rmtree(folder, ignore_errors=True))
    os.environ[_OWN] = str(Path(folder) / "history.sqlite3")


@pytest.fixture(autouse=True)
def own_history(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A history of the test's own, empty; its file is made when something is kept."""
    path = tmp_path_factory.getbasetemp() / "histories" / os.urandom(8).hex() / "history.sqlite3"
    monkeypatch.setenv(_OWN, str(path))
    return path
