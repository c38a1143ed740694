"""The `Box` of a submission that is not Python: compiled in one container, run in another.

What it made is taken from a store where it was made before. Time and memory are measured from outside, as
everywhere; what the language's empty program needs is taken off the time and allowed on top of the memory.
"""

from __future__ import annotations

import hashlib
import marshal
import os
from collections.abc import Callable, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

from judge.errors import ShortageError
from judge.sandbox import calls, ends, launch, room, shared
from judge.sandbox.boundary import (
    CallsResult,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    SourceFault,
    Stop,
    Usage,
)
from judge.sandbox.compile import PROCESSES, compiled, place_of
from judge.sandbox.container import Container, Done, Holder, Lost
from judge.sandbox.factory import Boxes
from judge.sandbox.inside import wire
from judge.sandbox.launch import Workplace
from judge.sandbox.recipe import Files, Recipe, Sources, Store, filled, written
from judge.sandbox.roots import find_roots
from judge.sandbox.temporary import TemporaryFolder

_BOX = "/box"
_STACK = 64 << 20  # at most, where it may be as large as the memory
_STDERR = 32 << 10  # what says why comes before a hundred frames of the stack
_NOTHING = Usage()
Order = tuple[Recipe, Sources]
_BUSY = "judge it again, with a smaller -j if the machine is busy"


class NativeBox:
    """One submission in another language; one thread at a time may use it."""

    def __init__(self, order: Callable[[], Order], boxes: Boxes, store: Store, *, idle: bool = True) -> None:
        """`order` is asked on entering: it raises JudgeError where a tool is missing.

        `boxes` says at which level it is held; without `idle` nothing is taken off for the language.
        """
        self._order = order
        self._boxes = boxes
        self._store = store
        self._subtracts = idle
        self._level = boxes.levels.level  # to be begun with
        self._held = ""  # the level of the last container that was had
        self._inspection: Inspection | None = None
        self._artifact: Files = ()
        self._folder: TemporaryFolder | None = None
        self._running: Holder | None = None
        self._place: Workplace | None = None

    @property
    def isolation(self) -> str:
        """The level that holds it: "full", "strong" or "limits"; "" as long as no container was made."""
        return self._held

    @cached_property
    def _ordered(self) -> Order:
        return self._order()

    @property
    def _recipe(self) -> Recipe:
        return self._ordered[0]

    @property
    def _sources(self) -> Sources:
        return self._ordered[1]

    def __enter__(self) -> NativeBox:
        _ = self._ordered
        return self

    def __exit__(self, *exc: object) -> None:
        if self._running is not None:
            self._running.close(at_once=False)
            self._running.drop()
            self._running = None
        if self._folder is not None:
            self._folder.close()
            self._folder = None

    def warm_up(self) -> None:
        """Nothing is gained by starting ahead what is compiled first."""

    # -- compiling

    def inspect(self) -> Inspection:
        """Compile it, or find what was compiled of the same source by the same tools."""
        if self._inspection is None:
            self._inspection = self._inspect()
        return self._inspection

    def _inspect(self) -> Inspection:
        sources = self._sources
        fault = sources.fault
        if fault is None:
            key = self._key()
            found = self._store.artifact(key)
            if found is None:
                done = self._compile()
                found, fault = done
                if fault is None:
                    self._store.keep_artifact(key, found)
            self._artifact = found
        names = ((sources.entry, sources.line),) if sources.entry else ()
        return Inspection(fault, names, language=self._recipe.name)

    def _key(self) -> str:
        digest = hashlib.blake2b(self._recipe.key.encode(), digest_size=16)
        for name, content in self._sources.files:
            digest.update(f"\0{name}\0{len(content)}\0".encode() + content)
        return digest.hexdigest()

    def _compile(self) -> tuple[Files, SourceFault | None]:
        files, fault = self._compiled(self._sources)
        if fault and not fault.line:  # no place in the source: is it the machine that lacks something?
            name, source = self._recipe.empty
            why = self._compiled(Sources(((name, source),), name))[1]
            if why:
                raise _empty_fails(self._recipe, why.message)
        return files, fault

    def _compiled(self, sources: Sources) -> tuple[Files, SourceFault | None]:
        with TemporaryFolder() as folder:
            written(folder / "source", [*sources.files, *self._recipe.help])
            (folder / "scratch").mkdir(mode=0o755)
            place = place_of(self._recipe, folder)
            more = (*self._recipe.compile_reads, *self._recipe.compile_runs)
            holder = Holder(self._boxes.levels, self._starts(place, more))
            try:
                made = compiled(self._recipe, sources, holder.here(), place, self._processes())
            except Lost:
                raise ShortageError("the compiler's container has ended", remedy=_BUSY) from None
            finally:
                holder.close(at_once=False)
                holder.drop()
            self._level = self._held = holder.level
        return made.files, made.fault

    def _processes(self) -> int:
        """A bound that leaves the compiler its own; the kernel counts all processes of a user together."""
        if os.geteuid() == 0 or self._level == "full":
            return PROCESSES
        return room.tasks_of_mine() + PROCESSES

    def _starts(self, place: Workplace, more: Sequence[str]) -> Callable[[str], Container]:
        """What starts a container at a level."""
        share = self._boxes.share
        roots = find_roots(self._boxes.hide, more, modules=False)
        return lambda level: Container(level, "", b"", roots, share, place)

    # -- running

    def run_program(self, stdin: bytes, limits: Limits) -> ProgramResult:
        """Run it in a process of its own; see `Box.run_program`."""
        done = self.run_whole(stdin, limits)
        return done._replace(usage=self._without_idle(done.usage))

    def _without_idle(self, usage: Usage) -> Usage:
        return usage._replace(cpu_seconds=max(0.0, usage.cpu_seconds - self.idle.cpu_seconds))

    def run_whole(self, stdin: bytes, limits: Limits) -> ProgramResult:
        """As `run_program`, with the start of its language in the CPU time; `limits` are without."""
        fault = self.inspect().fault
        if fault:
            return ProgramResult(Stop.EXCEPTION, b"", b"", fault.message, _NOTHING)
        idle = self.idle
        with shared.stdio(stdin) as stdio:
            try:
                done = self._ask(stdio, limits, idle)
            except Lost:
                raise ShortageError("the process that watches it has ended", remedy=_BUSY) from None
            printed = max(shared.size(descriptor) for descriptor in stdio[1:])
            out, err = shared.head(stdio[1], limits.output_bytes), shared.tail(stdio[2], _STDERR)
        usage = Usage(done.cpu_ns / 1e9, done.wall_ns / 1e9, done.peak_bytes)
        stop, detail = ends.end_of(done, limits, idle, printed, err, self._recipe)
        return ProgramResult(stop, out, err, detail, usage)

    def _ask(self, stdio: Sequence[int], limits: Limits, idle: Usage) -> Done:
        holder = self._run_holder()
        container = holder.here()
        self._held = holder.level
        place = self._place
        assert place is not None
        recipe, memory = self._recipe, limits.memory_bytes
        box = place.where(_BOX, holder.level)
        places = {
            "box": box,
            "main": self._sources.main,
            "class": Path(self._sources.main).stem,
            "memory": str(memory >> 20),
        }
        environment = {
            "PATH": "/usr/bin:/bin",
            "LANG": "C.UTF-8",
            "TZ": "UTC",
            "MALLOC_ARENA_MAX": "2",
            **{name: filled([value], places)[0] for name, value in recipe.environment.items()},
        }
        bounds = {
            "RLIMIT_DATA": 2 * memory + recipe.allowance,
            "RLIMIT_FSIZE": limits.output_bytes + 1,
            "RLIMIT_STACK": min(memory, recipe.stack or _STACK),
            "RLIMIT_NPROC": launch.threads(holder.level, self._boxes.share, alone=os.geteuid() == 0),
        }
        command = filled(recipe.command, places)
        payload = marshal.dumps((command, environment, box, bounds))
        with_idle = limits._replace(cpu_seconds=limits.cpu_seconds + idle.cpu_seconds)
        try:
            done = container.ask(wire.EXECUTE, stdio, payload, with_idle, memory)
        except BaseException:
            holder.drop()
            raise
        kind, note = container.region.note()
        if kind == wire.BROKEN_BOX:
            holder.drop()
            raise ShortageError(f"{command[0]} cannot be started: {note}", remedy=_BUSY)
        return done

    def _run_holder(self) -> Holder:
        if self._running is None:
            self._folder = TemporaryFolder()
            box = self._folder.path / "box"
            written(box, self._artifact)
            recipe = self._recipe
            runnable = tuple(map(os.path.realpath, recipe.runs))
            shown = ((_BOX, str(box)),)
            self._place = Workplace("run", shown, runnable=runnable, reads=tuple(recipe.reads))
            more = (*recipe.reads, *recipe.runs)
            self._running = Holder(self._boxes.levels, self._starts(self._place, more))
        return self._running

    @property
    def idle(self) -> Usage:
        """What the language's empty program costs at this level; measured once for a toolchain."""
        if not self._subtracts:
            return _NOTHING
        key = f"{self._recipe.key}-{self._level}"
        found = self._store.idle(key)
        if found is None:
            found = measured(self._recipe, self._boxes, self._store)
            self._store.keep_idle(key, found)
        return found

    # -- calling

    def call(self, entry: str, cases: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """Make the calls in one process; see `Box.call`. What an import is, is none here."""
        fault = self.inspect().fault
        assert fault is None, "whoever calls has looked"
        assert entry == self._sources.entry, "the driver calls one function"
        if not cases:
            return CallsResult((), _NOTHING)
        done = self.run_program(calls.text(cases), limits)
        replies, kept_form = calls.replies(done.stdout, len(cases))
        if kept_form and len(replies) < len(cases):
            # It ended early: at which call shows where each answer is written at once.
            again = self.run_program(calls.text(cases, at_once=True), limits)
            replies, kept_form = calls.replies(again.stdout, len(cases))
            done = done if done.stop is not Stop.ANSWERED else again
            if done.stop is Stop.ANSWERED:
                done = done._replace(stop=Stop.EXITED, detail="it ended the process in mid-call")
        if not kept_form:
            done = done._replace(stop=Stop.TAMPERED, detail="it wrote into its own replies")
        if done.stop is Stop.ANSWERED:
            printed = done.stderr if len(cases) == 1 else b""
            return CallsResult(tuple(replies), done.usage, printed=printed)
        del replies[len(cases) - 1 :]
        return CallsResult((*replies, Reply(done.stop, detail=done.detail)), done.usage)


def measured(recipe: Recipe, boxes: Boxes, store: Store) -> Usage:
    """What a program costs that does nothing. Raises JudgeError where it fails."""
    name, source = recipe.empty
    limits = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=256 << 20, output_bytes=1 << 20)
    empty = recipe, Sources(((name, source),), name)
    with NativeBox(lambda: empty, boxes, store, idle=False) as box:
        fault = box.inspect().fault
        runs = [] if fault else [box.run_program(b"", limits) for _ in range(3)]
    failed = next((run for run in runs if run.stop is not Stop.ANSWERED), None)
    if fault or failed:
        why = (
            fault.message if fault else f"{failed.detail} {ends.last_words(failed.stderr)}" if failed else ""
        )
        raise _empty_fails(recipe, why)
    costs = sorted(run.usage.cpu_seconds for run in runs)
    walls = sorted(run.usage.wall_seconds for run in runs)
    return Usage(costs[1], walls[1], max(run.usage.memory_bytes for run in runs))


def _empty_fails(recipe: Recipe, why: str) -> ShortageError:
    return ShortageError(f"the empty {recipe.name} program fails: {why}", remedy="see 'judge doctor'")
