"""Rust: what is copied, the fields of the submission's own types, and its inner attributes."""

from __future__ import annotations

import re

from judge.languages.shapes import Shape, Unsupported
from judge.languages.spec import is_big
from judge.languages.spell import Writer

_HEAD = re.compile(
    rb"(?:\xef\xbb\xbf)?(?>(?:\s++|#!\[[^\]]*+\]|//[^\n]*+|/\*(?>(?:[^*]++|\*(?!/))*)\*/)*)", re.DOTALL
)


def returned(writer: Writer, shape: Shape) -> str:
    """The answer's type, within which digits would be text."""
    if is_big(shape):
        raise Unsupported("big")
    return str(writer.write("type", shape))


def copied(_writer: Writer, shape: Shape) -> str:
    """What a tuple is derived from beside the usual."""
    return ", Copy" if _copies(shape) else ""


def _copies(shape: Shape) -> bool:
    return shape.kind in ("real", "int", "bool") or (shape.kind == "tuple" and all(map(_copies, shape.parts)))


def gets(writer: Writer, shape: Shape) -> str:
    """How the fields of a tuple are read."""
    return ", ".join(f"{field}: Get::get(w)" for field in _fields(writer, shape))


def puts(writer: Writer, shape: Shape) -> str:
    """How they are written."""
    return " out.push(','); ".join(f"self.{field}.put(out);" for field in _fields(writer, shape))


def _fields(writer: Writer, shape: Shape) -> tuple[str, ...]:
    """Their names: of a type of the submission's own its own, or only places."""
    found = re.search(rf"\bstruct\s++{shape.name}\s*+(?:\{{([^{{}}]*+)|(\())", writer.spec.text)
    if shape.name not in writer.spec.own or found is None:
        return shape.fields
    places = tuple(map(str, range(len(shape.parts))))
    own = places if found[2] else tuple(re.findall(r"\b(\w++)\s*+:", found[1]))
    return own if len(own) == len(shape.parts) else shape.fields


def adapted(source: bytes) -> bytes:
    """The submission's file as one that is included: without what only a whole crate may begin with."""
    head = _HEAD.match(source)
    assert head is not None
    plain = re.sub(rb"#!\[([^]\[]*+)\]", rb"/*\1 */", head[0])
    return re.sub(rb"(//|/\*)!", rb"\1 ", plain) + source[head.end() :]
