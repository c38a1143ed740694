"""Harmless attacks of a submission: what each tries, and how it is told that it was held.

They are harmless wherever they succeed: they change only what is made for them, signal with 0 or to go on,
start eight processes that end at once, and take 256 MB, 8 MB of disk, 4 MB of output and 3 seconds at most.

A body tries something, and raises where it is refused. `target` is what `attacking.targets` has made.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from judge.sandbox.boundary import Stop

BREACH, HELD = "BREACH", "held"
_FRAME = """\
import json, os, sys
target = json.load(sys.stdin)
try:
{body}
except Exception as error:
    print("held", type(error).__name__, error)
else:
    print("BREACH")
"""
_LIBC = "import ctypes; libc = ctypes.CDLL(None, use_errno=True)\n"


class Attack(NamedTuple):
    """One of them; one that a limit is to end is held where the box says that one of these did."""

    name: str
    tries: str  # to …
    body: str
    ends: tuple[Stop, ...] = ()

    @property
    def source(self) -> bytes:
        """The submission."""
        lines = self.body.strip("\n").splitlines()
        return _FRAME.format(body="\n".join(f"    {line}" for line in lines)).encode()


@dataclass(frozen=True)
class Attacked:
    """What came of one attack: whether it was held, and how in words, as the kernel or the box said it."""

    name: str
    tries: str
    held: bool
    how: str


ATTACKS = (
    Attack("judge", "read the judge's files", 'open(target["judge_file"], "rb").read(1)'),
    Attack(
        "solutions",
        "list the problems and their solutions",
        """
found = []
for folder in target["packs"]:
    try:
        found += os.listdir(folder)
    except OSError:
        continue
assert found, "nothing can be listed"
""",
    ),
    Attack("file", "read a file that you alone may read", 'open(target["private"]).read()'),
    Attack("link", "read that file by a link to it", 'open(target["link"]).read()'),
    Attack("folder", "list a folder that everybody may list", 'assert os.listdir(target["folder"])'),
    Attack("users", "read who has an account here", 'open("/etc/passwd").read()'),
    Attack("write", "write into a folder that everybody may write to", 'open(target["new"], "w").close()'),
    Attack("symlink", "make a symbolic link there", 'os.symlink("/etc/passwd", target["new"] + ".link")'),
    Attack(
        "hard-link", "make a second name of a file there", 'os.link(target["open"], target["new"] + ".hard")'
    ),
    Attack(
        "rename",
        "rename a file there",
        """
os.rename(target["open"], target["new"] + ".name")
os.rename(target["new"] + ".name", target["open"])
""",
    ),
    Attack("chmod", "change the rights of a file there", 'os.chmod(target["open"], 0o666)'),
    Attack(
        "disk",
        "write 8 MB to the disk, wherever that goes",
        """
own = os.environ.get("TMPDIR", "/tmp")
for folder in (os.getcwd(), own, "/tmp", "/var/tmp", "/dev/shm", target["folder"]):
    path = os.path.join(folder, target["name"])
    try:
        with open(path, "wb") as file:
            file.write(bytes(8 << 20))
        os.unlink(path)
        break
    except OSError as fault:
        refused = fault
else:
    raise refused
""",
    ),
    Attack(
        "connect",
        "connect to a server on this machine",
        'import socket\nsocket.create_connection(("127.0.0.1", target["port"]), 2).close()',
    ),
    Attack(
        "listen",
        "be a server on this machine",
        'import socket\nwith socket.socket() as line:\n    line.bind(("127.0.0.1", 0))\n    line.listen()',
    ),
    Attack(
        "datagram",
        "send a datagram",
        """
import socket
socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b"x", ("127.0.0.1", target["port"]))
""",
    ),
    Attack(
        "unix-socket",
        "connect to a socket in the file system",
        'import socket\nsocket.socket(socket.AF_UNIX).connect(target["socket"])',
    ),
    Attack(
        "fork",
        "start eight processes",
        """
for _ in range(8):
    child = os.fork()
    if child == 0:
        os._exit(0)
    os.waitpid(child, 0)
""",
    ),
    Attack("exec", "become another program", 'sys.stdout.flush()\nos.execv("/bin/echo", ["echo", "BREACH"])'),
    Attack(
        "kill", "signal another process of yours", 'import signal\nos.kill(target["victim"], signal.SIGCONT)'
    ),
    Attack("kill-judge", "signal the judge", 'os.kill(target["judge"], 0)'),
    Attack("kill-parent", "signal the process that watches it", "os.kill(os.getppid(), 0)"),
    Attack("kill-all", "signal every process that it may", "os.kill(-1, 0)"),
    Attack(
        "trace",
        "trace another process of yours",
        _LIBC
        + """
assert libc.ptrace(16, target["victim"], None, None) == 0, os.strerror(ctypes.get_errno())
os.waitpid(target["victim"], 0x40000000)
libc.ptrace(17, target["victim"], None, None)
""",
    ),
    Attack(
        "memory-of-others",
        "read the memory of another process of yours",
        _LIBC
        + """
here = ctypes.create_string_buffer(8)
own = (ctypes.c_size_t * 2)(ctypes.addressof(here), 8)
theirs = (ctypes.c_size_t * 2)(target["address"], 8)
assert libc.process_vm_readv(target["victim"], own, 1, theirs, 1, ctypes.c_ulong(0)) > 0, (
    os.strerror(ctypes.get_errno())
)
""",
    ),
    Attack(
        "proc",
        "read the judge's environment in /proc",
        'open(f"/proc/{target[\'judge\']}/environ", "rb").read(1)',
    ),
    Attack(
        "environment",
        "find the judge's variables in its own",
        'assert set(os.environ.items()) & set(target["environment"].items()), "there are none"',
    ),
    Attack(
        "descriptors",
        "find files that somebody left open",
        """
import fcntl
for number in (3, *range(5, 1024)):  # 4 is its own source
    try:
        fcntl.fcntl(number, fcntl.F_GETFD)
        break
    except OSError as fault:
        refused = fault
else:
    raise refused
""",
    ),
    Attack(
        "limits",
        "raise its own limits",
        """
import resource
for name in ("RLIMIT_AS", "RLIMIT_FSIZE"):
    resource.setrlimit(getattr(resource, name), (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
""",
    ),
    Attack(
        "namespace",
        "make a user namespace",
        _LIBC + "assert libc.unshare(0x10000000) == 0, os.strerror(ctypes.get_errno())",
    ),
    Attack(
        "shared-memory",
        "make memory that outlives it",
        _LIBC
        + """
made = libc.shmget(0, 4096, 0o1600)
assert made >= 0, os.strerror(ctypes.get_errno())
libc.shmctl(made, 0, None)
""",
    ),
    Attack(
        "memory",
        "take more memory than it may",
        "kept = [b'x' * (16 << 20) for _ in range(16)]",
        (Stop.MEMORY,),
    ),
    Attack(
        "output",
        "print more than it may",
        "for _ in range(64):\n    sys.stdout.write('x' * (1 << 16))\nsys.stdout.flush()",
        (Stop.OUTPUT,),
    ),
    Attack(
        "loop",
        "work for longer than it may",
        "import time\nwhile time.process_time() < 3:\n    pass",
        (Stop.CPU, Stop.WALL),
    ),
    Attack("sleep", "wait for longer than it may", "import time\ntime.sleep(3)", (Stop.WALL,)),
)
