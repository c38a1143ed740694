"""Choosing a level, refusing one that cannot be had, and what is left out of the container's view."""

from __future__ import annotations

import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from judge.errors import UsageError
from judge.sandbox import launch, levels, open_box, roots
from judge.sandbox import probe as probing
from judge.sandbox.boundary import Limits

pytestmark = pytest.mark.slow

PACKAGE = Path(roots.__file__).parent.parent
LIMITS = Limits(2.0, 6.0, 256 << 20, 1 << 20)


def test_probe_names_every_level_best_first() -> None:
    found = levels()
    assert [level.name for level in found] == ["full", "strong", "limits"]
    assert found[-1].available
    assert all(level.available or level.why_not for level in found)


def test_the_best_level_is_taken() -> None:
    best = next(level.name for level in levels() if level.available)
    with open_box(b"", "f.py") as box:
        assert box.isolation == best


def test_an_unknown_level_is_a_usage_error() -> None:
    with pytest.raises(UsageError, match="did you mean strong"):
        open_box(b"", "f.py", level="storng")


def test_a_demanded_level_is_not_lowered(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(launch, "bubblewrap_path", lambda: None)
    probing.missing.cache_clear()
    try:
        with pytest.raises(UsageError, match="bubblewrap is not installed") as caught:
            open_box(b"", "f.py", level="full")
        assert "bubblewrap" in (caught.value.remedy or "")
        with open_box(b"", "f.py") as box:
            assert box.isolation in ("strong", "limits")
    finally:
        probing.missing.cache_clear()


def test_a_bubblewrap_that_fails_says_why(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    if not levels()[0].available:
        pytest.skip("full cannot be had here")
    broken = tmp_path / "bwrap"
    broken.write_text("#!/bin/sh\necho 'bwrap: No permissions to create a new namespace' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setattr(launch, "bubblewrap_path", lambda: str(broken))
    refused = pytest.raises(UsageError, match="No permissions to create a new namespace")
    with refused, open_box(b"", "f.py", level="full"):
        pass
    with open_box(b"", "f.py") as box:
        assert box.isolation != "full"


def test_a_level_that_fails_in_the_background_leaves_the_next_one_whole(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    broken = tmp_path / "bwrap"
    broken.write_text("#!/bin/sh\nsleep 0.2\necho 'bwrap: no' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setattr(launch, "bubblewrap_path", lambda: str(broken))
    box = open_box(b"def f(n): return n", "f.py")
    box.warm_up()
    with box:
        assert box.isolation != "full"
        for _ in range(2):
            assert box.call_many("f", [(1,)], LIMITS).replies[0].answer == 1


@pytest.mark.parametrize("seconds", [0, 0.01, 0.03, 0.06])
def test_a_box_may_be_closed_while_it_warms_up(seconds: float) -> None:
    for _ in range(5):
        box = open_box(b"def f(n): return n", "f.py")
        box.warm_up()
        time.sleep(seconds)
        box.__exit__(None, None, None)
    assert not [thread for thread in threading.enumerate() if "prepare" in thread.name]


def test_paths_are_given_around_what_is_hidden(tmp_path: Path) -> None:
    for name in ("site/judge/problems", "site/numpy", "site/other"):
        (tmp_path / name).mkdir(parents=True)
    around = roots._around(tmp_path / "site", [tmp_path / "site" / "judge"])
    assert around == [str(tmp_path / "site" / "numpy"), str(tmp_path / "site" / "other")]
    deeper = roots._around(tmp_path / "site", [tmp_path / "site" / "judge" / "problems"])
    assert str(tmp_path / "site" / "judge" / "problems") not in deeper
    assert str(tmp_path / "site" / "numpy") in deeper


@pytest.mark.parametrize("level", ["full", "strong"])
def test_an_installed_judge_is_invisible_but_its_neighbours_are_not(tmp_path: Path, level: str) -> None:
    """The judge in a site-packages folder, as a wheel puts it, next to a module that may be imported."""
    if not next(found for found in levels() if found.name == level).available:
        pytest.skip(f"{level} cannot be had here")
    site = tmp_path / "lib" / "site-packages"
    shutil.copytree(PACKAGE / "sandbox", site / "judge" / "sandbox")
    for own in ("__init__.py", "errors.py"):
        shutil.copy(PACKAGE / own, site / "judge" / own)
    (site / "judge" / "problems").mkdir()
    (site / "judge" / "problems" / "answers.txt").write_text("secret")
    (site / "neighbour.py").write_text("VALUE = 42\n")
    source = f"""
import neighbour
print(neighbour.VALUE)
for attempt in ("import judge; judge.__file__", "import judge.errors",
                "open({str(site / "judge" / "problems" / "answers.txt")!r})",
                "__import__('os').listdir({str(site / "judge" / "problems")!r})"):
    try:
        exec(attempt)
        print("BREACH", attempt)
    except (ImportError, OSError, AttributeError) as error:
        print("held")
"""
    script = f"""
import sys
sys.path.insert(0, {str(site)!r})
from judge.sandbox import open_box, roots
from judge.sandbox.boundary import Limits
assert roots.__file__.startswith({str(site)!r}), roots.__file__
with open_box({source.encode()!r}, "f.py", level={level!r}) as box:
    result = box.run_program(b"", Limits(2.0, 6.0, 256 << 20, 1 << 20))
    print(result.stdout.decode(), result.detail)
"""
    done = subprocess.run(
        [sys.executable, "-I", "-c", script],
        capture_output=True,
        text=True,
        timeout=60,
        cwd=tmp_path,
        check=False,
    )
    assert done.stdout.split() == ["42", "held", "held", "held", "held"], done.stdout + done.stderr


def test_what_lies_in_a_hidden_folder_is_hidden_with_it() -> None:
    outer = Path(pytest.__file__).resolve().parent
    inner = next(path for path in outer.parent.joinpath("_pytest").iterdir() if path.is_dir())
    hide = [inner, inner.parent, outer, outer]
    found = roots.find_roots(hide)
    assert str(inner) not in found.hidden
    assert [found.hidden.count(str(path)) for path in (inner.parent, outer)] == [1, 1]
    with open_box(b"def f(n): return n", "f.py", hide=hide) as box:
        assert box.isolation == next(level.name for level in levels() if level.available)
        assert box.call_many("f", [(1,)], LIMITS).replies[0].answer == 1


def test_a_hidden_folder_is_hidden(tmp_path: Path) -> None:
    found = roots.find_roots([tmp_path])
    assert str(tmp_path) not in found.hidden, "it lies outside what is shown anyway"
    inside = next(Path(folder) for folder in found.folders if any(Path(folder).iterdir()))
    child = next(path for path in sorted(inside.resolve().iterdir()) if path.is_dir())
    assert str(child) in roots.find_roots([child]).hidden
    assert str(child) not in roots.find_roots([child]).readable()
