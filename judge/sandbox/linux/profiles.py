"""What runs in a container, and which system calls of `judge.sandbox.linux.syscalls` that needs.

    PYTHON     a submission in the fork server's own interpreter
    RUN        a compiled program, or another language's interpreter: one `execve`, and threads
    COMPILE    a compiler: processes of its own, and files in the one folder that it may fill

No profile has a network, another session or another group of processes, so that a kill of the group ends all.
"""

from __future__ import annotations

from judge.sandbox.linux import syscalls as calls

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Final


class Profile:
    """One kind of containment.

    `server` and `child` say whose calls the server and its children may make. `alone` says that a child
    starts no process, `counted` that it gets no memory that its limit does not count.
    """

    __slots__ = ("alone", "child", "counted", "name", "server")

    def __init__(
        self,
        name: str,
        server: tuple[int, ...] = (),
        child: tuple[int, ...] = (),
        *,
        alone: bool = True,
        counted: bool = False,
    ) -> None:
        self.name = name
        self.server = (calls.ALL, calls.LOOKED, calls.SERVER, calls.PARENTS, *server)
        self.child = (calls.ALL, calls.LOOKED, *child)
        self.alone = alone
        self.counted = counted


_STARTED = (calls.START, calls.STARTER, calls.HELPER)

PYTHON: Final = Profile("python")
RUN: Final = Profile("run", _STARTED, (calls.START,), counted=True)
COMPILE: Final = Profile(
    "compile",
    (*_STARTED, calls.FILL, calls.COMPILE),
    (calls.PARENTS, calls.START, calls.HELPER, calls.FILL, calls.COMPILE),
    alone=False,
)

BY_NAME: Final = {each.name: each for each in (PYTHON, RUN, COMPILE)}
