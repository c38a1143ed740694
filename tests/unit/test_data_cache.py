"""The cache of built data: warm starts, everything that can be wrong with a file, and where it is."""

from __future__ import annotations

import hashlib
import math
import os
import random
import shutil
import struct
import subprocess
import sys
import threading
from pathlib import Path

import platformdirs
import pytest

from judge.cache import CacheFolder
from judge.data.load import kept_place, load_data
from judge.data.pins import hash_of
from judge.files import cache_folder, user_data
from judge.problem.load import load_problem

ROOT = Path(__file__).parent.parent.parent
SOUND = ROOT / "tests" / "fixtures" / "problems" / "root-count"
SEVERAL = ROOT / "tests" / "fixtures" / "katas" / "problems" / "by-size"


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """The cache folder of this test."""
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / "data"


@pytest.fixture
def copy(tmp_path):
    target = tmp_path / "problems" / "root-count"
    shutil.copytree(SOUND, target)
    return target


def files(folder):
    return sorted(path.name for path in folder.iterdir())


def built(problem, **options):
    """The data, and whether they had to be built."""
    steps = []
    data = load_data(problem, progress=lambda done, total: steps.append(done), **options)
    return data, bool(steps)


def plain(data):
    return [(group.group, group.cases, group.targets) for group in data.groups]


@pytest.mark.parametrize("place", [SOUND, SEVERAL], ids=["numbers", "several right answers"])
def test_what_is_read_is_what_was_built(place):
    problem = load_problem(place)
    cold, was_built = built(problem)
    assert was_built
    warm, was_built = built(problem)
    assert not was_built
    assert plain(warm) == plain(cold)
    # Hashes and texts also tell an int from a float, and the signs of zero apart.
    assert [hash_of(group) for group in warm.groups] == [hash_of(group) for group in cold.groups]
    assert [repr(group.cases) for group in warm.groups] == [repr(group.cases) for group in cold.groups]
    assert warm.notes == ()
    group = warm.groups[0]
    assert warm.exact(group.cases[0], group.group) == cold.exact(group.cases[0], group.group)


@pytest.mark.parametrize("name", ["problem.toml", "problem.py"])
def test_a_changed_file_builds_anew_and_drops_the_old_data(copy, folder, name):
    built(load_problem(copy))
    old = (folder / files(folder)[0]).read_bytes()
    with (copy / name).open("a") as file:
        file.write("\n")
    assert built(load_problem(copy))[1]
    (new,) = folder.iterdir()
    assert new.read_bytes() != old


def test_a_seed_and_a_folder_have_files_of_their_own(copy, folder):
    problem = load_problem(SOUND)
    assert built(problem, store=None)[1]
    assert not folder.exists()
    own = plain(built(problem)[0])
    assert built(problem, seed=5)[1]
    assert not built(problem, seed=5)[1]
    assert built(problem, seed=6)[1]
    assert plain(built(problem)[0]) == own
    assert built(load_problem(copy))[1]
    assert not built(problem)[1]
    assert len(files(folder)) == 3


def with_checksum(problem, body):
    """The file of this problem's data as the cache would write it, its checksum right."""
    key = kept_place("data", problem, None)[1].encode()
    return hashlib.blake2b(key + b"\n" + body, digest_size=32).hexdigest().encode() + b"\n" + body


@pytest.mark.parametrize(
    ("content", "checked"),
    [
        (b"", False),
        (b"\xff\x00" * 50, False),
        (b"not JSON", True),
        (b'{"examples": [[], []], "small": [[], []]}', True),
        (b'{"examples": [[[1], 2], [1, 1]], "small": [[[1],[1],[1],[1],[1]], [1,1,1,1,1]]}', True),
        (b"[" * 100_000, True),
    ],
)
def test_a_corrupt_file_is_built_anew(folder, content, checked):
    problem = load_problem(SOUND)
    sound = plain(built(problem)[0])
    (file,) = folder.iterdir()
    file.write_bytes(with_checksum(problem, content) if checked else content)
    data, was_built = built(problem)
    assert was_built
    assert plain(data) == sound
    assert data.notes == ()
    assert not built(problem)[1]


@pytest.mark.parametrize("place", [0, 70, None])
def test_one_flipped_byte_is_noticed_and_an_end_that_is_missing(folder, place):
    problem = load_problem(SOUND)
    built(problem)
    (file,) = folder.iterdir()
    content = bytearray(file.read_bytes())
    assert content == with_checksum(problem, content.partition(b"\n")[2])  # plain JSON below it
    if place is None:
        del content[-10:]
    else:
        content[place] ^= 1
    file.write_bytes(content)
    assert built(problem)[1]


def test_a_folder_that_cannot_be_written_costs_a_note_only(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "file"))
    data, was_built = built(load_problem(SOUND))
    assert was_built
    assert len(data.groups) == 2
    (note,) = data.notes
    assert "not kept for the next run" in note
    assert "set $JUDGE_CACHE to a writable folder" in note


@pytest.mark.slow
def test_many_writers_and_readers_at_once(folder):
    problem = load_problem(SOUND)
    sound = plain(built(problem, store=None)[0])
    seen, start = [], threading.Barrier(8)

    def work():
        start.wait(timeout=20)
        for _ in range(5):
            shutil.rmtree(folder, ignore_errors=True)
            data = load_data(problem)
            seen.append(plain(data) == sound)

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=60)
    assert seen == [True] * 40
    load_data(problem)
    assert len(files(folder)) == 1


@pytest.mark.slow
def test_a_warm_start_imports_nothing_of_the_exact_side(folder):
    program = (
        "import sys\n"
        "from judge.data.load import load_data\n"
        "from judge.problem.find import find_problem\n"
        "load_data(find_problem('crossings'))\n"
        "print(*sys.modules)"
    )
    run = [sys.executable, "-c", program]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    for expected in (True, False):
        done = subprocess.run(run, capture_output=True, text=True, env=environment, timeout=60, check=True)
        names = done.stdout.split()
        for heavy in ("judge.exact", "judge.data.build", "judge.problem.module", "judge.geometry"):
            assert (heavy in names) is expected, heavy
        assert any(name.startswith("judge_problem_crossings") for name in names) is expected
        assert not any(name.startswith(("rich", "hypothesis")) for name in names)


def test_numbers_come_back_from_the_cache_as_they_are(tmp_path):
    """Whatever parses the file: doubles of every size to the last bit, integers of any length, infinity."""
    draw = random.Random(1)
    doubles = [struct.unpack("d", draw.randbytes(8))[0] for _ in range(20_000)]
    near = [math.nextafter(10.0**power, 0.0) for power in range(-307, 309)]
    value = [x for x in doubles if math.isfinite(x)] + near + [5e-324, -0.0, 1.7976931348623157e308]
    integers = [draw.randint(-(10**digits), 10**digits) for digits in (5, 19, 20, 400, 4000)]
    for content in (value, integers, [math.inf, 1.5]):
        store = CacheFolder(lambda: tmp_path)
        assert store.write("data/numbers", "key", {"numbers": content}) is None
        assert repr(store.read("data/numbers", "key", dict)["numbers"]) == repr(content)


HOMES = [
    {},
    {"HOME": "relative"},
    {"HOME": "/home/ann", "XDG_CACHE_HOME": "/var/c", "XDG_DATA_HOME": "/var/d"},
    {"HOME": "/home/ann", "XDG_CACHE_HOME": "c", "XDG_DATA_HOME": "~/d"},
    {"XDG_CACHE_HOME": "/c", "XDG_DATA_HOME": "/d//e/"},
]


@pytest.mark.parametrize("home", HOMES, ids=str)
@pytest.mark.parametrize("system", [sys.platform, "darwin"])
def test_the_persons_folders_are_as_platformdirs_has_them(system, home, monkeypatch):
    for name in ("JUDGE_CACHE", "HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"):
        monkeypatch.delenv(name, raising=False)
    for name, value in home.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr("judge.files.sys.platform", system)
    assert cache_folder() == platformdirs.user_cache_path("circle-line-judge", appauthor=False)
    assert user_data() == platformdirs.user_data_path("circle-line-judge", appauthor=False)
