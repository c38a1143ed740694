"""What all tests share: no test reads or writes the person's own history; the wheel is built once."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

_OWN = "JUDGE_DB"


def pytest_configure(config: pytest.Config) -> None:
    """Processes that tests start inherit it, so it is set for the whole session, before the first test."""
    folder = tempfile.mkdtemp(prefix="judge-tests-")
    config.add_cleanup(lambda: shutil.rmtree(folder, ignore_errors=True))
    os.environ[_OWN] = str(Path(folder) / "history.sqlite3")


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
