"""What runs in a container, and which system calls that needs beyond the allow-list of all of them.

    PYTHON     a submission in the fork server's own interpreter
    RUN        a compiled program, or another language's interpreter: one `execve`, and threads
    COMPILE    a compiler: processes of its own, and files in the one folder that it may fill

No profile has a network, another session or another group of processes, so that a kill of the group ends all.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Final


class Profile:
    """One kind of containment.

    `more` are the calls it needs beyond the allow-list, `not_in_a_child` those that only the server keeps.
    `alone` says that a child starts no process, `counted` that it gets no memory that its limit does not
    count, `descriptors` how many it may have.
    """

    __slots__ = ("alone", "counted", "descriptors", "more", "name", "not_in_a_child")

    def __init__(
        self,
        name: str,
        more: str = "",
        not_in_a_child: str = "",
        *,
        alone: bool = True,
        counted: bool = False,
        descriptors: int = 64,
    ) -> None:
        self.name = name
        self.more = more
        self.alone = alone
        self.counted = counted
        self.descriptors = descriptors
        self.not_in_a_child = not_in_a_child


_STARTING = "execve arch_prctl readlink readlinkat setpgid chdir"
_FILES = """
    mkdir mkdirat unlink unlinkat rename renameat renameat2 rmdir chmod fchmod fchmodat utimensat flock
    fallocate statfs fstatfs link linkat symlink truncate fchdir memfd_create
"""

PYTHON: Final = Profile("python")
RUN: Final = Profile("run", _STARTING, "setpgid chdir", counted=True)
COMPILE: Final = Profile("compile", _STARTING + _FILES, "setpgid", alone=False, descriptors=512)

BY_NAME: Final = {each.name: each for each in (PYTHON, RUN, COMPILE)}
