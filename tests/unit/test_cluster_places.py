"""What `--on` names, and what is started there: addresses, machines that ssh reaches, Slurm, keys.

What is refused in a line is in golden/transcripts: refused/class-on.txt.
"""

from __future__ import annotations

import os
import re
import shlex
import stat
import sys

import pytest
from executed import work

from judge.cluster import slurm, ssh
from judge.cluster.greeting import Offer
from judge.cluster.parcel import answer_of, call, name_of, packed, result_of
from judge.cluster.where import FORMS, Address, Machines, read_where
from judge.errors import JudgeError, UsageError
from judge.manual import page

SSH = """#!/bin/sh
while [ "${1#-}" != "$1" ]; do
    case $1 in -o | -L) shift 2 ;; *) shift ;; esac
done
[ "$1" = lab09 ] && { echo "ssh: connect to host lab09 port 22: No route to host" >&2; exit 255; }
shift
exec sh -c "$*"
"""
SBATCH = """#!/bin/sh
printf '%s\\n' "$@" > "$0.words"
eval "command=\\${$#}"
sh -c "$command" > /dev/null 2>&1 &
echo $!
"""


def lost(item, why):
    return f"lost: {why}"


def program(folder, name, text):
    path = folder / name
    path.write_text(text)
    path.chmod(0o755)
    return path


@pytest.fixture
def path(tmp_path, monkeypatch):
    """A folder of programs that are found before others; judge among them."""
    folder = tmp_path / "bin"
    folder.mkdir()
    program(folder, "judge", f'#!/bin/sh\nexec {sys.executable} -m judge "$@"\n')
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(sys.path[:1] + [each for each in sys.path if each]))
    monkeypatch.setenv("EXECUTED_BY", str(os.getpid()))
    return folder


# -- addresses -------------------------------------------------------------------------------------------


def test_addresses_the_usual_port_and_the_machines():
    for text in ("tcp://127.0.0.1:8786", "tcp://localhost:9", "tcp://[::1]:8786", "tls://a.b:1"):
        assert str(read_where(text)) == text
    assert Address.of("tls://teacher") == Address("tls", "teacher", 8786)
    assert str(read_where("ssh:hosts.txt").file) == "hosts.txt"
    assert read_where("slurm") == Machines("slurm")
    assert str(read_where("slurm:lab.toml").file) == "lab.toml"


# -- what travels ----------------------------------------------------------------------------------------


def test_a_function_travels_by_name_and_faults_as_text(tmp_path):
    assert name_of(work) == "executed:work"
    with pytest.raises(UsageError, match="cannot be sent"):
        name_of(lambda item: item)
    answers = {
        what: answer_of(call("executed:work", packed(f"{tmp_path} {what} n")))
        for what in ("well", "usage", "faulty")
    }
    assert result_of(work, answers["well"]) == "N"
    with pytest.raises(UsageError, match="isolation full cannot be had here"):
        result_of(work, answers["usage"])
    assert answers["faulty"].ended == "internal fault: ArithmeticError('n')"
    assert "no_such" in answer_of(call("executed:no_such", packed("x"))).ended


# -- comparing -------------------------------------------------------------------------------------------

FACTS = {"judge": "1 (a)", "python": "CPython 3.12.1", "distributed": "2026.8"}
HERE = Offer(FACTS, {"count": "aa"}, ("full",))


@pytest.mark.parametrize(
    ("there", "told"),
    [
        (HERE, ""),
        (Offer(FACTS, {"count": "aa", "other": "x"}, ("full", "strong")), ""),
        (None, "was not started by 'judge worker' (it lacks the resource 'judge')"),
        (Offer(FACTS | {"judge": "2 (b)"}, {"count": "aa"}, ("full",)), "has judge 2 (b), and here is 1 (a)"),
        (
            Offer(FACTS | {"python": "CPython 3.11.7"}, {"count": "aa"}, ("full",)),
            "has python CPython 3.11.7",
        ),
        (Offer(FACTS, {}, ("full",)), "has no problem 'count'"),
        (Offer(FACTS, {"count": "bb"}, ("full",)), "has another version of the problem 'count'"),
        (Offer(FACTS, {"count": "aa"}, ("strong",)), "has no isolation full"),
    ],
)
def test_in_what_a_worker_differs(there, told):
    what, remedy = HERE.differs(there)
    assert what.startswith(told)
    assert bool(what) == bool(remedy) == bool(told)
    if there is not None:  # the scheduler must match as we do: by the names of resources
        assert Offer.of_resources(there.resources()) == there
        assert (HERE.wants("count").keys() <= there.resources().keys()) == (not told)


# -- ssh -------------------------------------------------------------------------------------------------


def test_the_machines_of_a_file_and_their_command_lines(tmp_path):
    file = tmp_path / "hosts.txt"
    file.write_text("# the lab\nlab01.example.org 4\n\nada@lab02 8 /opt/it's/judge  # hers\nlab03\n")
    first, second, third = ssh.read_hosts(file)
    assert (first.name, first.slots, third) == ("lab01.example.org", 4, ssh.Host("lab03"))
    line = second.command("tls://10.0.0.1:1", scheduler=False)
    assert line[0] == "ssh"
    assert line[-2] == "ada@lab02"
    assert shlex.split(line[-1]) == [
        "/opt/it's/judge",
        *["worker", "tls://10.0.0.1:1", "--keys", "-", "--json", "-j", "8"],
    ]
    assert first.command("tls://0.0.0.0:0", scheduler=True)[-1].endswith("--json --scheduler")
    assert "127.0.0.1:9:10.0.0.1:1" in first.tunnel(9, Address("tls", "10.0.0.1", 1))


@pytest.mark.nightly
def test_machines_by_ssh_judge_and_one_that_is_away_is_told(path, tmp_path):
    pytest.importorskip("distributed")
    from judge.cluster.on import executor_at

    program(path, "ssh", SSH)
    file, told = tmp_path / "hosts.txt", []
    file.write_text("lab01 1\nlab09 1\n")
    with executor_at(f"ssh:{file}", [], say=told.append) as ring:
        assert dict(ring.finished(work, [f"{tmp_path} well n"], lost)) == {0: "N"}
        assert ring.alive() == 1
    assert told == [
        "goes on without lab09: it has not started: ssh: connect to host lab09 port 22: No route to host"
    ]


@pytest.mark.slow
def test_no_ssh_and_a_first_machine_that_is_away(path, tmp_path, monkeypatch):
    pytest.importorskip("distributed")
    from judge.cluster.on import executor_at

    file = tmp_path / "hosts.txt"
    file.write_text("lab09 1\n")
    program(path, "ssh", SSH)
    with (
        pytest.raises(JudgeError, match=r"lab09: it has not started: ssh: .*No route to host"),
        executor_at(f"ssh:{file}", []),
    ):
        pass
    monkeypatch.setenv("PATH", str(tmp_path))
    with (
        pytest.raises(JudgeError, match=r"ssh cannot be started \(no such file or directory\)"),
        executor_at(f"ssh:{file}", []),
    ):
        pass


# -- Slurm -----------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_slurm_is_asked_for_workers_and_they_judge(path, tmp_path, monkeypatch):
    pytest.importorskip("distributed")
    from judge.cluster.on import executor_at

    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    asked = program(path, "sbatch", SBATCH)
    program(path, "scancel", f'#!/bin/sh\necho "$1" > {path}/cancelled\nkill "$1"\n')
    config = tmp_path / "lab.toml"
    config.write_text('jobs = 1\noptions = ["--partition=short"]\nwait = 60\n')
    with executor_at(f"slurm:{config}", []) as ring:
        assert dict(ring.finished(work, [f"{tmp_path} well n"], lost)) == {0: "N"}
        words = (asked.parent / "sbatch.words").read_text().splitlines()
        (folder,) = (tmp_path / "cache" / "cluster").iterdir()
        assert stat.S_IMODE((folder / "key.pem").stat().st_mode) == 0o600
    assert {"--parsable", "--array=1-1", "--cpus-per-task=1", "--partition=short", "--wrap"} <= set(words)
    assert f"--keys {folder} -j 1" in words[-1]
    assert (path / "cancelled").read_text().strip().isdigit()
    assert not folder.exists()


def test_where_slurm_is_not(path, tmp_path, monkeypatch):
    with pytest.raises(JudgeError, match="there is no sbatch here"):
        slurm._asked(["sbatch"])
    program(
        path, "sbatch", "#!/bin/sh\necho 'sbatch: error: invalid partition specified: short' >&2; exit 1\n"
    )
    with pytest.raises(JudgeError, match="sbatch refuses: sbatch: error: invalid partition specified: short"):
        slurm._asked(["sbatch"])


def test_the_files_in_the_manual_are_read_as_it_says(tmp_path):
    told = page("cluster").text
    for kind, name in (("text", "hosts.txt"), ("toml", "lab.toml")):
        (content,) = re.findall(rf"^```{kind}\n(.*?)^```", told, re.MULTILINE | re.DOTALL)
        (tmp_path / name).write_text(content)
    assert [host.slots for host in ssh.read_hosts(tmp_path / "hosts.txt")] == [4, 4, None, 2, 8]
    config = slurm.read_config(tmp_path / "lab.toml")
    assert (config.jobs, config.cores, config.host) == (8, 1, "login1.cluster")
    assert set(re.findall(r"^(\w+) = ", content, re.MULTILINE)) == set(config.__struct_fields__)
    assert f"--on {FORMS.split(', ')[1]}".replace("HOST:PORT", "A:8786") in told


# -- keys ------------------------------------------------------------------------------------------------


def test_keys_are_secret_and_never_written_over(tmp_path, monkeypatch):
    pytest.importorskip("cryptography")
    from judge.cluster.keys import FILES, Keys, new_keys, of_lines, read_keys

    folder, keys = tmp_path / "keys", new_keys()
    keys.write(folder)
    assert {path.name: stat.S_IMODE(path.stat().st_mode) for path in folder.iterdir()} == dict.fromkeys(
        FILES, 0o600
    )
    with pytest.raises(UsageError, match=r"ca\.pem is there already; name another folder"):
        new_keys().write(folder)
    monkeypatch.setenv("JUDGE_KEYS", str(folder))
    assert read_keys(None) == read_keys(folder) == keys
    rest = iter([*keys.text().encode().splitlines(keepends=True), b"more\n"])
    assert of_lines(rest) == keys
    assert list(rest) == [b"more\n"]
    with pytest.raises(UsageError, match="there are no keys on standard input"):
        of_lines(iter([b"x\n"]))
    with pytest.raises(UsageError, match="no keys that belong together"):
        of_lines(iter(Keys(keys.ca, keys.cert, new_keys().key).text().encode().splitlines(keepends=True)))
    (folder / "key.pem").chmod(0o640)
    with pytest.raises(UsageError, match="others may read this key; chmod 600"):
        read_keys(folder)
    with pytest.raises(UsageError, match="make them with 'judge worker --new-keys DIR'"):
        read_keys(tmp_path)


def test_a_package_that_is_missing_is_told_with_the_command_that_installs_it(monkeypatch):
    from judge.cluster.need import distributed, x509

    monkeypatch.setitem(sys.modules, "distributed", None)
    monkeypatch.setitem(sys.modules, "cryptography.x509", None)
    for need in (distributed, x509):
        with pytest.raises(UsageError, match=r"is not installed; pip install 'circle-line-judge\[cluster\]'"):
            need()
