"""Packages that mean harm: links, names, sizes and YAML that lead out, or fill what they can."""

from __future__ import annotations

import errno
import os
import stat
import zipfile
from pathlib import Path

import pytest
from foreign_packages import LEGACY, written, zipped

from judge.errors import JudgeError, ProblemError, UsageError
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


@pytest.mark.parametrize(
    "name",
    [
        "../out.txt",
        "sum/../../out.txt",
        "/tmp/out.txt",
        "..\\out.txt",
        "sum/data\\..\\x",
        "x" * 300,
        "a/" * 40 + "b",
    ],
)
def test_a_member_that_leads_elsewhere(tmp_path, name):
    path = zipped(tmp_path / "bad.zip", {**FOUNDED, name: "x"})
    with pytest.raises(ProblemError, match="no name of a file"):
        Opened(str(path))
    assert not (tmp_path / "out.txt").exists()


@pytest.mark.parametrize("kind", [stat.S_IFLNK, stat.S_IFIFO, stat.S_IFCHR])
def test_a_member_that_is_a_link_or_a_device(tmp_path, kind):
    path = zipped(tmp_path / "bad.zip", FOUNDED)
    with zipfile.ZipFile(path, "a") as archive:
        member = zipfile.ZipInfo("sum/data/secret/2.in")
        member.external_attr = (kind | 0o777) << 16
        archive.writestr(member, "/etc/passwd")
    with pytest.raises(ProblemError, match="is a link or no ordinary file"):
        Opened(str(path))


def test_a_member_that_is_there_twice(tmp_path):
    path = zipped(tmp_path / "bad.zip", FOUNDED)
    with zipfile.ZipFile(path, "a") as archive, pytest.warns(UserWarning, match="Duplicate"):
        archive.writestr("sum/problem.yaml", "name: another")
    with pytest.raises(ProblemError, match="twice"):
        Opened(str(path))


def test_a_member_that_is_packed_otherwise(tmp_path):
    path = zipped(tmp_path / "bad.zip", FOUNDED)
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr("sum/data/secret/2.in", "1 2", zipfile.ZIP_BZIP2)
    with pytest.raises(ProblemError, match="packed in an unusual way; pack it anew"):
        Opened(str(path))


def test_a_members_name_that_is_no_text(tmp_path):
    path = zipped(tmp_path / "bad.zip", {**FOUNDED, "sum/\u00fc.in": "x"})
    path.write_bytes(path.read_bytes().replace("\u00fc".encode(), b"\xff\xfe"))
    with pytest.raises(ProblemError, match="no zip file that can be read"):
        Opened(str(path))


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
    whole = zipped(tmp_path / "whole.zip", {**FOUNDED, "sum/big": bytes(9 << 20)})
    many = zipped(tmp_path / "many.zip", {**FOUNDED, **{f"sum/{n}": bytes(1 << 20) for n in range(5)}})
    for path in (whole, many):
        assert path.stat().st_size < 1 << 16
        with pytest.raises(ProblemError, match="unpacked it is larger"):
            Opened(str(path))


def test_an_archive_of_very_many_files(tmp_path, monkeypatch):
    monkeypatch.setattr(opening, "MOST_FILES", 50)
    path = zipped(tmp_path / "many.zip", {**FOUNDED, **{f"sum/{n}": "" for n in range(60)}})
    with pytest.raises(ProblemError, match="more than 50 files"):
        Opened(str(path))


@pytest.mark.parametrize(
    "content", [b"", b"no zip", b"PK\x05\x06" + bytes(17), b"PK\x05\x06" + b"\xff" * 18, b"PK\x06\x07" * 9]
)
def test_what_is_no_archive(tmp_path, content):
    path = tmp_path / "bad.zip"
    path.write_bytes(content)
    with pytest.raises(ProblemError):
        Opened(str(path))


def test_an_archive_that_is_cut_or_holds_no_package(tmp_path):
    path = zipped(tmp_path / "sum.zip", {"readme.txt": "x"})
    with pytest.raises(ProblemError, match=r"no problem\.yaml"):
        Opened(str(path))
    content = bytearray(zipped(tmp_path / "sum.zip", FOUNDED).read_bytes())
    content[40:60] = bytes(20)
    path.write_bytes(content)
    with pytest.raises(JudgeError):
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
