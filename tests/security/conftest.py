"""The attackers, root and a plain user, each with a copy of the package; the levels this machine gives."""

from __future__ import annotations

import os
import pwd
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from attackers import HERE, Attacker
from residents import Resident

from judge.sandbox import levels

PACKAGE = HERE.parent.parent / "judge"
PLAIN_USER = "judge-attacker" + os.environ.get("PYTEST_XDIST_WORKER", "")  # whoever made it removes it
PATIENCE = 30.0  # seconds: another may hold /etc/passwd, and a dead process waits to be reaped


@cache
def _levels_here() -> frozenset[str]:
    return frozenset(level.name for level in levels() if level.available)


@pytest.fixture(params=["full", "strong", "limits"])
def level(request: pytest.FixtureRequest) -> str:
    """Each level that this machine gives to whoever runs the tests."""
    if request.param not in _levels_here():
        pytest.skip(f"{request.param} cannot be had here")
    return str(request.param)


@pytest.fixture(scope="session", params=["root", "plain"])
def attacker(request: pytest.FixtureRequest) -> Iterator[Attacker]:
    if not sys.platform.startswith("linux"):
        pytest.skip("the attacks are Linux's")
    with tempfile.TemporaryDirectory(prefix="judge-suite-") as folder:
        home = Path(folder)
        home.chmod(0o755)
        shutil.copytree(
            PACKAGE / "sandbox", home / "judge" / "sandbox", ignore=shutil.ignore_patterns("__pycache__")
        )
        shutil.copytree(HERE, home / "security", ignore=shutil.ignore_patterns("__pycache__"))
        for own in ("__init__.py", "errors.py"):
            shutil.copy(PACKAGE / own, home / "judge" / own)
        if request.param == "root":
            if os.geteuid() != 0:
                pytest.skip("not started as root")
            yield Attacker("root", sys.executable, home, None)
        elif os.geteuid() != 0:
            yield Attacker("plain", sys.executable, home, None)
        else:
            yield from _plain(home)


@pytest.fixture(scope="session")
def resident(attacker: Attacker) -> Resident:
    """The attacker as somebody who has the judge installed."""
    return Resident(attacker)


def _plain(home: Path) -> Iterator[Attacker]:
    made = False
    try:
        uid = pwd.getpwnam(PLAIN_USER).pw_uid
    except KeyError:
        if _administrators("useradd") is None:
            pytest.skip("there is no useradd to make a plain user with")
        _administer("useradd", "--no-create-home", "--shell", "/bin/false", PLAIN_USER)
        made, uid = True, pwd.getpwnam(PLAIN_USER).pw_uid
    try:
        yield Attacker("plain", _python_for(uid), home, uid)
    finally:
        if made:
            _administer("userdel", PLAIN_USER)


def _administer(name: str, *words: str) -> None:
    """Run an administrator's command, again where it is refused for what may pass."""
    until = time.monotonic() + PATIENCE
    while True:
        done = subprocess.run([_administrators(name) or name, *words], timeout=20, capture_output=True)
        if done.returncode == 0 or time.monotonic() > until:
            break
        time.sleep(0.5)
    assert done.returncode == 0, done.stderr.decode(errors="replace")


def _administrators(name: str) -> str | None:
    """A command that may lie where only an administrator's PATH looks."""
    return shutil.which(name, path=os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin", "/sbin"]))


def _python_for(uid: int) -> str:
    """An interpreter that a plain user may start, new enough; the judge's own may lie in a private home."""
    for python in (sys.executable, "/usr/bin/python3", "/usr/local/bin/python3"):
        check = [python, "-c", "import sys; sys.exit(sys.version_info < (3, 11))"]
        try:
            if (
                subprocess.run(check, user=uid, group=uid, extra_groups=[], cwd="/", timeout=20).returncode
                == 0
            ):
                return python
        except OSError:
            continue
    pytest.skip("a plain user can start no interpreter here that is new enough")
