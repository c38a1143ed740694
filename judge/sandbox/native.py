"""The `Box` of a submission that is not Python: compiled in one container, run in another.

What it made is taken from a store where it was made before. Time and memory are measured from outside, as
everywhere; what the language's empty program needs is taken off the time and allowed on top of the memory.
"""

from __future__ import annotations

import hashlib
import marshal
import os
import re
from collections.abc import Callable, Sequence
from contextlib import ExitStack, closing
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from judge.errors import JudgeError, ShortageError
from judge.sandbox import calls, launch, outcome
from judge.sandbox.boundary import (
    Box,
    CallsResult,
    Defined,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    SourceFault,
    Stop,
    Talk,
    Usage,
)
from judge.sandbox.box import BUSY, ContainerBox
from judge.sandbox.compile import LIMITS, compiled, place_of
from judge.sandbox.container import ChildEnd, Container, Lost
from judge.sandbox.factory import Containment
from judge.sandbox.inside import wire
from judge.sandbox.launch import Workplace
from judge.sandbox.parcels import temporary_folder
from judge.sandbox.recipe import ArtifactStore, Files, Recipe, Sources, filled, written

_BOX = "/box"
_WARNED = "judge-warnings"  # a file beside what was compiled, for whoever takes that from the cache
_STACK = 64 << 20  # at most, where it may be as large as the memory
_SHOWN = 200
_MOST_FOUND = 3  # sentences of checks
_WORDS = re.compile(r"panic|Exception|[Ee]rror|terminate|what\(\)|fatal|Assertion")
_LINE = re.compile(r" \(line (\d{1,9})\)$")
_NOTHING = Usage()
Order = tuple[Recipe, Sources]


class NativeBox(ContainerBox):
    """One submission in another language."""

    stderr_bytes = 32 << 10  # what says why comes before a hundred frames of the stack

    def __init__(
        self, order: Callable[[], Order], boxes: Containment, store: ArtifactStore, *, idle: bool = True
    ) -> None:
        """`order` is asked on entering: it raises JudgeError where a tool is missing.

        Without `idle` nothing is taken off for the language.
        """
        super().__init__(boxes)
        self._order = order
        self._store = store
        self._subtracts = idle
        self._artifact: Files = ()
        self._errors = b""  # what the last run wrote there
        self._raised: list[str] = []  # what its calls have raised
        self._closing = ExitStack()

    @cached_property
    def _ordered(self) -> Order:  # by the first use, which may be before it is entered
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
        super().__exit__(*exc)
        self._closing.close()

    def _start(self, level: str) -> Container:
        return self._started(self._place, (*self._recipe.reads, *self._recipe.runs), level)

    def _started(self, place: Workplace, more: tuple[str, ...], level: str) -> Container:
        """A container that is ready, and shows `more` besides."""
        visible = self._boxes.visible(more, modules=False)
        plan = partial(launch.plan, level, "", visible, self._boxes.share, place=place)
        container = Container(level, b"", plan, self._boxes.seeds)
        try:
            container.await_ready()
        except BaseException:  # Ctrl-C too
            container.close()
            raise
        return container

    # -- compiling

    def _inspect(self) -> Inspection:
        sources = self._sources
        fault = sources.fault
        if fault is None:
            key = self._key()
            found = self._store.artifact(key)
            if found is None:
                found, fault = self._compile()
                if fault is None:
                    self._store.keep_artifact(key, found)
            self._artifact = found
        warned = dict(self._artifact).get(_WARNED, b"").decode()
        entry, line = sources.entry, sources.line
        names = ((entry, line),) if entry else ()
        functions = (Defined(entry, line, 0, -1, sources.empty),) if entry else ()
        return Inspection(
            fault, names, functions, language=self._recipe.name, warnings=tuple(warned.splitlines())
        )

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
        recipe = self._recipe
        with temporary_folder() as folder:
            written(folder / "source", [*sources.files, *recipe.help])
            (folder / "scratch").mkdir(mode=0o755)
            place, more = place_of(recipe, folder), (*recipe.compile_reads, *recipe.compile_runs)
            try:
                with closing(self._boxes.levels.open(partial(self._started, place, more))) as container:
                    self.isolation = container.level
                    made = compiled(recipe, sources, container, place)
            except Lost:
                raise ShortageError("the compiler's container has ended", remedy=BUSY) from None
        warned = (_WARNED, "\n".join(made.warnings).encode())
        return (*made.files, warned) if made.warnings else made.files, made.fault

    # -- running

    def run_program(self, stdin: bytes | Talk, limits: Limits) -> ProgramResult:
        """Run it in a process of its own; see `Box.run_program`."""
        done = self.run_whole(stdin, limits)
        if done.stop is Stop.EXCEPTION:  # a fault of the source
            return done
        cpu = max(0.0, done.usage.cpu_seconds - self.idle.cpu_seconds)
        return done._replace(usage=done.usage._replace(cpu_seconds=cpu))

    def run_whole(self, stdin: bytes | Talk, limits: Limits) -> ProgramResult:
        """As `run_program`, with the start of its language in the CPU time; `limits` are without."""
        done = super().run_program(stdin, limits)
        self._errors = done.stderr
        if done.stop is not Stop.EXITED:
            return done
        return done._replace(detail=placed(done.detail, done.stderr, self._sources))

    def _prepare(self) -> str:
        fault = self.inspect().fault
        return fault.message if fault else ""

    def _overrun(self, done: ChildEnd, limits: Limits, printed: int) -> tuple[Stop, str] | None:
        return outcome.overrun(done, limits, printed, idle=self.idle, name=self._recipe.name)

    def _said(self, done: ChildEnd, stderr: bytes) -> tuple[ChildEnd, str]:
        sign = self._recipe.out_of_memory
        short = done.status and not os.WIFSTOPPED(done.status) and sign and sign.encode() in stderr
        return done._replace(note=(wire.NO_MEMORY if short else wire.NO_NOTE, "")), last_words(stderr)

    def _run(self, stdio: Sequence[int], limits: Limits) -> ChildEnd:
        recipe, memory, idle = self._recipe, limits.memory_bytes, self.idle
        self._here()
        box = self._place.where(_BOX, self.isolation)
        places = {
            "box": box,
            "main": self._sources.main,
            "class": Path(self._sources.main).stem,
            "memory": str(memory >> 20),
        }
        environment = {
            **launch.PLAIN,
            "MALLOC_ARENA_MAX": "2",
            **{name: filled([value], places)[0] for name, value in recipe.environment.items()},
        }
        bounds = {
            "RLIMIT_DATA": 2 * memory + recipe.allowance,
            "RLIMIT_FSIZE": limits.output_bytes + 1,
            "RLIMIT_STACK": min(memory, recipe.stack or _STACK),
            "RLIMIT_NPROC": launch.threads(self.isolation, self._boxes.share, alone=os.geteuid() == 0),
        }
        command = filled(recipe.command, places)
        payload = marshal.dumps((command, environment, box, bounds))
        with_idle = limits._replace(cpu_seconds=limits.cpu_seconds + idle.cpu_seconds)
        return self._ask(wire.EXECUTE, stdio, payload, with_idle, memory, f"{command[0]} cannot be started")

    @cached_property
    def _place(self) -> Workplace:
        """Where a container shows what was compiled."""
        box = self._closing.enter_context(temporary_folder()) / "box"
        written(box, self._artifact)
        runnable = tuple(map(os.path.realpath, self._recipe.runs))
        return Workplace("run", ((_BOX, str(box)),), runnable=runnable, reads=tuple(self._recipe.reads))

    @property
    def idle(self) -> Usage:
        """What the language's empty program costs at this level; measured once for a toolchain."""
        if not self._subtracts:
            return _NOTHING
        key = f"{self._recipe.key}-{self.isolation or self._boxes.levels.level}"
        found = self._store.idle(key)
        if found is None:
            found = measured(self._recipe, self._boxes, self._store)
            self._store.keep_idle(key, found)
        return found

    def checked(self, ask: Callable[[Box, Limits], object]) -> tuple[str, ...]:
        """What the same program says of itself while it is asked, with the checks of its language in it.

        Nothing where there are none, or where this machine lacks what they need.
        """
        recipe, sources = self._recipe, self._sources
        for words in recipe.checks:
            key = hashlib.blake2b(f"{recipe.key} {words} {recipe.help}".encode(), digest_size=16).hexdigest()
            if self._store.artifact(f"{key}-lacking") is not None:
                continue
            steps = tuple((*step, *words) for step in recipe.steps)
            order = recipe._replace(key=key, steps=steps), sources
            with NativeBox(lambda order=order: order, self._boxes, self._store, idle=False) as box:  # type: ignore[misc]
                try:
                    if box.inspect().fault is None:
                        ask(box, LIMITS)
                        return found(box._errors, recipe.finds, sources, box._raised)
                except JudgeError:  # not even the empty program
                    self._store.keep_artifact(f"{key}-lacking", ())
        return ()

    # -- calling

    def call(self, entry: str, cases: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """Make the calls in one process; see `Box.call`. What an import is, is none here."""
        assert entry.removesuffix("()") == self._sources.entry, "the driver calls one function or class"
        if not cases:
            return CallsResult((), _NOTHING)
        done = self.run_program(calls.text(cases), limits)
        replies, kept_form = self._replies(done, cases)
        if kept_form and len(replies) < len(cases):
            # It ended early: at which call shows where each answer is written at once.
            again = self.run_program(calls.text(cases, at_once=True), limits)
            replies, kept_form = self._replies(again, cases)
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

    def _replies(self, done: ProgramResult, cases: Sequence[Sequence[Any]]) -> tuple[list[Reply], bool]:
        found, kept_form = calls.replies(done.stdout, len(cases))
        raised = {place: each for place, each in enumerate(found) if each.detail}
        for place, each in raised.items():
            what, call = calls.parted(each.detail, cases[place])
            found[place] = each._replace(detail=within(what, self._sources) + call)
        self._raised = [found[place].detail for place in raised]
        return found, kept_form


def measured(recipe: Recipe, boxes: Containment, store: ArtifactStore) -> Usage:
    """What a program costs that does nothing. Raises JudgeError where it fails."""
    name, source = recipe.empty
    limits = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=256 << 20, output_bytes=1 << 20)
    empty = recipe, Sources(((name, source),), name)
    with NativeBox(lambda: empty, boxes, store, idle=False) as box:
        if fault := box.inspect().fault:
            raise _empty_fails(recipe, fault.message)
        runs = [box.run_program(b"", limits) for _ in range(3)]
    for run in runs:
        if run.stop is not Stop.ANSWERED:
            raise _empty_fails(recipe, f"{run.detail} {last_words(run.stderr)}")
    cpu = sorted(run.usage.cpu_seconds for run in runs)[1]
    return Usage(cpu, memory_bytes=max(run.usage.memory_bytes for run in runs))


def _empty_fails(recipe: Recipe, why: str) -> ShortageError:
    return ShortageError(f"the empty {recipe.name} program fails: {why}", remedy="see 'judge doctor'")


def last_words(stderr: bytes) -> str:
    """The line of its stderr that most likely says what went wrong, with what belongs to it; or ""."""
    lines = [wire.printable(line) for line in stderr.decode(errors="replace").splitlines()]
    place = next((at for at, line in enumerate(lines) if _WORDS.search(line)), None)
    if place is None:
        return ""
    found, *after = lines[place : place + 2]
    if after and (found.endswith(":") or after[0].startswith("what()")):
        found = f"{found} {after[0]}"
    return found[:_SHOWN]


def found(stderr: bytes, finds: Sequence[str], sources: Sources, raised: Sequence[str]) -> tuple[str, ...]:
    """What checks have found, in sentences, each once and a few of them."""
    said = stderr.decode(errors="replace")
    told = [each for each in raised if " (line " in each]
    for each in (each for pattern in finds for each in re.finditer(pattern, said)):
        of, line = (each.groupdict().get(name) for name in ("of", "line"))
        what = wire.printable(f"{of}: {each['message']} fails" if of else each["message"])
        told.append(within(what + (f" (line {line})" if line else ""), sources))
    return tuple(f"run with checks: {each}" for each in dict.fromkeys(told))[:_MOST_FOUND]


def placed(detail: str, stderr: bytes, sources: Sources) -> str:
    """How it ended, with the line of the submission that its stderr tells.

    That is the first one in a trace that begins where it ended, and the last in one of Python's.
    """
    place = re.compile(rf'\b{re.escape(sources.own)}(?::|(", line ))(\d{{1,9}})')
    found = place.findall(stderr.decode(errors="replace"))
    if not found:
        return detail
    return within(f"{detail} (line {found[-1 if found[0][0] else 0][1]})", sources)


def within(detail: str, sources: Sources) -> str:
    """The same without a line at its end that the submission has not."""
    found = _LINE.search(detail)
    lines = dict(sources.files)[sources.own].count(b"\n") + 1
    return detail[: found.start()] if found and int(found[1]) > lines else detail
