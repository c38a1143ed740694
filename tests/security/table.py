"""The attacks and what must come of each: one row a script in attacks/.

A script that tries something prints BREACH if it worked and `held` with the reason if it did not. A script
that is itself the attack (it sleeps, floods, crashes) is judged by how the box says it ended. `open_at`
names the levels that do not promise to contain it. `control` says how the same script shows, without
containment, that the attack works:

    breach   prints BREACH                      root    the same, but only as root
    runs     still runs after a while           maybe   the same, where this kernel has the thing switched on
    dies     is killed by a signal              hogs    uses more memory than the limit
    floods   prints more than the limit         ""      nothing to show: it ends the same either way
"""

from __future__ import annotations

from dataclasses import dataclass

from judge.sandbox.boundary import Stop


@dataclass(frozen=True)
class Attack:
    name: str
    ends: frozenset[Stop] = frozenset()  # of a script that is itself the attack
    open_at: frozenset[str] = frozenset({"limits"})
    control: str = "breach"


ALWAYS = frozenset[str]()
ONLY_FULL = frozenset({"strong", "limits"})


def _tries(
    *names: str, open_at: frozenset[str] = frozenset({"limits"}), control: str = "breach"
) -> list[Attack]:
    return [Attack(name, open_at=open_at, control=control) for name in names]


def _ends(name: str, *stops: Stop, control: str = "runs") -> Attack:
    return Attack(name, frozenset(stops), ALWAYS, control)


ATTACKS = [
    # reading
    *_tries("read_answers", "read_passwd", "read_home", "read_judge_environment", "read_judge_memory"),
    *_tries("read_judge_package", "import_judge", "list_answers", "list_judge_package", "list_root"),
    *_tries("readlink_answers", "change_folder"),
    *_tries("stat_answers", open_at=ONLY_FULL),  # landlock does not govern stat, and imports need it
    *_tries("read_own_environment", "search_memory", "inherited_descriptors", open_at=ALWAYS),
    # writing
    *_tries(
        "write_file", "write_tmp", "truncate_file", "chmod_file", "utime_file", "unlink_file", "rename_file"
    ),
    *_tries("symlink_file", "hardlink_file", "mkdir_folder"),
    *_tries("setxattr_file", control="maybe"),
    # talking
    *_tries("tcp_connect", "tcp_listen", "udp_send", "unix_connect", "unix_abstract", "unix_datagram_pair"),
    *_tries("netlink"),
    # other processes
    *_tries(
        "kill_process", "kill_judge", "kill_everybody", "kill_parent", "queue_signal", "limit_other_process"
    ),
    *_tries("ptrace_process", "read_process_memory", control="maybe"),
    *_tries("fork", "clone_process", "spawn", "exec", "outlive_the_judge"),
    *_tries("threads", open_at=ALWAYS),
    *_tries(
        "daemon", open_at=frozenset({"limits"}), control=""
    ),  # what becomes of it: test_nothing_outlives.py
    # the kernel's wider surface
    *_tries(
        "mount_tmpfs", "user_namespace", "io_uring", "userfault", "perf_event", "keyring", control="maybe"
    ),
    *_tries("bpf_map", control="root"),
    *_tries("memory_file", "sysv_shared_memory", "sysv_semaphore", "sysv_queue", "posix_shared_memory"),
    *_tries("posix_queue", control="maybe"),
    *_tries("scheduling", "affinity", "niceness"),
    *_tries("raise_limits", open_at=ALWAYS),
    # time
    _ends("sleeper", Stop.WALL),
    _ends("stopped", Stop.EXITED),
    _ends("exit_hook", Stop.WALL),
    _ends("other_thread_stays", Stop.WALL),
    _ends("deaf", Stop.CPU),
    _ends("busy_threads", Stop.CPU),
    _ends("patched_clocks", Stop.CPU),
    # memory and output
    _ends("hog_list", Stop.MEMORY, control="hogs"),
    _ends("hog_bytes", Stop.MEMORY, control="hogs"),
    _ends("hog_quiet", Stop.MEMORY, control="hogs"),
    _ends("flood_stdout", Stop.OUTPUT, control="floods"),
    _ends("flood_stderr", Stop.OUTPUT, control="floods"),
    _ends("flood_quietly", Stop.OUTPUT, control="floods"),
    # its own end
    _ends("crash", Stop.EXITED, control="dies"),
    _ends("recurse", Stop.EXITED, Stop.EXCEPTION, Stop.MEMORY, Stop.CPU, control=""),
    _ends("close_everything", Stop.ANSWERED, control=""),
]
