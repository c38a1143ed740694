"""The one place that imports dask.distributed, late, and says in a line where it is missing."""

from __future__ import annotations

import logging
from importlib import import_module
from typing import Any

from judge.errors import UsageError

INSTALL = "pip install 'circle-line-judge[cluster]'"
_SETTINGS = {
    # Plain HTTP would tell anybody who asks how busy a machine is, and the scheduler's can be a proxy: there
    # is no server for it (quiet.py), and nothing that it would serve.
    "distributed.scheduler.http.routes": [],
    "distributed.worker.http.routes": [],
    "distributed.scheduler.allowed-failures": 0,  # the executor counts deaths itself
    "distributed.worker.profile.enabled": False,
    # A submission's memory is bounded by its box; the judge's own is small.
    "distributed.worker.memory.target": False,
    "distributed.worker.memory.spill": False,
    "distributed.worker.memory.pause": False,
    "distributed.worker.memory.terminate": False,
    "distributed.comm.timeouts.connect": "10s",
}
_TALKATIVE = (
    "distributed",
    "distributed.client",
    "distributed.worker",
    "distributed.scheduler",
    "distributed.nanny",
)


def distributed() -> Any:
    """The module `distributed`, set up and silent. Raises UsageError where it is not installed."""
    module = _needed("distributed")
    import dask

    dask.config.set(_SETTINGS)
    for name in (
        *_TALKATIVE,
        "tornado",
        "asyncio",
    ):  # what a person must know is said by the judge, in a line
        logging.getLogger(name).setLevel(logging.CRITICAL)
    return module


def x509() -> Any:
    """The module `cryptography.x509`. Raises UsageError where it is not installed."""
    return _needed("cryptography.x509")


def _needed(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError as fault:
        package = name.partition(".")[0]
        what = f"judging on other machines needs the package {package}, which is not installed"
        raise UsageError(what, remedy=INSTALL) from fault
