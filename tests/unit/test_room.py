"""What is left of a machine's processes and descriptors, and how it is shared out."""

from __future__ import annotations

import resource

import pytest

from judge.errors import ShortageError
from judge.sandbox import room
from judge.sandbox.room import BASE_FILES, BASE_TASKS, OWN_FILES, OWN_TASKS, SLACK, THREADS, Room

PLENTY = 1 << 30


def a_room(tasks=PLENTY, files=PLENTY, ceiling=PLENTY):
    return Room(tasks, "tasks!", ceiling, files, "files!")


@pytest.mark.parametrize("jobs", [1, 2, 7, 256])
def test_what_is_done_at_once_has_room_together(jobs):
    plenty = a_room().share(jobs)
    assert a_room().at_once(jobs) == (jobs, "")
    assert (plenty.each, plenty.together, plenty.short) == (THREADS, jobs * THREADS + SLACK, False)
    enough = a_room(tasks=BASE_TASKS + jobs * (OWN_TASKS + THREADS))
    assert (enough.at_once(jobs), enough.share(jobs).each) == ((jobs, ""), THREADS)
    less = enough._replace(tasks=enough.tasks - 1)
    assert less.at_once(jobs) == (max(1, jobs - 1), "" if jobs == 1 else "tasks!")
    for left in range(0, 3000, 37):
        some = a_room(tasks=left)
        count, _ = some.at_once(jobs)
        share = some.share(count)
        used = BASE_TASKS + count * (OWN_TASKS + share.each)
        assert used <= left or (count, share.each) == (1, room.LEAST_THREADS)
        assert share.short is (share.each < THREADS)
        assert not share.short or count == 1


def test_the_scarcer_of_two_things_is_named():
    files = BASE_FILES + 3 * OWN_FILES
    assert a_room(files=files).at_once(9) == (3, "files!")
    assert a_room(files=files, tasks=BASE_TASKS + 2 * (OWN_TASKS + THREADS)).at_once(9) == (2, "tasks!")
    assert a_room(files=0).at_once(9) == (1, "files!")


def test_the_user_of_all_submissions_never_comes_to_the_limit():
    """Where the kernel counts them together, fork servers keep room to start a process."""
    share = a_room(tasks=400, ceiling=1000).share(2)
    assert share.ceiling == 1000 - BASE_TASKS - 2 * OWN_TASKS
    assert share.together <= 400 - BASE_TASKS - 2 * OWN_TASKS


@pytest.fixture
def groups(tmp_path, monkeypatch):
    """Control groups as a container shows them: a version, a path, and a bound on each level."""
    monkeypatch.setattr(room, "_CGROUPS", tmp_path)

    def make(row, **bounds):
        (tmp_path / "row").write_text(f"12:memory:/elsewhere\n{row}\n")
        for place, (most, now) in bounds.items():
            folder = tmp_path / place.replace("__", "/") if place != "top" else tmp_path
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "pids.max").write_text(f"{most}\n")
            (folder / "pids.current").write_text(f"{now}\n")
        real = room.Path

        def path(name):
            return tmp_path / "row" if name == "/proc/self/cgroup" else real(name)

        monkeypatch.setattr(room, "Path", path)
        return [(most, left) for most, left, _ in room._pids()]

    return make


@pytest.mark.parametrize(
    ("row", "bounds", "found"),
    [
        (
            "0::/user/mine",
            {"user__mine": (100, 40), "user": ("max", 50), "top": (300, 10)},
            [(100, 60), (300, 290)],
        ),
        ("8:pids:/docker/abc", {"pids__docker__abc": (64, 4)}, [(64, 60)]),  # an older version
        ("8:pids:/docker/abc", {"pids": (64, 4)}, [(64, 60)]),  # a path that the container does not show
        ("0::/mine", {"mine": ("max", 3), "top": ("what", "ever")}, []),
    ],
)
def test_the_bounds_of_control_groups_of_either_version(groups, row, bounds, found):
    assert groups(row, **bounds) == found


def test_memory_that_may_not_be_had_is_a_shortage():
    soft, hard = resource.getrlimit(resource.RLIMIT_DATA)
    try:
        resource.setrlimit(resource.RLIMIT_DATA, (4 << 30, hard))
        room.check_memory(4 << 30)
        with pytest.raises(ShortageError, match=r"4097 MB of address space, and 4096 MB are allowed; raise"):
            room.check_memory((4 << 30) + (1 << 20))
    finally:
        resource.setrlimit(resource.RLIMIT_DATA, (soft, hard))


def test_own_tasks_are_counted_with_their_threads():
    assert 1 <= room.tasks_of_mine() <= room.tasks_of_mine(hidden=True)
    found = room.measure()
    assert found.files > 0
    assert found.tasks > 0
