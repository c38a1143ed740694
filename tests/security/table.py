"""The attacks and what must come of each.

A deed is what a script tries: it prints BREACH where that is done, and `held` with the reason where it is
refused. A script that is itself the attack (it sleeps, floods, crashes) is judged by how the box says it
ended. `open_at` names the levels that do not promise to contain it. `control` says how the same script shows,
without containment, that the attack works:

    breach   prints BREACH                      root    the same, but only as root
    runs     still runs after a while           maybe   the same, where this kernel has the thing switched on
    dies     is killed by a signal              hogs    uses more memory than the limit
    floods   prints more than the limit         ""      nothing to show: it ends the same either way
"""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass

from judge.sandbox.boundary import Stop


@dataclass(frozen=True)
class Attack:
    name: str
    script: str
    ends: frozenset[Stop] = frozenset()  # of a script that is itself the attack
    open_at: frozenset[str] = frozenset({"limits"})
    control: str = "breach"


ALWAYS = frozenset[str]()
ONLY_FULL = frozenset({"strong", "limits"})
MODULES = r"\b(ctypes|fcntl|gc|re|resource|socket|subprocess|threading)\."
TRIED = """
import json, os, sys{modules}
target = json.load(sys.stdin)
def libc(function, *arguments):
    result = getattr(ctypes.CDLL(None, use_errno=True), function)(*arguments)
    if result < 0:
        raise OSError(ctypes.get_errno(), function)
    return result
def system_call(intel, arm, *arguments):
    return libc("syscall", intel if os.uname().machine == "x86_64" else arm, *arguments)
def inside(name):
    return os.path.join(target["folder"], name)
def home(name):  # in the folder that it has for its own; without containment it has none
    return os.path.join(os.environ.get("MPLCONFIGDIR", target["folder"]), name)
def deed():
{deed}
try:
    deed()
    print("BREACH")
except (OSError, ImportError, MemoryError, RuntimeError, ValueError) as error:
    print("held", error)
"""


def _tries(
    deeds: dict[str, str], *, open_at: frozenset[str] = frozenset({"limits"}), control: str = "breach"
) -> list[Attack]:
    return [Attack(name, tried(deed), open_at=open_at, control=control) for name, deed in deeds.items()]


def tried(deed: str) -> str:
    modules = "".join(f", {name}" for name in sorted({*re.findall(MODULES, deed)} | _of_libc(deed)))
    return TRIED.format(modules=modules, deed=textwrap.indent(textwrap.dedent(deed), "    "))


def _of_libc(deed: str) -> set[str]:
    return {"ctypes"} if "libc(" in deed or "system_call(" in deed else set()


def _ends(name: str, script: str, *stops: Stop, control: str = "runs") -> Attack:
    return Attack(name, textwrap.dedent(script), frozenset(stops), ALWAYS, control)


READING = {
    "read_answers": "open(target['secret']).read()",
    "read_passwd": "open('/etc/passwd').read()",
    "read_home": "open(target['home_file']).read()",
    "read_judge_environment": "open(f'/proc/{target[\"judge_pid\"]}/environ', 'rb').read()",
    "read_judge_memory": "open(f'/proc/{target[\"judge_pid\"]}/maps').read()",
    "read_judge_package": "open(target['judge_file']).read()",
    "import_judge": "sys.path.append(target['judge_parent'])\nimport judge",
    "list_answers": "os.listdir(target['folder'])",
    "list_judge_package": "os.listdir(target['judge_folder'])",
    "list_root": "if len(os.listdir('/etc')) < 4: raise OSError('little is shown')",
    "readlink_answers": "os.readlink(target['link'])",
    "change_folder": "os.chdir(target['folder'])",
}
EXISTENCE = {  # which landlock does not govern, and imports need: here nothing but what is mounted counts
    "stat_answers": "os.stat(target['secret'])",
    "stat_passwd": "os.stat('/etc/passwd')",
}
OWN = {
    "read_own_environment": "if 'JUDGE_TEST_SECRET' not in os.environ: raise OSError('nothing is there')",
    "inherited_descriptors": """
        for number in [3, *range(5, 1024)]:  # 4 is its own source
            try:
                fcntl.fcntl(number, fcntl.F_GETFD)
                return
            except OSError:
                continue
        raise OSError("none is open")
        """,
    "search_memory": """
        pattern = re.compile("EXPECTED" + "-[0-9a-f]{8}")
        seen, waiting, frame = set(), gc.get_objects(), sys._getframe()
        while frame:
            waiting += [frame, frame.f_locals, frame.f_globals]
            frame = frame.f_back
        while waiting and len(seen) < 400_000:
            item = waiting.pop()
            if id(item) not in seen:
                seen.add(id(item))
                if isinstance(item, bytes):
                    item = item.decode("latin-1")
                if not isinstance(item, str):
                    waiting += gc.get_referents(item)
                elif pattern.search(item):
                    return
        raise OSError("nothing is found")
        """,
    "threads": """
        release = threading.Event()
        threading.stack_size(64 * 1024)
        try:
            for _ in range(300):
                threading.Thread(target=release.wait, daemon=True).start()
        finally:
            release.set()
        """,
    "raise_limits": """
        for limit in (resource.RLIMIT_AS, resource.RLIMIT_FSIZE):
            resource.setrlimit(limit, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        """,
}
OWN_SOURCE = {  # which a plain interpreter has under no descriptor
    "change_own_source": "os.pwrite(4, b'#', 0)",
    "grow_own_source": "os.ftruncate(4, 1 << 20)",
    "change_own_source_by_name": "open(__file__, 'r+b', buffering=0).write(b'#')",
}
OF_THE_JUDGE = {  # whose memory it shares: at `limits` a plain user's submission has the rights of that user
    "shrink_shared_memory": """
        folder = f"/proc/{target['judge_pid']}/fd"
        shared = [f"{folder}/{name}" for name in os.listdir(folder)]
        largest = max((path for path in shared if "memfd:judge" in os.readlink(path)), key=os.path.getsize)
        if os.path.getsize(largest) < 1 << 24: raise OSError("none is large enough")
        os.truncate(largest, 0)
        """,
}
WRITING = {
    "write_file": "open(inside('new.txt'), 'w').write('x')",
    "write_tmp": "path = f'/tmp/judge-attack-{os.getpid()}'\nopen(path, 'w').close()\nos.unlink(path)",
    "truncate_file": "os.truncate(target['victim'], 0)",
    "chmod_file": "os.chmod(target['victim'], 0o600)",
    "utime_file": "os.utime(target['victim'], (1, 1))",
    "unlink_file": "os.unlink(target['victim'])",
    "rename_file": "os.rename(target['victim'], target['victim'] + '.moved')",
    "symlink_file": "os.symlink('/etc/passwd', inside('made-link'))",
    "hardlink_file": "os.link(target['victim'], inside('made-hard-link'))",
    "mkdir_folder": "os.mkdir(inside('made-folder'))",
}
AT_HOME = {
    "home_file": "open(home('new.txt'), 'w').write('x')",
    "home_nameless_file": "os.open(home(''), os.O_TMPFILE | os.O_RDWR)",
    "home_fill": "for n in range(2048): open(home(f'new-{n}'), 'w').write('x' * (1 << 13))",
    "home_folders": "for n in range(2048): os.mkdir(home(f'new-{n}'))",
    "home_symlink": "os.symlink('/etc/passwd', home('made-link'))",
    "home_hardlink": "os.link(target['victim'], home('made-hard-link'))",
    "home_pipe": "os.mkfifo(home('made-pipe'))",
    "home_chmod": "os.chmod(home('.'), 0o777)",
    "home_program": """
        with open(os.open(home("new-program"), os.O_CREAT | os.O_WRONLY, 0o700), "w") as file:
            file.write("#!/bin/sh\\necho BREACH")
        os.execv(home("new-program"), ["new-program"])
        """,
}
TALKING = {
    "tcp_connect": "socket.create_connection(('127.0.0.1', target['port']), 1).close()",
    "tcp_listen": "socket.create_server(('127.0.0.1', 0)).close()",
    "udp_send": "socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b'x', ('127.0.0.1', 9))",
    "unix_connect": "socket.socket(socket.AF_UNIX).connect(target['unix_stream'])",
    "unix_abstract": "socket.socket(socket.AF_UNIX).connect('\\0' + target['unix_abstract'])",
    "unix_datagram_pair": """
        pair = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
        pair[0].sendto(b"x", target["unix_datagram"])
        """,
    "unix_datagram_message": """
        pair = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
        pair[0].sendmsg([b"x"], (), 0, target["unix_datagram"])
        """,
    "netlink": "socket.socket(socket.AF_NETLINK, socket.SOCK_RAW, 0).close()",
}
PROCESSES = {
    "kill_process": "os.kill(target['victim_pid'], 15)",
    "kill_judge": "os.kill(target['judge_pid'], 0)",
    "kill_everybody": "os.kill(-1, 0)",
    "kill_parent": "os.kill(os.getppid(), 0)",
    "queue_signal": """
        information = (ctypes.c_int * 32)(10, 0, -1)
        system_call(129, 138, target["victim_pid"], 0, information)
        """,
    "limit_other_process": "resource.prlimit(target['victim_pid'], resource.RLIMIT_NOFILE, (64, 64))",
    "fork": "child = os.fork()\nif child == 0: os._exit(0)\nos.waitpid(child, 0)",
    "clone_process": """
        child = system_call(56, 220, ctypes.c_ulong(17), None, None, None, ctypes.c_ulong(0))
        if child == 0:
            os._exit(0)
        os.waitpid(child, 0)
        """,
    "spawn": "subprocess.run(['/bin/echo'], check=True, stdout=subprocess.DEVNULL)",
    "exec": "os.execv('/bin/echo', ['echo', 'BREACH'])",
    "outlive_the_judge": "libc('prctl', 1, 0, 0, 0, 0)",  # give up the signal that ends it with the judge
}
READ_MEMORY = """
        buffer = ctypes.create_string_buffer(b"unharmed")
        local = (ctypes.c_size_t * 2)(ctypes.addressof(buffer), 8)
        remote = (ctypes.c_size_t * 2)({address}, 8)
        libc("process_vm_readv", {pid}, local, 1, remote, 1, ctypes.c_ulong(0))
        """
MEMORY = {
    "ptrace_process": """
        libc("ptrace", 16, target["victim_pid"], None, None)
        os.waitpid(target["victim_pid"], 0x40000000)
        libc("ptrace", 17, target["victim_pid"], None, None)
        """,
    "read_process_memory": READ_MEMORY.format(pid="target['victim_pid']", address="target['victim_address']"),
    # Nobody is harmed by these two; nothing but the filter of system calls refuses them.
    "trace_itself": "libc('ptrace', 0, 0, None, None)",
    "read_its_own_memory": READ_MEMORY.format(pid="os.getpid()", address="ctypes.addressof(buffer)"),
}
DAEMON = """
import json, os, signal, sys, time
target = json.load(sys.stdin)
try:
    child = os.fork()
except OSError as error:
    print("held", error)
else:
    if child == 0:
        os.setsid()
        if os.fork():
            os._exit(0)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        for _ in range(60):
            with open(os.path.join(target["folder"], "heartbeat"), "a") as file:
                file.write("x")
            time.sleep(0.05)
        os._exit(0)
    os.waitpid(child, 0)
    time.sleep(0.2)
    print("started")
"""
KERNEL = {
    "mount_tmpfs": """
        new_user, new_namespace, private = 0x10000000, 0x20000, 0x44000
        try:
            libc("unshare", new_user | new_namespace)
        except OSError:
            libc("unshare", new_namespace)  # of its own, so that nobody else sees what is mounted
        libc("mount", b"none", b"/", None, ctypes.c_ulong(private), None)
        libc("mount", b"none", target["folder"].encode(), b"tmpfs", ctypes.c_ulong(0), None)
        """,
    "user_namespace": "libc('unshare', 0x10000000)",
    "io_uring": "system_call(425, 425, 1, (ctypes.c_char * 120)())",
    "userfault": "system_call(323, 282, 1)",
    "perf_event": """
        attributes = (ctypes.c_uint32 * 32)(1, 128)
        attributes[10] = 0b1100000
        system_call(298, 241, attributes, 0, -1, -1, ctypes.c_ulong(0))
        """,
    "keyring": "system_call(248, 217, b'user', b'judge', b'x', ctypes.c_size_t(1), -2)",
    "posix_queue": """
        name = f"/judge-{os.getpid()}".encode()
        libc("mq_open", name, 0o102, 0o600, None)
        libc("mq_unlink", name)
        """,
}
SHARED = {
    "memory_file": "libc('memfd_create', b'x', 0)",
    "sysv_shared_memory": "libc('shmctl', libc('shmget', 0, 4096, 0o1600), 0, None)",
    "sysv_semaphore": "libc('semctl', libc('semget', 0, 1, 0o1600), 0, 0)",
    "sysv_queue": "libc('msgctl', libc('msgget', 0, 0o1600), 0, None)",
    "posix_shared_memory": """
        name = f"/judge-{os.getpid()}".encode()
        libc("shm_open", name, 0o102, 0o600)
        libc("shm_unlink", name)
        """,
    "scheduling": "os.sched_setscheduler(0, os.SCHED_BATCH, os.sched_param(0))",
    "affinity": "os.sched_setaffinity(0, os.sched_getaffinity(0))",
    "niceness": "os.setpriority(os.PRIO_PROCESS, 0, 5)",
}

ATTACKS = [
    *_tries(READING),
    *_tries(EXISTENCE, open_at=ONLY_FULL),
    *_tries(OWN, open_at=ALWAYS),
    *_tries(OWN_SOURCE, open_at=ALWAYS, control=""),
    *_tries(OF_THE_JUDGE, open_at=ALWAYS, control=""),
    *_tries({"be_root": "if os.getuid(): raise OSError('a plain user')"}, open_at=ALWAYS, control="root"),
    *_tries(WRITING),
    *_tries(AT_HOME),
    *_tries({"setxattr_file": "os.setxattr(target['victim'], 'user.judge', b'x')"}, control="maybe"),
    *_tries(TALKING),
    *_tries(PROCESSES),
    *_tries(MEMORY, control="maybe"),
    Attack("daemon", DAEMON, control=""),  # what becomes of it: test_nothing_outlives.py
    *_tries(KERNEL, control="maybe"),
    *_tries({"bpf_map": "system_call(321, 280, 0, (ctypes.c_uint32 * 32)(2, 4, 4, 1), 128)"}, control="root"),
    *_tries(SHARED),
    # time
    _ends("sleeper", "import time\ntime.sleep(60)", Stop.WALL),
    _ends("stopped", "import os, signal\nos.kill(os.getpid(), signal.SIGSTOP)", Stop.EXITED),
    _ends("exit_hook", "import atexit, time\natexit.register(time.sleep, 60)", Stop.WALL),
    _ends(
        "other_thread_stays",
        "import threading, time\nthreading.Thread(target=time.sleep, args=(60,)).start()",
        Stop.WALL,
    ),
    _ends(
        "deaf",
        """
        import signal
        for number in {*range(1, 32)} - {signal.SIGKILL, signal.SIGSTOP}:
            signal.signal(number, signal.SIG_IGN)
        while True:
            pass
        """,
        Stop.CPU,
    ),
    _ends(
        "busy_threads",
        """
        import threading
        def work():
            while True:
                hash(b"x" * 1000)
        for _ in range(4):
            threading.Thread(target=work).start()
        """,
        Stop.CPU,
    ),
    _ends(
        "patched_clocks",
        """
        import builtins, time
        for name in ("time", "perf_counter", "process_time", "thread_time", "monotonic", "clock_gettime_ns"):
            setattr(time, name, lambda *_: 0)
        builtins.len = lambda _: 0
        while True:
            pass
        """,
        Stop.CPU,
    ),
    # memory and output
    _ends("hog_list", "rows = []\nwhile True: rows.append([0] * 100_000)", Stop.MEMORY, control="hogs"),
    _ends(
        "hog_bytes",
        "rows = []\nwhile True: rows.append(bytearray(b'x') * (8 << 20))",
        Stop.MEMORY,
        control="hogs",
    ),
    _ends("hog_quiet", "row = bytearray(b'x') * (320 << 20)\ndel row\nprint(1)", Stop.MEMORY, control="hogs"),
    _ends("flood_stdout", "while True: print('x' * 65536, end='')", Stop.OUTPUT, control="floods"),
    _ends(
        "flood_stderr", "import sys\nwhile True: sys.stderr.write('x' * 65536)", Stop.OUTPUT, control="floods"
    ),
    _ends(
        "flood_quietly",
        "import os\ntry:\n    while True: os.write(1, b'x' * 65536)\nexcept OSError: os._exit(0)",
        Stop.OUTPUT,
        control="floods",
    ),
    # its own end
    _ends("crash", "import ctypes\nctypes.string_at(0)", Stop.EXITED, control="dies"),
    _ends(
        "recurse",
        """
        import sys
        sys.setrecursionlimit(10**9)
        class Loop:
            def __repr__(self):
                return repr(self)
        repr(Loop())
        """,
        *(Stop.EXITED, Stop.EXCEPTION, Stop.MEMORY, Stop.CPU),
        control="",
    ),
    _ends("close_everything", "import os\nos.closerange(0, 1024)\nos._exit(0)", Stop.ANSWERED, control=""),
]
SCRIPTS = {attack.name: attack.script for attack in ATTACKS}
