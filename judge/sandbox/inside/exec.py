"""The server of what is not Python: it starts compilers and what they make.

It watches them as the fork server watches its children: trusted code only, alone in its container with them.

    EXECUTE   payload (command line, environment, folder, limits by name): start it with the three descriptors
    COLLECT   payload (folder, bytes, files): copy the ordinary files below the folder to the second
              descriptor; the replies say their names and sizes, or why they were not copied

What was started has no descriptor of the region and none of the channel: a note there is the server's own.
"""

from __future__ import annotations

import _signal as signal  # type: ignore[import-not-found]
import marshal
import os
import stat
from itertools import islice

from judge.sandbox.inside import child, server, wire

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import CodeType
    from typing import Any, NoReturn

_DEFAULTS = (signal.SIGINT, signal.SIGPIPE, signal.SIGUSR1, signal.SIGXFSZ, signal.SIGCHLD)
_AS_IT_IS = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
_AT_ONCE = 1 << 20


class ExecServer(server.Server):
    """A server whose children become other programs."""

    def _run(self, job: wire.Request, code: CodeType | None) -> bytes:
        return self._collect(job) if job.kind == wire.COLLECT else super()._run(job, code)

    def _be_child(self, job: wire.Request, code: CodeType | None) -> NoReturn:  # noqa: ARG002
        try:
            signal.set_wakeup_fd(-1)
            for number in _DEFAULTS:
                signal.signal(number, signal.SIG_DFL)
            command, environment, folder, limits = marshal.loads(self._region.payload(job.payload))
            child.take_descriptors(*job.descriptors[:3], self._tally_end)
            os.chdir(folder)
            self._confinement.confine_program(limits)
            child.start_the_clock()
            os.execve(command[0], command, environment)
        except BaseException as error:
            self._region.write_fault(error)
            os._exit(99)

    def _ask_where(self, pid: int, reason: int) -> int:
        """The reason to kill it; nothing in it would say where it stands."""
        return self._after_a_look(pid, reason)

    def _collect(self, job: wire.Request) -> bytes:
        """Copy the files that a compiler has left, as many and as large as they may be."""
        folder, most, count = marshal.loads(self._region.payload(job.payload))
        try:
            answer: Any = [
                (os.path.relpath(path, folder), _copied(path, job.descriptors[1], most))
                for path in islice(_files(folder), count + 1)  # one over it tells that there are too many
            ]
            if sum(size for _, size in answer) > most or len(answer) > count:
                answer = "what was compiled is larger than allowed"
        except OSError as fault:
            raise server.Lacking(fault.errno, "") from None
        self._region.append(marshal.dumps(answer))
        return wire.done(stage=wire.CALLING)


def _files(folder: str) -> Iterator[str]:
    """The ordinary files below a folder, no link followed. Raises OSError for a folder that is closed."""

    def closed(fault: OSError) -> None:
        raise fault

    for base, folders, names in os.walk(folder, onerror=closed):
        folders.sort()
        for name in sorted(names):
            path = os.path.join(base, name)  # noqa: PTH118 - pathlib takes longer to import
            if stat.S_ISREG(os.lstat(path).st_mode):
                yield path


def _copied(path: str, into: int, most: int) -> int:
    """Append a file's bytes, at most one over `most`; how many there were."""
    descriptor = os.open(path, _AS_IT_IS)
    size = 0
    try:
        while size <= most and (part := os.read(descriptor, min(_AT_ONCE, most + 1 - size))):
            size += len(part)
            while part:
                part = part[os.write(into, part) :]
    finally:
        os.close(descriptor)
    return size
