"""Shell completion: by click's own interface, and in the shells that are there."""

from __future__ import annotations

import json
import os
import select
import shutil
import subprocess
import sys
import time

import click
import pytest
from cli_support import MEAN, ROOT
from click.shell_completion import ShellComplete

from judge.cli import complete
from judge.cli.app import app
from judge.cli.table import COMMANDS

pytestmark = pytest.mark.slow

SHELLS = ["bash", "zsh", "fish"]


def offered(*words: str) -> list[str]:
    """What may stand where the last word is being typed; a shell's own kind is shown as <kind>."""
    *args, incomplete = words
    found = ShellComplete(app, {}, "judge", complete.VARIABLE).get_completions(args, incomplete)
    return [item.value if item.type == "plain" else f"<{item.type}>" for item in found]


def test_commands_with_what_they_do():
    assert offered("") == list(COMMANDS)
    assert offered("rep") == ["replay", "report"]
    (item,) = ShellComplete(app, {}, "judge", "X").get_completions([], "doc")
    assert item.help == COMMANDS["doctor"]


def test_options():
    assert offered("--de") == ["--debug"]
    assert "--junit" in offered("run", "middle", "--j")
    assert offered("run", "middle", "mine.py", "--isolation", "s") == ["strong"]
    assert offered("run", "--format=g") == ["github"]


@pytest.mark.parametrize(
    "command",
    [
        "run",
        "watch",
        "init",
        "hint",
        "solution",
        "hack",
        "stress",
        "history",
        "show",
        "why",
        "data",
        "verify",
    ],
)
def test_problems(command):
    files = ["<py>"] if command in ("run", "watch", "hint", "stress", "why") else []
    shipped = [path.parent.name for path in (ROOT / "problems").glob("*/problem.toml")]
    assert offered(command, "") == [*sorted([*shipped, "middle"]), *files]
    assert offered(command, "mi") == ["middle", *files]
    assert offered(command, "nothing-like-it") == files


def test_a_problem_that_was_named_is_not_offered_again():
    assert "middle" not in offered("verify", "middle", "")


def test_problems_of_ones_own(pack, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS")
    assert "middle" not in offered("show", "")
    assert "middle" in offered("show", "--problems", str(pack / "problems"), "")


@pytest.mark.parametrize(
    "words",
    [
        ("run", "middle", "--group"),
        ("run", "middle", "mine.py", "-q", "--group"),
        ("data", "--out", "x", "middle", "--group"),
        ("why", "middle"),
    ],
)
def test_groups_of_the_problem_before(words):
    assert offered(*words, "") == ["examples", "whole", "half"]
    assert offered(*words, "h") == ["half"]


def test_what_a_quiz_may_be_about():
    assert offered("quiz", "sen") == ["senior"]
    assert offered("quiz", "--form", "t") == ["tags"]
    assert offered("quiz", "--row", "x1") == ["X1"]
    assert offered("quiz", "--card", "halves/") == ["halves/half-of-seven", "halves/rounding"]
    assert offered("quiz", "--interview", "--kata", "mid") == ["middle"]
    assert "J13" in offered("progress", "--row", "J")
    assert offered("schema", "car") == ["cards"]


def test_without_a_problem_or_with_a_broken_one_there_are_no_groups(monkeypatch, broken_pack):
    assert offered("run", "--group", "") == []
    assert offered("why", "middel", "") == []
    monkeypatch.setenv("JUDGE_PROBLEMS", str(broken_pack))
    assert offered("why", "bad-toml", "") == []


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        (("run", "middle", ""), "<py>"),
        (("run", "middle", "a.py", "b"), "<py>"),
        (("replay", "id", ""), "<py>"),
        (("run", "middle", "--junit", ""), "<file>"),
        (("run", "middle", "--svg", ""), "<file>"),
        (("run", "--problems", ""), "<dir>"),
        (("new", ""), "<dir>"),
        (("data", "middle", "--out", ""), "<dir>"),
    ],
)
def test_files_are_left_to_the_shell(words, kind):
    assert offered(*words) == [kind]


def test_sets():
    assert offered("practice", "") == offered("progress", "")
    assert offered("practice", "s") == ["senior"]


def test_shells_and_schemas():
    assert offered("completion", "") == SHELLS
    assert offered("schema", "ve") == ["verify"]


@pytest.mark.parametrize("name", COMMANDS)
def test_every_problem_and_file_in_a_commands_arguments_is_completed(name):
    command = complete.offering(app.get_command(None, name))
    for parameter in command.params:
        if isinstance(parameter, click.Argument) and parameter.metavar.strip("[].") in ("PROBLEM", "FILE"):
            assert isinstance(parameter.type, complete._Offered), parameter.metavar


def test_the_command_itself_is_left_as_it_is(judge, submit):
    offered("run", "")
    assert judge("run", "middle", submit(MEAN)).status == 0


# -- asked as a shell does -------------------------------------------------------------------------------


def asked(instruction: str, *, expect: int = 0, **settings: str) -> str:
    environment = {**os.environ, "PYTHONPATH": str(ROOT), complete.VARIABLE: instruction, **settings}
    command = [sys.executable, "-m", "judge"]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False, env=environment)
    assert ended.stderr == ""
    assert ended.returncode == expect
    return ended.stdout


def test_the_three_answers():
    line = {"COMP_WORDS": "judge show mi", "COMP_CWORD": "2"}
    assert asked("zsh_complete", **line) == "plain\nmiddle\n_\n"
    assert asked("fish_complete", COMP_WORDS="judge show mi", COMP_CWORD="mi") == "plain,middle\n"
    assert asked("bash_complete", COMP_WORDS="judge\nshow\nmi", COMP_CWORD="2") == "plain,middle\n"


@pytest.mark.parametrize(
    ("instruction", "settings", "status"),
    [
        ("bash_complete", {"COMP_WORDS": "judge\nshow\n", "JUDGE_PROBLEMS": "/dev/null/nowhere"}, 0),
        ("zsh_complete", {"COMP_WORDS": "judge show", "COMP_CWORD": "x"}, 1),
        ("fish_complete", {}, 1),
        ("ksh_complete", {}, 1),
        ("nonsense", {}, 1),
    ],
)
def test_errors_are_silent(instruction, settings, status):
    assert asked(instruction, expect=status, **settings).strip() == ""


@pytest.mark.parametrize("closed", [">&-", "</dev/null >/dev/full", ">&- 2>&-"])
def test_an_answer_that_nobody_takes_is_silent(closed):
    ended = subprocess.run(
        ["sh", "-c", f'"{sys.executable}" -m judge {closed}'],
        env={**os.environ, "PYTHONPATH": str(ROOT), complete.VARIABLE: "bash_source"},
        capture_output=True,
        timeout=60,
        check=False,
    )
    assert (ended.returncode, ended.stdout, ended.stderr) == (1, b"", b"")


def test_nothing_heavy_is_imported(tmp_path):
    script = (
        "import sys\nfrom judge.cli import main\nsys.argv = ['judge']\n"
        "try:\n    main()\nexcept SystemExit:\n    pass\n"
        "heavy = ('rich', 'hypothesis', 'sqlite3', 'jinja2', 'importlib.metadata', 'numpy', 'judge.exact')\n"
        "print(*(name for name in heavy if name in sys.modules), file=sys.stderr)\n"
    )
    for words in ("judge\n", "judge\nrun\n", "judge\nrun\ncount\n--group\n", "judge\nrun\ncount\n"):
        settings = {complete.VARIABLE: "bash_complete", "COMP_WORDS": words, "COMP_CWORD": "1"}
        environment = {**os.environ, "PYTHONPATH": str(ROOT), **settings}
        command = [sys.executable, "-c", script]
        ended = subprocess.run(
            command, capture_output=True, text=True, timeout=60, check=True, env=environment
        )
        assert ended.stdout
        assert ended.stderr.split() == []


# -- in real shells --------------------------------------------------------------------------------------


@pytest.fixture
def shell(tmp_path, judge):
    """A folder with files, a command `judge` on the path, and a shell's script; its environment."""

    def prepare(name: str) -> dict[str, str]:
        if shutil.which(name) is None:
            pytest.skip(f"there is no {name}")
        program = tmp_path / "bin" / "judge"
        program.parent.mkdir()
        program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m judge "$@"\n')
        program.chmod(0o755)
        ended = judge("completion", name)
        assert ended.status == 0
        (tmp_path / "script").write_text(ended.out)
        assert json.loads(judge("completion", name, "--json").out)["script"] == ended.out
        here = tmp_path / "here"
        (here / "folder").mkdir(parents=True)
        for file in ("mine.py", "my other.py", "notes.txt"):
            (here / file).write_text("")
        path = f"{program.parent}{os.pathsep}{os.environ['PATH']}"
        return {**os.environ, "PATH": path, "PYTHONPATH": str(ROOT), "HOME": str(tmp_path), "TERM": "xterm"}

    return prepare


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        (["show", "mi"], ["middle"]),
        (["run", "middle", "--group", "h"], ["half"]),
        (["run", "middle", "--group", "=", "h"], ["half"]),
        (["run", "middle", "'--group'", "h"], ["half"]),
        (["run", "middle", "m"], ["mine.py", "my other.py"]),
        (["doctor", "x"], []),
        (["show", "'mid"], ["middle"]),
        (["", "x"], []),
        (["completion", ""], SHELLS),
    ],
)
def test_in_bash(words, wanted, shell, tmp_path):
    settings = shell("bash")
    line = " ".join(f'"{word}"' for word in ["judge", *words])
    script = (
        f"source {tmp_path}/script\ncomplete -p judge >/dev/null || exit 9\n"
        f"COMP_WORDS=({line})\nCOMP_CWORD={len(words)}\n"
        f'_judge_completion judge "{words[-1]}" before\n'
        'for each in "${COMPREPLY[@]}"; do echo "$each"; done\n'
    )
    command = ["bash", "--norc", "--noprofile", "-c", script]
    ended = subprocess.run(
        command, cwd=tmp_path / "here", env=settings, capture_output=True, text=True, timeout=60, check=True
    )
    assert sorted(ended.stdout.splitlines()) == sorted(wanted)
    assert ended.stderr == ""


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("judge show mi", ["middle"]),
        ("judge run middle --group h", ["half\tWhole numbers whose middle ends in a half."]),
        ("judge run middle --group=h", ["--group=half\tWhole numbers whose middle ends in a half."]),
        ("judge doc", ["doctor\tSay how well submissions are contained on this machine."]),
        ("judge show 'mid", ["middle"]),
    ],
)
def test_in_fish(line, wanted, shell, tmp_path):
    settings = shell("fish")
    command = ["fish", "--no-config", "-c", f'source {tmp_path}/script; complete -C "{line}"']
    ended = subprocess.run(
        command, cwd=tmp_path / "here", env=settings, capture_output=True, text=True, timeout=60, check=True
    )
    assert ended.stdout.splitlines() == wanted
    assert ended.stderr == ""


def test_files_in_fish(shell, tmp_path):
    settings = shell("fish")
    command = ["fish", "--no-config", "-c", f"source {tmp_path}/script; complete -C 'judge run middle '"]
    ended = subprocess.run(
        command, cwd=tmp_path / "here", env=settings, capture_output=True, text=True, timeout=60, check=True
    )
    found = [line.split("\t")[0] for line in ended.stdout.splitlines()]
    assert found == ["folder/", "mine.py", "my other.py"]


def typed(command: list[str], settings: dict[str, str], folder: object, lines: list[tuple[str, str]]) -> str:
    """Type into a shell on a terminal of its own: each text, once what comes before it has appeared."""
    import pty  # not everywhere

    ours, theirs = pty.openpty()
    with subprocess.Popen(
        command,
        stdin=theirs,
        stdout=theirs,
        stderr=theirs,
        env=settings,
        cwd=str(folder),
        start_new_session=True,
    ) as running:
        os.close(theirs)
        seen, start = "", 0
        for awaited, text in lines:
            end = time.monotonic() + 20
            while awaited not in seen[start:] and time.monotonic() < end:
                if select.select([ours], [], [], 0.1)[0]:
                    seen += os.read(ours, 65536).decode(errors="replace")
            assert awaited in seen[start:], seen
            start = len(seen)
            os.write(ours, text.encode())
        running.terminate()
        running.kill()
        running.wait()
    os.close(ours)
    return seen


@pytest.mark.parametrize(
    ("start", "wanted"),
    [
        ("judge show mi", "middle"),
        ("judge run middle --group h", "half"),
        ("judge run middle --group=h", "--group=half"),
        ("judge run middle mi", "mine.py"),
    ],
)
def test_in_zsh(start, wanted, shell, tmp_path):
    settings = shell("zsh")
    set_up = f"PS1='R''EADY '; autoload -Uz compinit; compinit -u -D; source {tmp_path}/script\n"
    lines = [("", set_up), ("READY ", f"{start}\t"), (wanted[len(start.split()[-1]) :], "\x03")]
    seen = typed(["zsh", "-f", "-i"], settings, tmp_path / "here", lines)
    assert "judge:" not in seen
    assert "Traceback" not in seen
