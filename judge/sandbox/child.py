"""What runs inside the contained process, next to a source that nobody trusts.

Standard library only, and little of it, since every start pays for it. The judge starts it as
`python -I -c BOOT folder channel answers parent` and talks over `channel`, a stream socket:

    child → judge   R cpu-nanoseconds   ready, nothing foreign has run yet
    judge → child   S (name, source)    the submission
    judge → child   I                   compile it;  child → judge  I {"fault": …, "names": …}
    judge → child   C (entry, limits, calls)   make the calls;  child → judge  D number-of-calls
    judge → child   P (limits,)         become the program; the channel is closed before it runs

A frame is a letter, a length (4 bytes, little endian) and that many bytes. What the judge sends is marshal
data, what it reads is text only. Each call's end is a line of the file `answers`, so that a call that kills
the process loses itself alone: A and the answer's JSON, E and an exception's text, M for a MemoryError.
"""

from __future__ import annotations

import _ast
import _signal  # type: ignore[import-not-found]
import builtins
import marshal
import os
import resource
import sys
import time
from _json import encode_basestring_ascii as quote
from types import ModuleType

TYPE_CHECKING = False
if TYPE_CHECKING:  # `typing` alone would take a fifth of the start
    from collections.abc import Callable, Sequence
    from types import CodeType, TracebackType
    from typing import Any

INSPECT_BYTES = 4 << 30
DETAIL_LENGTH = 500
NAMES = 10_000


def main(folder: str, channel: int, answers: int, parent: int) -> None:
    """Serve the judge until it hangs up, or become the program it asks for."""
    _die_with(parent)
    sys.path.insert(0, folder)
    from encode import encode  # type: ignore[import-not-found]

    sys.path.remove(folder)
    for own in ("encode", "child"):
        sys.modules.pop(own, None)  # a submission may have modules of these names
    sys.dont_write_bytecode = True
    _send(channel, b"R", str(time.process_time_ns()).encode())
    worker = _Worker(answers, encode)
    while (frame := _receive(channel)) is not None:
        kind, payload = frame
        if kind == b"S":
            worker.name, worker.source = marshal.loads(payload)
        elif kind == b"I":
            _soft_limit(resource.RLIMIT_AS, INSPECT_BYTES)
            _send(channel, b"I", worker.inspect().encode())
        elif kind == b"C":
            _send(channel, b"D", str(worker.call(*marshal.loads(payload))).encode())
        else:
            os.close(channel)
            os.close(answers)
            worker.become_program(*marshal.loads(payload))
            return


class _Worker:
    """The submission inside its process: compiled at most once, imported at most once."""

    def __init__(self, answers: int, encode: Callable[[Any], Any]) -> None:
        self.name = ""
        self.source = b""
        self._answers = answers
        self._encode = encode
        self._code: CodeType | None = None
        self._module: ModuleType | None = None
        self._broken = ""  # why the module could not be imported

    def _compiled(self) -> CodeType:
        if self._code is None:
            self._code = compile(self.source, self.name, "exec", dont_inherit=True)
        return self._code

    def inspect(self) -> str:
        try:
            self._compiled()
            tree: Any = compile(self.source, self.name, "exec", _ast.PyCF_ONLY_AST, dont_inherit=True)
        except SyntaxError as error:
            text = (error.text or "").strip("\n")[:DETAIL_LENGTH]
            fault: list[Any] = [
                f"{type(error).__name__}: {error.msg}",
                error.lineno or 0,
                error.offset or 0,
                text,
            ]
        except (ValueError, RecursionError, MemoryError, OverflowError) as error:
            fault = [f"{type(error).__name__}: {error}" if str(error) else "too much to compile", 0, 0, ""]
        else:
            return _json({"fault": None, "names": list(_bound(tree.body).items())[:NAMES]})
        return _json({"fault": fault, "names": []})

    def call(self, entry: str, limits: tuple[int, int, int], calls: list[tuple[Any, ...]]) -> int:
        _confine(*limits)
        if self._module is None:
            self._import()
        function = self._module.__dict__.get(entry) if self._module else None
        if self._broken or function is None:
            reason = self._broken or f"the module has no {entry} once it is imported"
            for _ in calls:
                self._write("E" + quote(reason))
        else:
            self._make(function, calls)
        _flush()
        return len(calls)

    def _import(self) -> None:
        # Not called after its file: fractions.py may well import the library's fractions.
        module = ModuleType("submission")
        module.__file__ = self.name
        sys.modules[module.__name__] = module
        sys.argv = [self.name]
        try:
            exec(self._compiled(), module.__dict__)
        except MemoryError:
            self._write("M" + quote("while the module was imported"))
            _flush()
            os._exit(1)
        except BaseException as error:
            self._broken = f"{_detail(error, self.name)}, while the module was imported"
        self._module = module

    def _make(self, function: Callable[..., Any], calls: list[tuple[Any, ...]]) -> None:
        encode, as_json, write, name = self._encode, _json, self._write, self.name
        for arguments in calls:
            try:
                line = "A" + as_json(encode(function(*arguments)))
            except MemoryError as error:
                write("M" + quote(_detail(error, name)))
                _flush()
                os._exit(1)
            except BaseException as error:  # SystemExit and KeyboardInterrupt too: this call's end, not ours
                line = "E" + quote(_detail(error, name))
            write(line)

    def _write(self, line: str) -> None:
        rest = (line + "\n").encode()
        while rest:
            rest = rest[os.write(self._answers, rest) :]

    def become_program(self, limits: tuple[int, int, int]) -> None:
        _confine(*limits)
        module = ModuleType("__main__")
        module.__dict__.update(__builtins__=builtins, __file__=self.name)
        sys.modules["__main__"] = module
        sys.argv = [self.name]
        try:
            exec(self._compiled(), module.__dict__)
        except SystemExit:
            raise
        except BaseException as error:
            error.__traceback__ = _own_part(error.__traceback__, self.name)
            sys.excepthook(type(error), error, error.__traceback__)
            sys.exit(1)


def _die_with(parent: int) -> None:
    """Ask to be killed when the judge dies; elsewhere than on Linux nothing offers that."""
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None).prctl(1, 9, 0, 0, 0)  # PR_SET_PDEATHSIG, SIGKILL
        if os.getppid() != parent:
            os._exit(1)


def _confine(memory_bytes: int, output_bytes: int, cpu_seconds: int) -> None:
    """Set hard limits; 0 CPU seconds means that the judge watches the clock itself."""
    _hard_limit(resource.RLIMIT_AS, 2 * memory_bytes + (256 << 20))
    _hard_limit(resource.RLIMIT_FSIZE, output_bytes + 1)  # one more, so that too much can be told from enough
    _signal.signal(_signal.SIGXFSZ, _signal.SIG_DFL)  # `signal` itself would import enum
    _hard_limit(resource.RLIMIT_CORE, 0)
    _hard_limit(resource.RLIMIT_NOFILE, 256)
    if cpu_seconds:
        _hard_limit(resource.RLIMIT_CPU, cpu_seconds)
    hard = resource.getrlimit(resource.RLIMIT_STACK)[1]
    _soft_limit(resource.RLIMIT_STACK, hard)  # after exec, so that threads keep the usual size


def _hard_limit(which: int, value: int) -> None:
    hard = resource.getrlimit(which)[1]
    value = value if hard == resource.RLIM_INFINITY else min(value, hard)
    try:
        resource.setrlimit(which, (value, value))
    except (ValueError, OSError):
        if sys.platform == "linux":  # macOS knows RLIMIT_AS but refuses it; the judge looks at the peak there
            raise


def _soft_limit(which: int, value: int) -> None:
    hard = resource.getrlimit(which)[1]
    if hard != resource.RLIM_INFINITY and value != resource.RLIM_INFINITY:
        value = min(value, hard)
    try:
        resource.setrlimit(which, (value, hard))
    except (ValueError, OSError):
        if sys.platform == "linux":
            raise


def _send(channel: int, kind: bytes, payload: bytes) -> None:
    rest = kind + len(payload).to_bytes(4, "little") + payload
    while rest:
        rest = rest[os.write(channel, rest) :]


def _receive(channel: int) -> tuple[bytes, bytes] | None:
    head = _exactly(channel, 5)
    if head is None:
        return None
    payload = _exactly(channel, int.from_bytes(head[1:], "little"))
    return None if payload is None else (head[:1], payload)


def _exactly(channel: int, length: int) -> bytes | None:
    parts = bytearray()
    while len(parts) < length:
        part = os.read(channel, min(length - len(parts), 1 << 20))
        if not part:
            return None
        parts += part
    return bytes(parts)


def _flush() -> None:
    """Empty the submission's own buffers into its files; what it did to them is its own affair."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except BaseException:  # a closed or replaced stream: the judge reads what did arrive
            continue


def _json(value: Any) -> str:
    """JSON text of what `encode` gives; `json` itself takes longer to import than a thousand calls to run."""
    kind = type(value)
    if kind is float or kind is int:
        return repr(value)
    if kind is list and _only_numbers(text := repr(value)):
        return text
    if kind is list or kind is tuple:
        return "[" + ",".join([_json(item) for item in value]) + "]"
    if kind is str:
        return quote(value)
    if kind is dict:
        return "{" + ",".join([f"{quote(key)}:{_json(item)}" for key, item in value.items()]) + "}"
    return "null" if value is None else "true" if value is True else "false"


def _only_numbers(text: str) -> bool:
    """Whether the repr of a list is JSON as it stands: no None, dict, string or tuple in it."""
    return "N" not in text and "{" not in text and "'" not in text and '"' not in text and "(" not in text


def _detail(error: BaseException, name: str) -> str:
    """One line for a person, whatever the exception's own text does."""
    try:
        text = str(error)
    except BaseException:
        text = "(its text cannot be shown)"
    text = " ".join(text[: 2 * DETAIL_LENGTH].split())[:DETAIL_LENGTH]
    line = 0
    step = error.__traceback__
    while step is not None:
        if step.tb_frame.f_code.co_filename == name:
            line = step.tb_lineno
        step = step.tb_next
    what = f"{type(error).__name__}: {text}" if text else type(error).__name__
    return f"{what} (line {line})" if line else what


def _own_part(step: TracebackType | None, name: str) -> TracebackType | None:
    """The traceback from the submission's first frame on."""
    first = step
    while step is not None:
        if step.tb_frame.f_code.co_filename == name:
            return step
        step = step.tb_next
    return first


def _bound(body: Sequence[Any]) -> dict[str, int]:
    """The names that module-level statements bind, each with the line of its first binding."""
    names: dict[str, int] = {}
    waiting = list(reversed(body))
    while waiting:
        node = waiting.pop()
        if isinstance(node, (_ast.FunctionDef, _ast.AsyncFunctionDef, _ast.ClassDef)):
            names.setdefault(node.name, node.lineno)
        elif isinstance(node, (_ast.Import, _ast.ImportFrom)):
            for alias in node.names:
                names.setdefault(alias.asname or alias.name.partition(".")[0], node.lineno)
        elif isinstance(node, _ast.Name):
            if isinstance(node.ctx, _ast.Store):
                names.setdefault(node.id, node.lineno)
        elif not isinstance(
            node, (_ast.Lambda, _ast.ListComp, _ast.SetComp, _ast.DictComp, _ast.GeneratorExp)
        ):
            waiting.extend(reversed(_children(node)))
    return names


def _children(node: Any) -> list[Any]:
    found: list[Any] = []
    for field in node._fields:
        value = getattr(node, field, None)
        if isinstance(value, list):
            found.extend(item for item in value if isinstance(item, _ast.AST))
        elif isinstance(value, _ast.AST):
            found.append(value)
    return found
