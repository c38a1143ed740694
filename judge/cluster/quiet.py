"""The scheduler and the workers of dask.distributed without their web servers.

With no dashboard and no page to serve they would still listen for HTTP, on a port of this machine that asks
nobody who they are.
"""

from __future__ import annotations

from distributed import Scheduler, Worker


class QuietScheduler(Scheduler):
    """A scheduler that listens for nobody but its clients and workers."""

    def start_http_server(self, *_: object, **__: object) -> None:
        """Serve nothing."""


class QuietWorker(Worker):
    """A worker that listens for nobody but the scheduler and the other workers."""

    def start_http_server(self, *_: object, **__: object) -> None:
        """Serve nothing."""
