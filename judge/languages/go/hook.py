"""Go: neighbours of one type share it, and a type of the submission's own has its own names of fields."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import groupby

from judge.languages.shapes import Shape
from judge.languages.spell import Writer


def parameters(writer: Writer, _shape: Shape) -> str:
    """Those of the function."""
    return ", ".join(_grouped(writer, writer.spec.parameters))


def members(writer: Writer, shape: Shape) -> str:
    """Those of a tuple."""
    return "; ".join(_grouped(writer, zip(_usual(shape), shape.parts, strict=True)))


def _grouped(writer: Writer, named: Iterable[tuple[str, Shape]]) -> Iterable[str]:
    for type_, group in groupby(named, key=lambda each: writer.write("type", each[1])):
        yield f"{', '.join(name for name, _ in group)} {type_}"


def main(writer: Writer, _shape: Shape) -> str:
    """The program's own, where the submission has none."""
    return "" if re.search(r"\bfunc\s++main\s*+\(", writer.spec.text) else "func main() {}"


def finished(driver: str) -> str:
    """The driver, where math/big has a name that no submission takes."""
    return driver.replace("*big.Int", "*judgeBigs.Int")


def put(writer: Writer, _shape: Shape) -> str:
    """The statements that write what was found."""
    answer = writer.spec.answer
    if answer.kind != "optional":
        return _put(writer, answer, "found")
    put = _put(writer, answer.inner, "found")
    return f'if ok {{ {put} }} else {{ judgeOut = append(judgeOut, "null"...) }}'


def _put(writer: Writer, shape: Shape, value: str) -> str:
    if shape.kind == "tuple":
        named = zip(shape.parts, _fields(writer, shape), strict=True)
        parts = "; ".join(f"{_put(writer, part, f'{value}.{field}')}; judgeComma()" for part, field in named)
        return f"judgeOut = append(judgeOut, '['); {parts}; judgeClose()"
    if shape.kind == "list":
        item = f"item{len(value)}"
        each = f"for _, {item} := range {value} {{ {_put(writer, shape.inner, item)}; judgeComma() }}"
        return f"judgeOut = append(judgeOut, '['); {each}; judgeClose()"
    if shape.kind == "dict":
        key, item = f"key{len(value)}", f"item{len(value)}"
        puts = "; judgeComma(); ".join(map(_put, (writer, writer), shape.parts, (key, item)))
        each = f"judgeOut = append(judgeOut, '['); {puts}; judgeClose(); judgeComma()"
        begin = 'judgeOut = append(judgeOut, "{\\"dict\\":["...)'
        end = "judgeClose(); judgeOut = append(judgeOut, '}')"
        return f"{begin}; for {key}, {item} := range {value} {{ {each} }}; {end}"
    if shape.kind == "optional":
        put = _put(writer, shape.inner, f"(*{value})")
        return f'if {value} == nil {{ judgeOut = append(judgeOut, "null"...) }} else {{ {put} }}'
    return f"{writer.write('putter', shape)}({value})"


def _usual(shape: Shape) -> Sequence[str]:
    return [field.capitalize() for field in shape.fields]


def _fields(writer: Writer, shape: Shape) -> Sequence[str]:
    usual = _usual(shape)
    if shape.name not in writer.spec.own:
        return usual
    found = re.search(rf"\b{shape.name}\s++struct\s*+\{{([^{{}}]*+)\}}", writer.spec.text)
    lines = re.split("[;\n]", found[1]) if found else []
    names = (re.match(r"\s*+(\w++(?>(?:\s*+,\s*+\w++)*))\s++\S", line) for line in lines)
    own = [name for each in names if each for name in re.split(r"\s*,\s*", each[1])]
    return own if len(own) == len(usual) else usual
