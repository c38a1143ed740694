"""What travels: a function by its name, its argument as bytes, and what came of it as bytes.

A worker calls nothing but what can be imported there, and nothing is unpickled but these three.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any, get_type_hints

import msgspec
from msgspec import Struct

from judge.errors import ExitCode, JudgeError, UsageError
from judge.judging.executors import Held, Raised, told_of


class Answer(Struct, frozen=True):
    """What came of a call: its result, a JudgeError that it raised, or in words what else went wrong."""

    result: msgspec.Raw = msgspec.Raw(b"null")
    fault: str = ""
    where: str | None = None
    remedy: str | None = None
    usage: bool = False
    ended: str = ""


def name_of(work: Callable[..., Any]) -> str:
    """`module:function`. Raises UsageError for what another process could not import by such a name."""
    work = _function(work)
    module, name = work.__module__, work.__qualname__
    if module == "__main__" or "<" in name:
        raise UsageError(f"{module}:{name} cannot be sent", remedy="name a function of a module")
    return f"{module}:{name}"


def packed(item: object) -> bytes:
    """The argument of a call."""
    return msgspec.json.encode(item)


def call(name: str, argument: bytes) -> bytes:
    """Call the function of that name here; what `answer_of` reads. Nothing is raised."""
    try:
        module, _, function = name.partition(":")
        work = getattr(import_module(module), function)
        result = work(msgspec.json.decode(argument, type=_hints(work)[0]))
        answer = Answer(result=msgspec.Raw(msgspec.json.encode(result)))
    except JudgeError as fault:
        usage = fault.exit_code == ExitCode.USAGE
        answer = Answer(fault=fault.what, where=fault.where, remedy=fault.remedy, usage=usage)
    except BaseException as fault:  # SystemExit too: it would end the worker
        answer = Answer(ended=told_of(fault))
    return msgspec.json.encode(answer)


def result_of(work: Callable[..., Any], answer: Answer) -> Any:
    """The result of a call that came to one. Raises JudgeError where that is what it came to."""
    if answer.fault:
        kind = UsageError if answer.usage else JudgeError
        fault = kind(answer.fault, where=answer.where, remedy=answer.remedy)
        if isinstance(work, Held):
            return Raised(fault)
        raise fault
    return msgspec.json.decode(answer.result, type=_hints(_function(work))[1])


def answer_of(parcel: bytes) -> Answer:
    """What `call` has sent."""
    return msgspec.json.decode(parcel, type=Answer)


def _function(work: Callable[..., Any]) -> Callable[..., Any]:
    """The module's function, whose faults are perhaps wanted as results."""
    return work.work if isinstance(work, Held) else work


def _hints(work: Callable[..., Any]) -> tuple[Any, Any]:
    """The type of a function's first argument, and that of its result."""
    hints = get_type_hints(work)
    result = hints.pop("return", Any)
    return next(iter(hints.values()), Any), result
