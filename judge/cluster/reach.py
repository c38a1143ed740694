"""Whether anybody listens at a scheduler's address, before anything of weight is begun."""

from __future__ import annotations

import socket

from judge.cluster.where import Address
from judge.errors import JudgeError

_REMEDY = "start it with 'judge worker --scheduler', or see whether a firewall is between"
_SECONDS = 5.0


def unreached(address: Address, seconds: float = _SECONDS) -> str:
    """Why nobody can be reached there; nothing where somebody can."""
    try:
        socket.create_connection((address.host, address.port), timeout=seconds).close()
    except (OSError, UnicodeError, OverflowError) as fault:  # a name of a host that is none
        strerror = fault.strerror if isinstance(fault, OSError) else None
        return (strerror or str(fault) or "no answer").lower()
    return ""


def check_reached(address: Address) -> None:
    """Raise JudgeError where nobody listens there."""
    reason = unreached(address)
    if reason:
        raise JudgeError(f"no scheduler can be reached at {address} ({reason})", remedy=_REMEDY)
