"""Packages that mean harm: links, names, sizes and YAML that lead out, or fill what they can."""

from __future__ import annotations

import errno
import os
import stat
import warnings
import zipfile
from pathlib import Path

import pytest
from foreign_packages import LEGACY, written, zipped

from judge.errors import ProblemError, UsageError
from judge.packs.foreign import opening, settings
from judge.packs.foreign.cases import test_files as files_of
from judge.packs.foreign.checker import content_of
from judge.packs.foreign.look import is_package
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.package import read_package
from judge.packs.foreign.settings import read_settings

FOUNDED = {f"sum/{name}": text for name, text in LEGACY.items()}


def test_a_sound_archive_is_a_package(tmp_path):
    for name, members, called in (("one.zip", LEGACY, "one"), ("two.kpp", FOUNDED, "sum")):
        path = zipped(tmp_path / name, members)
        assert is_package(str(path))
        with Opened(str(path)) as opened:
            assert opened.name == called
            assert [test.name for test in files_of(read_package(opened))] == ["sample/1", "secret/1"]
            place = opened.root
        assert not place.exists()


def member(name, content="x", kind=None, **packing):
    """What makes an archive worse by one member."""

    def add(path):
        found = zipfile.ZipInfo(name)
        found.external_attr = 0 if kind is None else (kind | 0o777) << 16
        with zipfile.ZipFile(path, "a") as archive, warnings.catch_warnings(action="ignore"):
            archive.writestr(found, content, **packing)

    return add


def unnamed(path):
    member("sum/\u00fc.in")(path)
    path.write_bytes(path.read_bytes().replace("\u00fc".encode(), b"\xff\xfe"))


def cut_up(path):
    content = path.read_bytes()
    path.write_bytes(content[:40] + bytes(20) + content[60:])


NO_NAME = "no name of a file"
WORSE = {
    "up": (member("../out.txt"), NO_NAME),
    "down and up": (member("sum/../../out.txt"), NO_NAME),
    "absolute": (member("/tmp/out.txt"), NO_NAME),
    "backwards": (member("..\\out.txt"), NO_NAME),
    "backwards within": (member("sum/data\\..\\x"), NO_NAME),
    "long": (member("x" * 300), NO_NAME),
    "deep": (member("a/" * 40 + "b"), NO_NAME),
    "a link": (member("sum/data/2.in", "/etc/passwd", stat.S_IFLNK), "is a link or no ordinary file"),
    "a pipe": (member("sum/data/2.in", "", stat.S_IFIFO), "is a link or no ordinary file"),
    "a device": (member("sum/data/2.in", "", stat.S_IFCHR), "is a link or no ordinary file"),
    "twice": (member("sum/problem.yaml", "name: another"), "twice"),
    "packed otherwise": (
        member("sum/data/secret/2.in", "1 2", compress_type=zipfile.ZIP_BZIP2),
        "packed in an unusual way; pack it anew",
    ),
    "no text": (unnamed, "no zip file that can be read"),
    "cut": (cut_up, None),
    "empty": (lambda path: path.write_bytes(b""), None),
    "no zip": (lambda path: path.write_bytes(b"no zip"), None),
    "an end": (lambda path: path.write_bytes(b"PK\x05\x06" + bytes(17)), None),
    "a wild end": (lambda path: path.write_bytes(b"PK\x05\x06" + b"\xff" * 18), None),
    "another end": (lambda path: path.write_bytes(b"PK\x06\x07" * 9), None),
    "no package": (lambda path: zipped(path, {"readme.txt": "x"}), r"no problem\.yaml"),
}


@pytest.mark.parametrize("how", WORSE)
def test_a_bad_archive_is_refused_and_nothing_leads_out(tmp_path, how):
    worsen, told = WORSE[how]
    path = zipped(tmp_path / "bad.zip", FOUNDED)
    worsen(path)
    with pytest.raises(ProblemError, match=told):
        Opened(str(path))
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("lacking", ["list", "enter"])
def test_a_folder_that_may_not_be_read(tmp_path, lacking, monkeypatch):
    """As it is for a plain user: the superuser, who may test here too, may read everything."""
    root = written(tmp_path / "sum", LEGACY)
    own = Path.iterdir

    def listed(folder):
        if folder.name == "secret":
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        return own(folder)

    if lacking == "list":
        monkeypatch.setattr(Path, "iterdir", listed)
    else:
        monkeypatch.setattr(os, "access", lambda path, mode: path.name != "secret")
    with pytest.raises(ProblemError, match=r"secret: this folder cannot be read \(permission denied\)"):
        files_of(read_package(Opened(str(root))))


def test_a_bomb_is_not_unpacked(tmp_path, monkeypatch):
    monkeypatch.setattr(opening, "_LARGEST", 1 << 20)
    monkeypatch.setattr(opening, "_MOST_BYTES", 3 << 20)
    monkeypatch.setattr(opening, "MOST_FILES", 50)
    for members, told in (
        ({"sum/big": bytes(9 << 20)}, "unpacked it is larger"),
        ({f"sum/{n}": bytes(1 << 20) for n in range(5)}, "unpacked it is larger"),
        ({f"sum/{n}": "" for n in range(60)}, "more than 50 files"),
    ):
        path = zipped(tmp_path / "bomb.zip", {**FOUNDED, **members})
        assert path.stat().st_size < 1 << 16
        with pytest.raises(ProblemError, match=told):
            Opened(str(path))


@pytest.mark.parametrize(
    "place", ["data/secret/1.in", "data/secret/1.ans", "data/secret/more", "data/sample"]
)
def test_links_out_of_a_folder_are_not_followed(tmp_path, place):
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / "2.in").write_text("secret of the machine")
    (outside / "2.ans").write_text("")
    root = written(tmp_path / "sum", LEGACY)
    link = root / place
    if link.is_file():
        link.unlink()
    elif link.exists():
        link.rename(tmp_path / "away")
    link.symlink_to(outside / "2.in" if "." in link.name else outside)
    with pytest.raises(ProblemError, match="leads out of the package"):
        files_of(read_package(Opened(str(root))))


def test_a_link_within_the_package_is_what_it_leads_to(tmp_path):
    root = written(tmp_path / "sum", LEGACY)
    for end in ("in", "ans"):
        (root / f"data/secret/2.{end}").symlink_to(f"../sample/1.{end}")
    opened = Opened(str(root))
    found = files_of(read_package(opened))
    assert [opened.read(test.given) for test in found][2] == b"1 2\n"


def test_a_folder_that_leads_back_to_itself_ends(tmp_path):
    root = written(tmp_path / "sum", LEGACY)
    (root / "data/secret/again").symlink_to("..")
    with pytest.raises(ProblemError, match=r"deep|more than"):
        files_of(read_package(Opened(str(root))))


def test_a_file_that_is_none_is_not_waited_for(tmp_path):
    root = written(tmp_path / "sum", LEGACY)
    os.mkfifo(root / "data/secret/2.in")
    (root / "data/secret/2.ans").write_text("")
    opened = Opened(str(root))
    last = files_of(read_package(opened))[-1]
    with pytest.raises(ProblemError, match="no ordinary file"):
        opened.read(last.given)


def test_a_huge_file_is_not_read_whole(tmp_path):
    root = written(tmp_path / "sum", LEGACY)
    with (root / "data/secret/1.in").open("wb") as file:
        file.truncate(1 << 40)
    opened = Opened(str(root))
    with pytest.raises(ProblemError, match="larger than 1 MB"):
        opened.read(root / "data/secret/1.in", 1 << 20)


def test_a_program_of_very_many_files_is_refused(tmp_path):
    root = written(tmp_path / "sum", LEGACY, {f"submissions/accepted/many/{n}.py": "" for n in range(201)})
    with pytest.raises(ProblemError, match="more than 200 files"):
        content_of(Opened(str(root)), root / "submissions/accepted/many")


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (
            "a0: &a0 [x, x]\n" + "".join(f"a{n}: &a{n} [*a{n - 1}, *a{n - 1}]\n" for n in range(1, 40)),
            "aliases",
        ),
        ("a: " + "[" * 30_000, "this is no YAML"),
        ("a: !!python/object/apply:os.system ['touch /tmp/never']", "this is no YAML"),
        ("a: " + "9" * 50_000, "this is no YAML"),
        ("a: 9999-99-99", "this is no YAML"),
        ("a: \x00", "this is no YAML"),
        ("a: [&x a, *y]", "this is no YAML"),
        ('a: !!int ""', "none of what its tag says"),
        ("a: !!bool x", "none of what its tag says"),
        ("a: !!timestamp x", "none of what its tag says"),
        ("#" * (65 << 10), "larger than 64 KB"),
    ],
)
def test_yaml_that_means_harm(tmp_path, text, why):
    root = written(tmp_path / "sum", {"problem.yaml": text})
    with pytest.raises(ProblemError, match=why) as refused:
        read_settings(Opened(str(root)), root / "problem.yaml")
    assert "\n" not in str(refused.value)
    assert settings.number({}, "memory", 1, 1, 2, "") == 1


def test_a_folder_that_is_called_like_an_archive(tmp_path):
    root = written(tmp_path / "sum.zip", LEGACY)
    assert is_package(str(root))
    assert Opened(str(root)).name == "sum.zip"
    assert not is_package(str(tmp_path / "none.zip"))
    with pytest.raises((ProblemError, UsageError)):
        Opened(str(tmp_path / "none.zip"))
