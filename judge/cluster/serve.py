"""The processes of `judge worker`: a scheduler, and workers that come back when it does."""

from __future__ import annotations

import asyncio
import logging
import os
import signal
import sys
import threading
from collections.abc import Callable, Mapping
from contextlib import AsyncExitStack, suppress
from pathlib import Path
from typing import Any

from msgspec import Struct

from judge.cluster.greeting import Offer
from judge.cluster.keys import Keys
from judge.cluster.need import distributed
from judge.cluster.reach import check_reached
from judge.cluster.where import Address
from judge.errors import JudgeError, unwritable
from judge.sandbox.temporary import TemporaryFolder

_LOOK = 1.0  # seconds between looks at the workers
_CONNECT = 15.0  # seconds for a worker to begin


class Plan(Struct, frozen=True):
    """What is to be started: a scheduler that listens at `address` or workers that go there, or both.

    `slots` workers judge one submission each at a time; `offer` is what they are. For `patience` seconds they
    look for a scheduler that is lost. With `attended`, all ends with standard input. `environment` is
    added to that of the workers.
    """

    address: Address
    scheduler: bool
    slots: int
    offer: Offer | None
    keys: Keys | None = None
    environment: Mapping[str, str] = {}
    patience: float = 600.0
    attended: bool = False


def serve(plan: Plan, ready: Callable[[str], None], say: Callable[[str], None]) -> bool:
    """Serve until a signal comes; whether that was Ctrl-C. `ready` is called once, with the clients' address.

    Raises:
        UsageError: the address cannot be listened at.
        JudgeError: there is no scheduler to be reached, at the start or for too long.
    """
    distributed()
    with TemporaryFolder(private=True) as folder:
        return asyncio.run(_serve(plan, ready, say, str(folder)))


async def _serve(plan: Plan, ready: Callable[[str], None], say: Callable[[str], None], folder: str) -> bool:
    stop, interrupted = asyncio.Event(), asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        loop.add_signal_handler(number, _end, stop, interrupted if number == signal.SIGINT else stop)
    if plan.attended:
        threading.Thread(target=_attend, args=(loop, stop), daemon=True).start()
    security = plan.keys.security() if plan.keys and plan.address.safe else None
    async with AsyncExitStack() as stack:
        address = str(plan.address)
        if plan.scheduler:
            scheduler = await _scheduler(plan.address, security)
            stack.push_async_callback(scheduler.close)
            address = str(scheduler.address)
        crew = _Crew(plan, address, security, folder)
        stack.push_async_callback(crew.close)
        if not plan.slots or await _first(crew.fill(), stop):
            ready(address)
            await _watch(plan, crew, stop, say)
    return interrupted.is_set()


def _end(*events: asyncio.Event) -> None:
    for event in events:
        event.set()


async def _first(work: Any, stop: asyncio.Event) -> bool:
    """Whether the work was done before everything is to stop."""
    task, stopped = asyncio.ensure_future(work), asyncio.ensure_future(stop.wait())
    await asyncio.wait((task, stopped), return_when=asyncio.FIRST_COMPLETED)
    stopped.cancel()
    if task.done():
        task.result()
        return True
    task.cancel()
    with suppress(asyncio.CancelledError, JudgeError):
        await task
    return False


async def _watch(plan: Plan, crew: _Crew, stop: asyncio.Event, say: Callable[[str], None]) -> None:
    """Replace workers that have gone, until everything is to stop."""
    loop = asyncio.get_running_loop()
    missed: float | None = None
    while not stop.is_set():
        with suppress(asyncio.TimeoutError):
            await asyncio.wait_for(stop.wait(), _LOOK)
        if stop.is_set() or not crew.drop_gone():
            continue
        fault = await crew.refilled(stop)
        if fault is None:
            if missed is not None:
                say(f"the scheduler at {crew.address} is back")
            missed = None
        elif missed is None:
            missed = loop.time()
            say(f"the scheduler at {crew.address} is lost; looking for it for {plan.patience:.0f} seconds")
        elif loop.time() - missed > plan.patience:
            raise fault


class _Crew:
    """The workers, each a process with a nanny here that starts it anew when it dies."""

    def __init__(self, plan: Plan, address: str, security: Any, folder: str) -> None:
        self.address = address
        self._plan = plan
        self._security = security
        self._folder = folder
        self._nannies: list[Any] = []

    async def fill(self) -> None:
        """Start as many workers as are missing. Raises JudgeError where no scheduler takes them."""
        missing = self._plan.slots - len(self._nannies)
        try:
            started = await asyncio.gather(*(self._started() for _ in range(missing)), return_exceptions=True)
        finally:
            self.drop_gone()
        for each in started:
            if isinstance(each, BaseException):
                remedy = "start it with 'judge worker --scheduler', or see its address and its keys"
                raise JudgeError(f"no scheduler takes workers at {self.address}", remedy=remedy) from each

    async def refilled(self, stop: asyncio.Event) -> JudgeError | None:
        """Start the workers that are missing, unless everything is to stop; why that failed, where it did."""
        try:
            await asyncio.to_thread(check_reached, Address.of(self.address))
            await _first(self.fill(), stop)
        except JudgeError as fault:
            return fault
        return None

    def drop_gone(self) -> int:
        """Forget the workers that have gone for good; how many are missing."""
        from distributed.core import Status

        gone = (Status.closed, Status.failed, Status.closing)
        self._nannies = [nanny for nanny in self._nannies if nanny.status not in gone]
        return self._plan.slots - len(self._nannies)

    async def close(self) -> None:
        """End the workers, and with them what they are judging."""
        await asyncio.gather(*(nanny.close(timeout=2) for nanny in self._nannies), return_exceptions=True)

    async def _started(self) -> None:
        import dask
        from distributed import Nanny

        from judge.cluster.quiet import QuietWorker

        # On this machine alone nobody else is to be listened to: what is plain has no keys.
        host = self._plan.address.host if not self._plan.address.safe else None
        nanny = Nanny(
            self.address,
            worker_class=QuietWorker,
            nthreads=1,
            resources=self._plan.offer.resources() if self._plan.offer else {},
            security=self._security,
            host=host,
            memory_limit=0,
            local_directory=self._folder,
            death_timeout=_CONNECT,
            silence_logs=logging.CRITICAL,
            dashboard=False,
            config=dask.config.config,
            env=dict(self._plan.environment),
        )
        self._nannies.append(nanny)
        try:
            await asyncio.wait_for(nanny, _CONNECT)
        except BaseException:
            with suppress(Exception):
                await nanny.close(timeout=1)
            raise


async def _scheduler(address: Address, security: Any) -> Any:
    from judge.cluster.quiet import QuietScheduler

    scheduler = QuietScheduler(
        host=address.host,
        port=address.port,
        protocol=f"{address.scheme}://",
        security=security,
        dashboard=False,
    )
    try:
        return await scheduler
    except OSError as fault:
        remedy = "another scheduler is there perhaps; give another port, 0 for any that is free"
        raise unwritable(Path(str(address)), fault, remedy) from fault


def _attend(loop: asyncio.AbstractEventLoop, stop: asyncio.Event) -> None:
    """Whoever started this holds its standard input; when they let go, all ends."""
    while os.read(sys.stdin.fileno(), 4096):
        pass
    with suppress(RuntimeError):  # it has ended already
        loop.call_soon_threadsafe(stop.set)
