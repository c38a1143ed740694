"""The attackers, root and a plain user, each with a copy of the package; the levels this machine gives."""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any
from zlib import crc32

import pytest
from attackers import HERE, LEVELS, USERS, Attacker
from driver import possible
from residents import Resident
from sampling import daily

from judge.sandbox.available import levels_here

PACKAGE = HERE.parent.parent / "judge"
PLAIN_USER = 61_000 + os.getpid() % 4_000  # a number that nobody else has, and no name


@cache
def _levels_here() -> frozenset[str]:
    return frozenset(level.name for level in levels_here() if level.available)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Have a test that does not say so itself run in each world: by day in one, which its name chooses."""
    said = {name for mark in metafunc.definition.iter_markers("parametrize") for name in _names(mark.args[0])}
    turn = crc32(metafunc.definition.originalname.encode())
    for name, worlds in (("user", USERS), ("level", LEVELS)):
        if name in metafunc.fixturenames and name not in said:
            metafunc.parametrize(name, daily(worlds, [worlds[turn % len(worlds)]]), indirect=True)


def _names(told: str | Sequence[str]) -> Sequence[str]:
    return told.split(",") if isinstance(told, str) else told


@pytest.fixture
def level(request: pytest.FixtureRequest) -> str:
    """A level, if whoever runs the tests may have it on this machine."""
    if request.param not in _levels_here():
        assert not possible(request.param), f"{request.param} is denied where this machine gives it"
        pytest.skip(f"{request.param} cannot be had here")
    return str(request.param)


@pytest.fixture
def user(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def attacker(user: str, _attackers: dict[str, Attacker], _users: contextlib.ExitStack) -> Attacker:
    """Who attacks: the user that the test names, made when the first test asks for it."""
    if user not in _attackers:
        _attackers[user] = _users.enter_context(_attacker(user))
    return _attackers[user]


@pytest.fixture
def resident(attacker: Attacker) -> Resident:
    """The attacker as somebody who has the judge installed."""
    if attacker.resident is None:
        attacker.resident = Resident(attacker)
    if attacker.resident.lacking:
        pytest.skip(f"{attacker.python} cannot import the judge's packages: {attacker.resident.lacking}")
    return attacker.resident


@pytest.fixture
def together(request: pytest.FixtureRequest, _selected: dict[Any, list[str]]) -> list[str]:
    """The attacks `name` of this test, of all that are selected, with its user and its level."""
    return _selected[_test_and_world(request.node)]


@pytest.fixture(scope="session")
def _selected(request: pytest.FixtureRequest) -> dict[Any, list[str]]:
    found: dict[Any, list[str]] = {}
    for item in request.session.items:
        if HERE in item.path.parents and "together" in item.fixturenames:
            found.setdefault(_test_and_world(item), []).append(item.callspec.params["name"])
    return found


def _test_and_world(item: Any) -> tuple[Any, ...]:
    return item.path, item.originalname, *(item.callspec.params.get(name) for name in ("user", "level"))


@pytest.fixture(scope="session")
def _attackers() -> dict[str, Attacker]:
    return {}


@pytest.fixture(scope="session")
def _users() -> Iterator[contextlib.ExitStack]:
    with contextlib.ExitStack() as made:
        yield made


@contextlib.contextmanager
def _attacker(user: str) -> Iterator[Attacker]:
    if not sys.platform.startswith("linux"):
        pytest.skip("the attacks are Linux's")
    with tempfile.TemporaryDirectory(prefix="judge-suite-") as folder:
        home = Path(folder)
        home.chmod(0o755)
        (home / "tmp").mkdir()
        (home / "tmp").chmod(0o777)
        ignore = shutil.ignore_patterns("__pycache__")
        shutil.copytree(PACKAGE / "sandbox", home / "judge" / "sandbox", ignore=ignore)
        shutil.copytree(HERE, home / "security", ignore=ignore)
        for own in ("__init__.py", "errors.py"):
            shutil.copy(PACKAGE / own, home / "judge" / own)
        if user == "plain" and os.geteuid() == 0:
            yield Attacker(user, _python_for(PLAIN_USER), home, PLAIN_USER)
        else:
            yield Attacker(user, sys.executable, home, None)


def _python_for(uid: int) -> str:
    """An interpreter that a plain user may start, new enough; the judge's own may lie in a private home."""
    for python in (sys.executable, "/usr/bin/python3", "/usr/local/bin/python3"):
        check = [python, "-c", "import sys; sys.exit(sys.version_info < (3, 11))"]
        with contextlib.suppress(OSError):
            if not subprocess.call(check, user=uid, group=uid, extra_groups=[], cwd="/", timeout=20):
                return python
    pytest.skip("a plain user can start no interpreter here that is new enough")
