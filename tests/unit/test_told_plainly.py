"""What a tool, a library or the system says is told in the judge's words, and never as an object's name."""

from __future__ import annotations

import os
import re
import subprocess

import pytest
from foreign_packages import LEGACY, NEW, written, zipped
from native import fault_of

from judge.errors import JudgeError, ProblemError
from judge.languages import find
from judge.languages.model import language_called
from judge.packs.foreign import settings
from judge.packs.foreign.cases import test_files as files_of
from judge.packs.foreign.checker import Checker
from judge.packs.foreign.look import is_package
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.package import read_package
from judge.packs.foreign.settings import read_settings
from judge.problem import Verdict, solutions
from judge.sandbox import Boxes

_ANEW = "; pack it anew, as zip does without options"


def refused(word):
    with pytest.raises(JudgeError) as fault:
        Opened(str(word))
    return str(fault.value).removeprefix(f"{word}: ")


# -- archives ----------------------------------------------------------------------------------------------


def flagged(path, bit):
    """The archive with that flag set for each of its entries."""
    content = bytearray(path.read_bytes())
    for sign, place in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        for found in re.finditer(re.escape(sign), bytes(content)):
            content[found.start() + place] |= bit
    path.write_bytes(content)
    return path


@pytest.mark.parametrize(
    ("bit", "told"),
    [
        (0x01, "'problem.yaml' is encrypted; pack it without a password"),
        (0x20, f"this is no zip file that can be read: it is packed in an unusual way{_ANEW}"),
        (0x40, f"this is no zip file that can be read: it is packed in an unusual way{_ANEW}"),
    ],
)
def test_an_archive_that_is_packed_with_a_password_or_otherwise(tmp_path, bit, told):
    assert refused(flagged(zipped(tmp_path / "a.zip", LEGACY), bit)) == told


@pytest.mark.parametrize("old", [b"PK\x03\x04", b"data/secret/1.in", b"PK\x01\x02", bytes([75, 204, 77])])
def test_an_archive_that_is_damaged(tmp_path, old):
    path = zipped(tmp_path / "a.zip", LEGACY)
    content = path.read_bytes()
    assert old in content
    path.write_bytes(content.replace(old, b"\xfe" * len(old), 1))
    assert refused(path) == f"this is no zip file that can be read: it is damaged{_ANEW}"


def test_every_archive_with_a_changed_byte_is_told_shortly(tmp_path):
    path = zipped(tmp_path / "a.zip", LEGACY)
    content = path.read_bytes()
    for place in range(0, len(content), 3):
        path.write_bytes(content[:place] + bytes([content[place] ^ 0xA5]) + content[place + 1 :])
        try:
            with Opened(str(path)):
                pass
        except JudgeError as fault:
            told = str(fault)
            assert "<" not in told
            assert "b'" not in told
            assert len(told) < len(str(path)) + 200


def test_a_pipe_is_no_package_and_nobody_waits_for_it(tmp_path):
    os.mkfifo(tmp_path / "a.zip")
    (tmp_path / "b.kpp").symlink_to("a.zip")
    for name in ("a.zip", "b.kpp"):
        assert is_package(str(tmp_path / name))
        remedy = "name a zip file, or a folder with a problem.yaml"
        assert refused(tmp_path / name) == f"this is no ordinary file; {remedy}"
    folder = written(tmp_path / "sum", LEGACY, {"problem.yaml": None})
    os.mkfifo(folder / "problem.yaml")
    assert is_package(str(folder))
    with Opened(str(folder)) as opened, pytest.raises(ProblemError, match="it is no ordinary file"):
        read_package(opened)


def test_a_folder_that_is_called_like_an_archive_is_none(tmp_path):
    (tmp_path / "a.zip").mkdir()
    assert not is_package(str(tmp_path / "a.zip"))
    assert not is_package(str(tmp_path / "b.zip"))


# -- YAML --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("a: 2026-13-01", "a number or a date in it is none"),
        ("a: !!float x", "a number or a date in it is none"),
        ("a: 1\n---\nb: 2", "expected a single document in the stream, but found another document"),
        ("a: [1", "expected ',' or ']', but got the stream end"),
        ("a: 1\n- b", "expected the block end, but found '-'"),
        ("a: !!int ''", "a value is none of what its tag says"),
        (
            "a: &a {b: 1}\n" + "".join(f"c{n}: {{<<: *a}}\n" for n in range(3)),
            "it merges keys with << more than 2 times",
        ),
    ],
)
def test_yaml_that_cannot_be_read(tmp_path, text, told):
    (tmp_path / "a.yaml").write_text(text)
    with Opened(str(tmp_path)) as opened, pytest.raises(ProblemError) as fault:
        read_settings(opened, tmp_path / "a.yaml")
    assert fault.value.what == f"this is no YAML: {told}"


def test_many_yaml_files_are_too_much(tmp_path, monkeypatch):
    """Each is small, and the parser is slow: twenty thousand of them would take hours."""
    monkeypatch.setattr(settings, "_MOST_BYTES", 1 << 16)
    with Opened(str(tmp_path)) as opened:
        (tmp_path / "a.yaml").write_text("a: 1\n" + "#" * 30_000)
        assert [read_settings(opened, tmp_path / "a.yaml") for _ in range(2)] == [{"a": 1}] * 2
        with pytest.raises(ProblemError, match=r"YAML files come to more than 0 MB with this one"):
            read_settings(opened, tmp_path / "a.yaml")


# -- programs ----------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize(
    ("program", "told"),
    [
        ("import os\nos.kill(os.getpid(), 19)\n", "the output validator stopped itself"),
        (
            "import os\nos.kill(os.getpid(), 9)\n",
            "the output validator ended with neither 42 nor 43: killed by SIGKILL",
        ),
        ("pass\n", "the output validator ended with neither 42 nor 43: exit status 0"),
    ],
)
def test_an_output_validator_that_does_not_end_by_itself(tmp_path, program, told):
    folder = written(tmp_path / "sum", NEW, {"output_validator/check.py": program})
    with Opened(str(folder)) as opened:
        package = read_package(opened)
        with Checker(package, Boxes()) as checker:
            checked = checker.checked(files_of(package)[0], b"1 2\n", b"3\n", b"3\n")
    assert checked.verdict is Verdict.JE
    assert checked.message.startswith(told)


_HUGE = "static int a[1000000000], b[1000000000]; int main(void) { a[5] = b[7]; return a[3] + b[2]; }"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "source", "told"),
    [
        ("a.c", _HUGE, "its arrays take more than the 2 GB that can be linked"),
        ("a.cpp", f"#include <vector>\n{_HUGE}", "its arrays take more than the 2 GB that can be linked"),
        (
            "a.c",
            "int _start(void) { return 0; } int main(void) { return 0; }",
            "multiple definition of `_start'",
        ),
        ("a.c", "int f(int); int main(void) { return f(1); }", "undefined reference to `f'"),
        (
            "a.rs",
            'extern "C" { fn nowhere() -> i32; }\nfn main() { unsafe { nowhere(); } }',
            "it cannot be linked: is something declared and nowhere defined?",
        ),
        (
            "a.c",
            '__asm__(".globl main\\nmain: .long 1\\n");\nint main(void) { return 0; }',
            "Error: symbol `main' is already defined",
        ),
    ],
)
def test_what_cannot_be_linked(name, source, told):
    assert fault_of(name, source).message == told


@pytest.mark.parametrize(
    ("fault", "told"),
    [
        (PermissionError(13, "Permission denied", "/x"), "/x cannot be started (permission denied)"),
        (subprocess.TimeoutExpired(["/x", "y"], 60.0), "/x y does not answer within 60 s"),
    ],
)
def test_a_tool_that_does_not_answer(monkeypatch, fault, told):
    def failing(*_args, **_more):
        raise fault

    monkeypatch.setattr(find.subprocess, "run", failing)
    with pytest.raises(JudgeError) as caught:
        find._asked(language_called("go"), ["/x", "y"])
    assert caught.value.what == told


def test_a_solution_that_is_no_python_has_its_line(tmp_path):
    (tmp_path / "problems" / "x").mkdir(parents=True)
    folder = tmp_path / "solutions" / "x" / "accepted"
    folder.mkdir(parents=True)
    (folder / "a.py").write_text("a = 1\ndef (:\n")
    with pytest.raises(ProblemError) as caught:
        solutions._read(solutions.Kind.ACCEPTED, folder / "a.py")
    assert caught.value.where.endswith("a.py:2")
    assert caught.value.what == "no Python: invalid syntax"
