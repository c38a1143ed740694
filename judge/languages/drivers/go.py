"""Go: the driver is a second file of the package; its init comes after the submission's own, and ends it all."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from judge.languages.scan import changed, usual_tokens
from judge.languages.shapes import Shape, atom
from judge.languages.spec import Spec as Draft
from judge.languages.spec import joined, listed, small

_ATOMS = {"real": "float64", "int": "int", "big": "*big.Int", "word": "string"}
_PACKAGE = r"\b(package\s++)\w++"
_PUTS = {"real": "judgePutReal", "int": "judgePutInt", "word": "judgePutWord", "big": "judgePutWhole"}
_READS = {"real": "judgeReal()", "int": "judgeInt()", "big": "judgeBig()", "word": "judgeToken()"}


def name_of(shape: Shape) -> str:
    """The type; an optional value is a pointer."""
    if shape.kind in ("list", "optional"):
        return f"{'[]' if shape.kind == 'list' else '*'}{name_of(shape.inner)}"
    return shape.name or atom(_ATOMS, shape)


def defined(shape: Shape) -> str:
    """The definition of a tuple."""
    named = [(field.capitalize(), part) for field, part in zip(shape.fields, shape.parts, strict=True)]
    return f"type {shape.name} struct{{ {'; '.join(_grouped(named))} }}"


def _grouped(named: Iterable[tuple[str, Shape]]) -> Iterator[str]:
    """Names with their types; neighbours of one type share it, as is usual."""
    for type_, group in groupby(named, key=lambda each: name_of(each[1])):
        yield f"{listed(name for name, _ in group)} {type_}"


def declared(draft: Draft) -> str:
    """The function's head: an optional answer is a value and whether there is one."""
    answer = small(draft.answer)
    named = f"({name_of(answer.inner)}, bool)" if answer.kind == "optional" else name_of(answer)
    return f"func {draft.entry}({listed(_grouped(draft.parameters))}) {named}"


def frame(draft: Draft, words: str) -> tuple[str, str]:
    """What stands before the head in a file to begin with, and the body after it."""
    types = [*map(defined, draft.structs)]
    imports = ['import "math/big"', ""] if "*big.Int" in declared(draft) + "".join(types) else []
    before = ["package main", "", *imports, *types]
    return "\n".join(before).rstrip(), f' {{\n\tpanic("{words}")\n}}'


def driver(draft: Draft) -> tuple[str, str]:
    """The driver's file name and its text."""
    reads = "\n\t".join(
        f"{argument} := {_read(shape)}"
        for argument, (_, shape) in zip(draft.arguments, draft.parameters, strict=True)
    )
    optional = draft.answer.kind == "optional"
    call = f"{'found, ok' if optional else 'found'} := {draft.entry}({listed(draft.arguments)})"
    fields = {each.name: _fields(draft, each) for each in draft.structs}
    put = _put(draft.answer.inner if optional else draft.answer, "found", fields)
    put = f'if ok {{ {put} }} else {{ judgeOut = append(judgeOut, "null"...) }}' if optional else put
    text = _TEMPLATE.replace("@types@", joined(draft.lacking, defined)).replace(
        "@puts@", f'{reads}\n\t{call}\n\tjudgeOut = append(judgeOut, "[0,"...)\n\t{put}'
    )
    big = any("*big.Int" in each for each in (declared(draft), *map(defined, draft.structs)))
    text = text.replace("@big@", _BIG if big else "").replace(
        "@imports@", 'judgeBigs "math/big"' if big else ""
    )
    text = text.replace("*big.Int", "*judgeBigs.Int")
    main = "" if re.search(r"\bfunc\s++main\s*+\(", draft.text) else "func main() {}"
    return "judge_driver.go", text.replace("@main@", main)


def adapted(source: bytes) -> bytes:
    """The submission's file beside the driver: of the same package, whatever it calls its own."""
    return changed(source, _PACKAGE, lambda found: f"{found[1]}main", usual_tokens("//"))


def _read(shape: Shape) -> str:
    if shape.kind == "tuple":
        return f"{shape.name}{{{listed(map(_read, shape.parts))}}}"
    if shape.kind in ("list", "optional"):
        make = "judgeList" if shape.kind == "list" else "judgeOptional"
        return f"{make}(func() {name_of(shape.inner)} {{ return {_read(shape.inner)} }})"
    return _READS[shape.kind]


def _fields(draft: Draft, shape: Shape) -> tuple[str, ...]:
    """What the fields of a tuple are called: a type of the submission's own has its own names."""
    usual = tuple(field.capitalize() for field in shape.fields)
    if shape.name not in draft.own:
        return usual
    found = re.search(rf"\b{shape.name}\s++struct\s*+\{{([^{{}}]*+)\}}", draft.text)
    lines = re.split("[;\n]", found[1]) if found else []
    names = (re.match(r"\s*+(\w++(?>(?:\s*+,\s*+\w++)*))\s++\S", line) for line in lines)
    own = tuple(name for each in names if each for name in re.split(r"\s*,\s*", each[1]))
    return own if len(own) == len(usual) else usual


def _put(shape: Shape, value: str, fields: Mapping[str, Sequence[str]]) -> str:
    """The statements that write a value; `fields` are those of each tuple, by its name."""
    if shape.kind == "tuple":
        named = zip(shape.parts, fields[shape.name], strict=True)
        parts = [_put(part, f"{value}.{field}", fields) for part, field in named]
        return f"judgeOut = append(judgeOut, '['); {'; '.join(f'{part}; judgeComma()' for part in parts)}; judgeClose()"
    if shape.kind == "list":
        item = f"item{len(value)}"
        put = _put(shape.inner, item, fields)
        return f"judgeOut = append(judgeOut, '['); for _, {item} := range {value} {{ {put}; judgeComma() }}; judgeClose()"
    if shape.kind == "optional":
        put = _put(shape.inner, f"(*{value})", fields)
        return f'if {value} == nil {{ judgeOut = append(judgeOut, "null"...) }} else {{ {put} }}'
    return f"{_PUTS[shape.kind]}({value})"


_BIG = """
func judgeBig() *big.Int {
	word := judgeToken()
	if len(word) <= 18 { n, _ := judgeConv.ParseInt(word, 10, 64); return judgeBigs.NewInt(n) }
	n, _ := new(judgeBigs.Int).SetString(word, 10)
	return n
}
func judgePutWhole[T int | int64 | int32 | *big.Int](v T) { // where it is a count, an int is what is returned
	switch n := any(v).(type) {
	case *big.Int:
		if n == nil { judgeOut = append(judgeOut, "null"...) } else { judgeOut = n.Append(judgeOut, 10) }
	case int: judgePutInt(n)
	case int64: judgePutInt(n)
	case int32: judgePutInt(n)
	}
}
"""
_TEMPLATE = r"""package main

import (
	judgeJSON "encoding/json"; judgeFmt "fmt"; judgeIO "io"; judgeMath "math"; judgeOS "os"
	judgeDebug "runtime/debug"; judgeConv "strconv"; judgeStrings "strings"; @imports@
)

@types@
@main@

var judgeIn string
var judgeOut []byte

func judgeToken() string {
	i := 0
	for i < len(judgeIn) && judgeIn[i] <= ' ' { i++ }
	j := i
	for j < len(judgeIn) && judgeIn[j] > ' ' { j++ }
	word := judgeIn[i:j]
	judgeIn = judgeIn[j:]
	return word
}
func judgeReal() float64 { v, _ := judgeConv.ParseFloat(judgeToken(), 64); return v }
func judgeInt() int { v, _ := judgeConv.Atoi(judgeToken()); return v }
@big@
func judgeList[T any](read func() T) []T {
	found := make([]T, judgeInt())
	for i := range found { found[i] = read() }
	return found
}
func judgeOptional[T any](read func() T) *T {
	before := judgeIn
	if judgeToken() == "none" { return nil }
	judgeIn = before
	v := read()
	return &v
}
func judgeComma() { judgeOut = append(judgeOut, ',') }
func judgeClose() {
	if judgeOut[len(judgeOut)-1] == ',' { judgeOut = judgeOut[:len(judgeOut)-1] }
	judgeOut = append(judgeOut, ']')
}
func judgePutWord(v string) { text, _ := judgeJSON.Marshal(v); judgeOut = append(judgeOut, text...) }
func judgePutInt[T int | int64 | int32](v T) { judgeOut = judgeConv.AppendInt(judgeOut, int64(v), 10) }
func judgePutReal(v float64) {
	if judgeMath.IsNaN(v) || judgeMath.IsInf(v, 0) {
		judgeOut = append(judgeOut, judgeFmt.Sprintf("{\"type\":\"float\",\"text\":\"%v\"}", v)...)
	} else {
		judgeOut = judgeConv.AppendFloat(judgeOut, v, 'g', -1, 64)
	}
}
func judgeAnswer(start int) {
	defer func() {
		if fault := recover(); fault != nil {
			judgeOut = append(judgeOut[:start], "[1,"...)
			judgePutWord(judgeFmt.Sprint(fault))
		}
	}()
	@puts@
}
func init() {
	answers := new(judgeOS.File)
	*answers = *judgeOS.Stdout
	*judgeOS.Stdout = *judgeOS.Stderr // for whoever holds it already, too
	judgeDebug.SetMaxStack(64 << 20)
	var all judgeStrings.Builder
	if input, fault := judgeOS.Stdin.Stat(); fault == nil { all.Grow(int(input.Size())) }
	judgeIO.Copy(&all, judgeOS.Stdin)
	judgeIn = all.String()
	for {
		cases, fault := judgeConv.Atoi(judgeToken())
		if fault != nil { break }
		atOnce := judgeInt()
		for ; cases > 0; cases-- {
			line, rest := judgeLine()
			judgeIn = line
			judgeAnswer(len(judgeOut))
			judgeIn = rest
			judgeOut = append(judgeOut, "]\n"...)
			if atOnce == 1 || cases == 1 {
				if _, fault := answers.Write(judgeOut); fault != nil { judgeOS.Exit(1) }
				judgeOut = judgeOut[:0]
			}
		}
	}
	judgeOS.Exit(0)
}
func judgeLine() (string, string) {
	for len(judgeIn) > 0 && judgeIn[0] <= ' ' { judgeIn = judgeIn[1:] }
	if end := judgeStrings.IndexByte(judgeIn, '\n'); end >= 0 { return judgeIn[:end], judgeIn[end+1:] }
	return judgeIn, ""
}
"""
