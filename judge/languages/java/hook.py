"""Java: which of the submission's classes has the function, and which its own types."""

from __future__ import annotations

import re
from itertools import accumulate

from judge.languages.scan import PARAMETERS, met
from judge.languages.shapes import Shape
from judge.languages.spec import around
from judge.languages.spell import Writer


def holder(writer: Writer, _shape: Shape) -> str:
    """The submission's class that has the function: of several so called one with as many parameters."""
    spec = writer.spec
    head = re.compile(rf"[\w>\]]\s++{spec.entry}\s*+({PARAMETERS})[^;{{}}()]{{0,500}}+\{{")
    found = sorted(met(head, spec.text), key=lambda each: _count(each[1]) != len(spec.parameters))
    return around(spec.text, found[0].start()) if found else ""


def _count(parameters: str) -> int:
    """How many parameters those in brackets are: a type's own stand between < and >."""
    signs = re.findall("[<>,]", parameters)
    depths = accumulate({"<": 1, ">": -1}.get(sign, 0) for sign in signs)
    commas = sum(sign == "," and not depth for sign, depth in zip(signs, depths, strict=True))
    return commas + 1 if parameters[1:-1].strip() else 0


def where(writer: Writer, shape: Shape) -> str:
    """The type's name outside the submission's classes, in one of which it may be defined."""
    return _outside(writer, shape.name)


def made(writer: Writer, _shape: Shape) -> str:
    """The same of the class that is asked for."""
    return _outside(writer, writer.spec.entry)


def _outside(writer: Writer, name: str) -> str:
    found = re.search(rf"\b(?:record|class)\s++{name}\b", writer.spec.text)
    inside = found and around(writer.spec.text, found.start())
    return f"{inside}.{name}" if inside else name


def asked(writer: Writer, shape: Shape) -> str:
    """The parts of a tuple: those of a record are asked, those of a class are its fields."""
    spec = writer.spec
    is_record = shape.name not in spec.own or re.search(rf"\brecord\s++{shape.name}\b", spec.text)
    return ", ".join(f"v.{field}{'()' if is_record else ''}" for field in shape.fields)
