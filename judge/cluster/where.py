"""What `--on` and `judge worker` name: the address of a scheduler, or machines on which to start workers."""

from __future__ import annotations

import ipaddress
import re
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError

PORT = 8786
HERE = f"tcp://127.0.0.1:{PORT}"
FORMS = "tcp://127.0.0.1:PORT, tls://HOST:PORT, ssh:HOSTS.txt, slurm or slurm:FILE.toml"
_ADDRESS = re.compile(
    r"(?P<scheme>[a-z]+)://(?P<host>\[[0-9A-Fa-f:.]+\]|[^\s:/\[\]]+)(:(?P<port>[0-9]{1,5}))?/?"
)
_MOST = 65535
_SHELL = "whoever reaches a scheduler can run any program on every machine of the cluster"


class Address(Struct, frozen=True):
    """A scheduler's; `port` 0 is any that is free, for one that is to be started."""

    scheme: str
    host: str
    port: int = PORT

    @classmethod
    def of(cls, text: str) -> Address:
        """Read `tcp://HOST:PORT` or `tls://HOST:PORT`.

        Raises:
            UsageError: it is no such address, or plain tcp to another machine.
        """
        found = _ADDRESS.fullmatch(text)
        if found is None or found["scheme"] not in ("tcp", "tls") or int(found["port"] or 0) > _MOST:
            raise UsageError(f"'{text}' is no address of a scheduler", remedy="give tls://HOST:PORT")
        port = PORT if found["port"] is None else int(found["port"])
        address = cls(found["scheme"], found["host"].strip("[]"), port)
        if address.scheme == "tcp" and not address.is_here:
            remedy = "make keys with 'judge worker --new-keys DIR' and give tls:// in place of tcp://"
            raise UsageError(
                f"{text} is refused: {_SHELL}, and plain tcp asks nobody who they are", remedy=remedy
            )
        return address

    @property
    def is_here(self) -> bool:
        """Whether it can be reached from this machine only."""
        if self.host == "localhost":
            return True
        try:
            return ipaddress.ip_address(self.host).is_loopback
        except ValueError:
            return False

    @property
    def safe(self) -> bool:
        """Whether certificates are asked for."""
        return self.scheme == "tls"

    def __str__(self) -> str:
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"{self.scheme}://{host}:{self.port}"


class Machines(Struct, frozen=True):
    """Machines on which workers are to be started: by `ssh` those of a file, by `slurm` as a file says."""

    by: str
    file: Path | None = None


def read_where(text: str) -> Address | Machines:
    """What `--on` names. Raises UsageError for anything else."""
    by, colon, rest = text.partition(":")
    if by == "slurm" and bool(colon) == bool(rest):
        return Machines("slurm", Path(rest) if rest else None)
    if by == "ssh" and rest and not rest.startswith("//"):
        return Machines("ssh", Path(rest))
    if by in ("tcp", "tls"):
        return Address.of(text)
    raise UsageError(f"--on does not know '{text}'", remedy=f"give {FORMS}")
