"""Programs in other languages, held for a test: boxes, limits, and which languages this machine has."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from judge.languages import find
from judge.languages.boxes import AnyBoxes
from judge.languages.model import language_called
from judge.languages.signature import Signature
from judge.sandbox import Containment, Limits, Stop
from judge.values.grammar import parse

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)


def sources(folder: str) -> dict[str, str]:
    """The sources of that folder of the fixtures, by their files' names."""
    found = sorted((Path(__file__).parents[1] / "fixtures" / "native" / folder).iterdir())
    return {path.name: path.read_bytes().decode() for path in found}


def need(name: str) -> None:
    """Skip the test where the language is not installed here."""
    language = language_called(name)
    assert language is not None
    if missing := find.missing(language):
        pytest.skip(f"{missing[0]} is not installed")
    if why := find.why_not(language):
        pytest.skip(why)


def box_of(name: str, source: str, *, level: str | None = None, signature: Signature | None = None) -> Any:
    """A box for a source, its language by the file's name."""
    need(name.rpartition(".")[2])
    return AnyBoxes(Containment(level), signature)(source.encode(), name)


def fault_of(name: str, source: str, **more: Any) -> Any:
    """Why it does not compile."""
    with box_of(name, source, **more) as box:
        return box.inspect().fault


def ran(name: str, source: str, stdin: bytes = b"", limits: Limits = LIMITS, **more: Any) -> Any:
    """What came of one run of a program that compiles."""
    with box_of(name, source, **more) as box:
        assert box.inspect().fault is None, box.inspect().fault
        return box.run_program(stdin, limits)


def signature(answer: str, **parameters: str) -> Signature:
    """The signature of a function `mirror_all`, its types as a problem writes them."""
    types = tuple((name, parse(type_)) for name, type_ in parameters.items())
    return Signature("mirror_all", types, parse(answer, Path(__file__).parents[2] / "problems" / "types"))


def called(name: str, source: str, given: Signature, calls: Any, **more: Any) -> Any:
    """The replies to the calls of that function; `more` are limits."""
    with box_of(name, source, signature=given) as box:
        inspection = box.inspect()
        assert inspection.fault is None, inspection.fault
        assert inspection.defines("mirror_all")
        return box.call("mirror_all", calls, LIMITS._replace(**more)).replies


def answers(*arguments: Any, **more: Any) -> list[Any]:
    """The answers to the calls, all of which are answered."""
    found = called(*arguments, **more)
    assert all(reply.stop is Stop.ANSWERED for reply in found), found
    return [reply.answer for reply in found]
