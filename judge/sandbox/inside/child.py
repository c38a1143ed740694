"""What a child of the fork server does: look at the source, make calls, or be the program. It never returns.

Up to the moment the baseline is written only trusted code has run in it; the submission's code comes after,
in the same interpreter, and may do to everything here what it likes: it can only spoil its own replies.
"""

from __future__ import annotations

import _signal as signal  # type: ignore[import-not-found]
import builtins
import errno
import marshal
import os
import resource
import sys
from _json import encode_basestring_ascii as quoted
from _json import make_encoder
from gc import freeze
from types import CodeType, ModuleType

from judge.sandbox.encode import IMPORTING, encode, found, place_in
from judge.sandbox.inside import source, wire

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from types import FrameType
    from typing import Any, NoReturn

TALLY = 3  # the descriptor the baseline goes to
OWN_FILE = "/dev/fd/4"  # on Linux: its source, which can be read at every level

ANSWERED, RAISED = 0, 1  # first item of a reply
# Whatever a class of its own says of itself:
_CODE_OF: Any = SystemExit.__dict__["code"].__get__
_ERRNO_OF: Any = OSError.__dict__["errno"].__get__


def take_descriptors(*kept: int) -> None:
    """Take on stdin, stdout, stderr, the baseline's pipe and perhaps the source, and close all else."""
    kept = tuple(os.dup(number) if number < len(kept) else number for number in kept)
    for place, number in enumerate(kept):
        os.dup2(number, place, inheritable=True)
    os.closerange(len(kept), wire.MOST_DESCRIPTORS)


def start_the_clock() -> None:
    """Tell the fork server the CPU time used so far, as wait4 counts it; from here on it is foreign."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    spent = round((usage.ru_utime + usage.ru_stime) * 1e9)
    os.write(TALLY, spent.to_bytes(8, "little"))
    os.close(TALLY)


def tell_where(name: str, region: wire.Region) -> None:
    """From now on answer SIGUSR1 with the submission's own line that is being run."""

    def answer(_number: int, frame: FrameType | None) -> None:
        try:
            while frame is not None and frame.f_code.co_filename != name:
                frame = frame.f_back
            if frame is not None:
                region.words[wire.STOOD_AT] = frame.f_lineno or 0
        except BaseException:  # it may come at any moment, in the middle of its own end too
            return

    signal.signal(signal.SIGUSR1, answer)


def look_at(text: bytes, name: str, region: wire.Region, stop: int) -> NoReturn:
    """Compile the source, and reply with what `source.inspect` finds."""
    start_the_clock()
    found = source.inspect(text, name)
    line = "".join(_json(found, 0)).encode() + b",\n"
    if region.append(line, stop) and not found["fault"]:
        region.write_note(wire.COMPILED, " ".join(source.to_import(found["modules"])))
    os._exit(0)


def be_program(code: CodeType, name: str, region: wire.Region) -> NoReturn:
    """Run the code as `__main__`, end as an interpreter would."""
    module = _main_module("__main__", name)
    tell_where(name, region)
    start_the_clock()
    status = 0
    try:
        exec(code, module.__dict__)
    except SystemExit as left:
        status = _status_of(_CODE_OF(left))
    except MemoryError as error:
        _note_memory(region, error, name)
        status = 1
    except BaseException as error:
        region.write_note(wire.RAISED, source.described(error, name))
        _show(error, name)
        status = 1
    os._exit(_finish(status) & 0xFF)


def make_calls(code: CodeType, name: str, region: wire.Region, request: wire.Request) -> NoReturn:
    """Import the module, call its entry once for each argument list, append a reply for each.

    Where the arguments are not there yet, it stops once it has imported the module, and after the last call.
    """
    entry, count, most, given = marshal.loads(region.payload(request.payload))
    me, stop_at, pauses = os.getpid(), os.kill, given is None
    module = _main_module("submission", name)  # its own name may be that of a module it imports
    tell_where(name, region)
    start_the_clock()
    try:
        exec(code, module.__dict__)
    except MemoryError as error:
        _note_memory(region, error, name)
        os._exit(1)
    except BaseException as error:
        if _too_long(error):
            _too_much(region, "")
        _all_raised(f"{source.described(error, name)}{IMPORTING}", count, region, request.stop)
        os._exit(_flushed(0))
    freeze()  # a large table of its own would be looked through on the time of its calls
    _flushed(0)
    if pauses:
        stop_at(me, signal.SIGSTOP)
        given = marshal.loads(region.payload(request.payload))
    function = found(module.__dict__, entry, most)
    if function is not None:
        _answer(function, _with_arrays(*given), name, most, region, request.stop)
    else:
        missing = f"the module has no {entry.removesuffix('()')} once it is imported"
        _all_raised(missing, count, region, request.stop)
    status = _flushed(0)
    if pauses and not status:
        stop_at(me, signal.SIGSTOP)
    os._exit(status)


def _with_arrays(places: tuple[int, ...], calls: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    """The calls with an array wherever the arguments at `places` are its code and its bytes."""
    if not places:
        return calls
    from array import array  # late: see `encode`

    return [
        tuple([array(*each) if at in places and type(each) is tuple else each for at, each in enumerate(row)])
        for row in calls
    ]


def _answer(
    function: Callable[..., Any],
    calls: Iterable[tuple[Any, ...]],
    name: str,
    most: int,
    region: wire.Region,
    stop: int,
) -> None:
    """Append a reply for each call; ends the process where they no longer fit."""
    memory, words, used = region.memory, region.words, wire.USED
    at, as_json, form_of = words[used], _json, encode
    for arguments in calls:
        try:
            answer = form_of(function(*arguments), most)
            kind = type(answer)
            shown = repr(answer) if kind is int or kind is float else "".join(as_json(answer, 0))
            line = f"[0,{shown}],\n".encode()
        except MemoryError as error:
            _note_memory(region, error, name)
            os._exit(1)
        except BaseException as error:  # SystemExit too: the end of this call, not of the next
            if _too_long(error):
                _too_much(region, "")
            line = _raised(source.described(error, name) + place_in(function))
        end = at + len(line)
        if end > stop:
            _too_much(region)
        memory[at:end] = line
        words[used] = at = end


def _all_raised(text: str, count: int, region: wire.Region, stop: int) -> None:
    if not region.append(_raised(text) * count, stop):
        _too_much(region)


def _too_much(region: wire.Region, text: str = "its answers together are longer than allowed") -> NoReturn:
    region.write_note(wire.TOO_MUCH, text)
    os._exit(1)


def _too_long(error: BaseException) -> bool:
    """Whether it says that more was printed than may be."""
    return issubclass(type(error), OSError) and _ERRNO_OF(error) == errno.EFBIG


def _refused(value: object) -> NoReturn:
    raise TypeError(f"no JSON form for {type(value).__name__}")


_json: Any = make_encoder(None, _refused, quoted, None, ":", ",", False, False, False)


def _raised(text: str) -> bytes:
    return f"[1,{quoted(text)}],\n".encode()


def _main_module(module_name: str, file_name: str) -> ModuleType:
    # What it makes of the builtins is seen in its own lines alone: they are of a copy.
    module, own = ModuleType(module_name), ModuleType("builtins")
    own.__dict__.update(builtins.__dict__)
    module.__dict__.update(__builtins__=own, __file__=file_name)
    sys.modules.update({"builtins": own, module_name: module})
    sys.argv[:] = [file_name]
    return module


def _status_of(code: object) -> int:
    if code is None:
        return 0
    if isinstance(code, int):
        return int(code)
    try:
        sys.stderr.write(f"{code}\n")
    except BaseException:  # its own stream, and nothing to report it on
        return 1
    return 1


def _show(error: BaseException, name: str) -> None:
    """The traceback on its stderr, from its own first frame on."""
    whole = step = source.TRACEBACK.__get__(error)
    while step is not None and step.tb_frame.f_code.co_filename != name:
        step = step.tb_next
    source.TRACEBACK.__set__(error, step or whole)
    try:
        sys.excepthook(type(error), error, step or whole)
    except BaseException:  # a hook of its own that fails
        return


def _finish(status: int) -> int:
    """What an interpreter does at its end: wait for threads, run exit functions, flush."""
    try:
        if "threading" in sys.modules:
            sys.modules["threading"]._shutdown()
        if "atexit" in sys.modules:
            sys.modules["atexit"]._run_exitfuncs()
    except BaseException:
        status = status or 1
    return _flushed(status)


def _flushed(status: int) -> int:
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except BaseException:  # closed, replaced, or past the limit: the judge sees what arrived
            status = status or 120
    return status


def _note_memory(region: wire.Region, error: MemoryError, name: str) -> None:
    """Say so first: describing the error needs memory too."""
    region.write_note(wire.NO_MEMORY, "")
    try:
        region.write_note(wire.NO_MEMORY, source.described(error, name))
    except MemoryError:
        return
