"""A hidden folder is hidden by every name that leads to it; what lies beside it can be imported."""

from __future__ import annotations

import errno
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest
from sandboxed import require

from judge.errors import JudgeError
from judge.sandbox import open_box, places, visible
from judge.sandbox.available import levels_here
from judge.sandbox.boundary import Limits, Stop
from judge.sandbox.inside import unseen

pytestmark = pytest.mark.slow

LIMITS = Limits(2.0, 6.0, 256 << 20, 1 << 20)
AVAILABLE = {level.name for level in levels_here() if level.available}
LOOK = b"""
import json, os, sys
import neighbour
print(neighbour.VALUE)
for path in json.load(sys.stdin):
    for attempt in (open, os.listdir):
        try:
            found = attempt(path)
        except OSError:
            continue
        if found:
            print("BREACH", path, found)
"""


class Site(NamedTuple):
    """What is on sys.path, what is hidden, and where a submission looks for the file in it."""

    path: list[str]
    hide: list[Path]
    looks: list[Path]


def _site(folder: Path) -> Path:
    """A place of modules: one that may be imported, and a pack of problems with a secret."""
    (folder / "pack" / "deep").mkdir(parents=True)
    (folder / "pack" / "secret.txt").write_text("secret")
    (folder / "pack" / "deep" / "secret.txt").write_text("secret")
    (folder / "neighbour.py").write_text("VALUE = 42\n")
    return folder


def _seen(site: Path) -> list[Path]:
    return [site / "pack" / "secret.txt", site / "pack" / "deep" / "secret.txt"]


def as_it_is(top: Path) -> Site:
    site = _site(top / "site-packages")
    return Site([str(site)], [site / "pack"], _seen(site))


def through_a_link_beside_it(top: Path) -> Site:
    site = _site(top / "site-packages")
    for name, target in (("also", "pack"), ("deeper", site / "pack" / "deep"), ("loop", "."), ("up", top)):
        (site / name).symlink_to(target)
    looks = [site / "also/secret.txt", site / "deeper/secret.txt", *_seen(site / "loop")]
    return Site([str(site)], [site / "pack"], [*looks, *_seen(site / "up/site-packages/loop/loop")])


def itself_a_link_into_another_place(top: Path) -> Site:
    site, other = _site(top / "site-packages"), _site(top / "other" / "dist-packages")
    shutil.rmtree(site / "pack")
    (site / "pack").symlink_to(other / "pack")
    return Site([str(site), str(other)], [site / "pack"], [*_seen(site), *_seen(other)])


def another_pack_that_nobody_named(top: Path) -> Site:
    site = _site(top / "site-packages")
    for name, mark in (("problems", "problem.toml"), ("solutions", "accepted")):
        (site / name / "one").mkdir(parents=True)
        (site / name / "one" / mark).write_text("secret")
    judges = [site / "judge" / way / "one" / mark for way, mark in (("problems", "problem.toml"),)]
    judges[0].parent.mkdir(parents=True)
    judges[0].write_text("secret")
    looks = [site / "problems/one/problem.toml", site / "solutions/one/accepted", site / "solutions", *judges]
    return Site([str(site)], [], looks)


def what_says_where_the_judge_is(top: Path) -> Site:
    site = _site(top / "site-packages")
    told = site / "circle_line_judge-1.2.3.dist-info"
    told.mkdir()
    (told / "RECORD").write_text("judge/solutions/count/accepted/exact.py")
    return Site([str(site)], [], [told / "RECORD", told])


SITES: list[Callable[[Path], Site]] = [
    as_it_is,
    through_a_link_beside_it,
    itself_a_link_into_another_place,
    another_pack_that_nobody_named,
    what_says_where_the_judge_is,
]


def _looked(site: Site, level: str) -> list[str]:
    with open_box(LOOK, "look.py", level=level, hide=site.hide) as box:
        ended = box.run_program(json.dumps(list(map(str, site.looks))).encode(), LIMITS)
    assert ended.stop is Stop.ANSWERED, ended
    return ended.stdout.decode().splitlines()


@pytest.mark.parametrize("make", SITES)
@pytest.mark.parametrize("level", ["full", "strong"])
def test_no_name_leads_to_a_hidden_folder(monkeypatch, tmp_path, level, make):
    require(level)
    site = make(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path, *site.path])
    assert _looked(site, level) == ["42"]
    assert all(unseen.shows(str(path)) for path in site.looks), "it can be read outside by each name"


@pytest.mark.parametrize("level", ["full", "strong"])
@pytest.mark.parametrize(("machine", "also"), [("x86_64-linux-gnu", ["app/env"]), ("lib", [])])
def test_no_other_python_shows_among_libraries(monkeypatch, tmp_path, level, machine, also):
    require(level)
    site, folder = _site(tmp_path / "site-packages"), tmp_path / "libraries"
    (folder / machine).mkdir(parents=True)
    looks = [path for name in ("python3.1", *also) for path in _seen(_site(folder / name / "site-packages"))]
    monkeypatch.setattr(visible, "_LIBRARIES", (*visible._LIBRARIES, str(folder)))
    monkeypatch.setattr(sys, "path", [*sys.path, str(site)])
    assert str(folder / machine) in visible.visible().readable()
    assert _looked(Site([], [], looks), level) == ["42"]


def test_of_another_python_that_has_a_tool_the_rest_is_hidden(monkeypatch, tmp_path):
    tool, site = tmp_path / "python3.1" / "tool", tmp_path / "python3.1" / "site-packages"
    _site(site)
    tool.touch()
    monkeypatch.setattr(visible, "_LIBRARIES", (*visible._LIBRARIES, str(tmp_path)))
    assert str(site) in visible.visible(more=[str(tool)], modules=False).hidden
    (site / "judge" / "sandbox").mkdir(parents=True)
    (site / "judge" / "sandbox" / "boundary.py").touch()
    assert str(site / "judge") in visible.visible(more=[str(site / "pack")], modules=False).hidden


def test_a_package_that_is_only_called_so_may_be_imported(monkeypatch, tmp_path):
    site = tmp_path / "site-packages"
    for name in unseen.NAMES:
        (site / name).mkdir(parents=True)
        (site / name / "__init__.py").write_text("VALUE = 7\n")
        (site / name / "mechanics.py").write_text("")
    monkeypatch.setattr(sys, "path", [*sys.path, str(site)])
    with open_box(b"import problems, solutions\nprint(problems.VALUE + solutions.VALUE)", "f.py") as box:
        assert box.run_program(b"", LIMITS).stdout == b"14\n"


def test_a_checkout_that_holds_the_environment_in_use_is_hidden_by_its_parts(monkeypatch, tmp_path):
    checkout = tmp_path / "dist-packages" / "judge"
    (checkout / "problems" / "one").mkdir(parents=True)
    (checkout / "problems" / "one" / "problem.toml").touch()
    site = _site(checkout / ".venv" / "site-packages")
    (checkout / "problems" / "accepted").mkdir()  # by which a folder of solutions is known
    (checkout / "solutions").symlink_to(".")  # no way down: it must not be followed for ever
    monkeypatch.setattr(sys, "path", [*sys.path, str(tmp_path / "dist-packages"), str(site)])
    found = visible.visible()
    assert str(checkout) not in found.hidden
    assert str(checkout / "problems") in found.hidden
    assert _looked(Site([], [], [checkout / "problems" / "one" / "problem.toml"]), "strong") == ["42"]


def test_a_folder_above_what_is_shown_hides_nothing_of_it(monkeypatch, tmp_path):
    site = _site(tmp_path / "site-packages")
    (tmp_path / "answers.txt").write_text("secret")
    monkeypatch.setattr(sys, "path", [*sys.path, str(site)])
    for level in AVAILABLE - {"limits"}:
        assert _looked(Site([], [tmp_path, Path("/")], [tmp_path / "answers.txt"]), level) == ["42"]


@pytest.mark.parametrize("level", ["full", "strong"])
def test_another_mount_of_a_hidden_folder_is_hidden(tmp_path, level):
    """In a mount namespace of its own, which ends with it."""
    require("full")  # whose bubblewrap mounts it
    require(level)
    site = _site(tmp_path / "site-packages")
    other = tmp_path / "other" / "dist-packages"
    for name in ("whole", "part"):
        (other / name).mkdir(parents=True)
    looks = [
        other / "whole" / "secret.txt",
        other / "whole" / "deep" / "secret.txt",
        other / "part/secret.txt",
    ]
    script = f"""
import json, sys
sys.path[:0] = {[str(Path(visible.__file__).parents[2]), str(site), str(other)]!r}
from pathlib import Path
from judge.sandbox import open_box
from judge.sandbox.boundary import Limits
looks = {list(map(str, looks))!r}
assert all(open(path).read() == "secret" for path in looks)
try:
    with open_box({LOOK!r}, "look.py", level={level!r}, hide=[Path({str(site / "pack")!r})]) as box:
        print(box.run_program(json.dumps(looks).encode(), Limits{tuple(LIMITS)!r}).stdout.decode())
except Exception as error:
    print(error)
"""
    command = ["bwrap", "--dev-bind", "/", "/", "--cap-add", "ALL"]
    command += ["--bind", str(site / "pack"), str(other / "whole")]
    command += ["--bind", str(site / "pack" / "deep"), str(other / "part")]
    ended = subprocess.run(
        [*command, sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False
    )
    if "cannot be had here: bwrap" in ended.stdout:
        pytest.skip("no bubblewrap within another here")
    assert ended.stdout.split() == ["42"], ended.stdout + ended.stderr


@pytest.mark.parametrize("level", ["full", "strong"])
def test_a_judge_in_an_archive_that_shows_runs_nothing(monkeypatch, tmp_path, level):
    """A file cannot be covered."""
    require(level)
    archive = _site(tmp_path / "site-packages") / "judge.pyz"
    archive.write_bytes(b"PK")
    monkeypatch.setattr(sys, "path", [*sys.path, str(archive.parent)])
    monkeypatch.setattr(visible, "__file__", f"{archive}/judge/sandbox/visible.py")
    refused = pytest.raises(JudgeError, match=f"would let a submission read {archive}")
    with refused, open_box(b"", "f.py", level=level):
        pass


def test_what_was_compiled_of_it_is_hidden(monkeypatch, tmp_path):
    site = _site(tmp_path / "site-packages")
    compiled = Path(f"{site}/compiled{site}/pack")
    compiled.mkdir(parents=True)
    monkeypatch.setattr(sys, "path", [*sys.path, str(site)])
    monkeypatch.setattr(sys, "pycache_prefix", str(site / "compiled"))
    hidden = visible.visible([site / "pack"]).hidden
    assert all(places.within(str(path), hidden) for path in (site / "pack", compiled))


def test_mounts_are_read_with_spaces_in_their_names(monkeypatch, tmp_path):
    table = tmp_path / "mountinfo"
    table.write_text(
        "22 1 8:1 / / rw - ext4 /dev/a rw\n23 22 8:1 /a\\040b /c\\134d rw shared:1 - ext4 /dev/a rw\n"
    )
    monkeypatch.setattr(places, "_MOUNTS", table)
    assert places.mounts() == [places.Mount("8:1", "/", "/"), places.Mount("8:1", "/a b", "/c\\d")]
    monkeypatch.setattr(places, "_MOUNTS", tmp_path / "none")
    assert places.mounts() == []


def test_a_mount_below_a_hidden_folder_is_not_taken_for_another_of_it():
    """The environment in use may lie there."""
    table = [places.Mount("8:1", "/", "/"), places.Mount("8:1", "/env", "/data/site-packages")]
    assert set(places.elsewhere("/data", table)) == {"/env"}
    assert set(places.elsewhere("/env/pack", table)) == {"/data/site-packages/pack"}


@pytest.mark.parametrize("place", ["os.listdir", "os.scandir", "judge.sandbox.places._MOUNTS"])
def test_what_cannot_be_read_for_a_moment_is_not_taken_for_nothing(monkeypatch, place):
    """A folder that is overlooked for want of a descriptor would not be hidden."""

    class Short:
        def __call__(self, *_arguments: object) -> None:
            raise OSError(errno.EMFILE, os.strerror(errno.EMFILE))

        read_text = property(__call__)

    monkeypatch.setattr(place, Short())
    with pytest.raises(OSError, match="Too many open files"):
        visible.visible()
