"""Java: another class beside the submission's; tuples are records unless the submission has classes of its own."""

from __future__ import annotations

import re

from judge.languages.scan import PARAMETERS, met
from judge.languages.shapes import Shape
from judge.languages.spec import Spec as Draft
from judge.languages.spec import around, joined, listed

_ATOMS = {"real": "double", "int": "long", "big": "java.math.BigInteger", "word": "String"}
_BOXED = {"real": "Double", "int": "Long"}
_READS = {"real": "real()", "int": "integer()", "big": "new java.math.BigInteger(token())", "word": "token()"}


def name_of(shape: Shape, *, boxed: bool = False) -> str:
    """The type; an optional value may be null."""
    if shape.packed:
        return f"{_ATOMS[shape.inner.kind]}[]"
    if shape.kind == "list":
        return f"List<{name_of(shape.inner, boxed=True)}>"
    if shape.kind == "optional":
        return name_of(shape.inner, boxed=True)
    return shape.name or (_BOXED.get(shape.kind, "") if boxed else "") or _ATOMS[shape.kind]


def defined(shape: Shape) -> str:
    """The definition of a tuple."""
    fields = listed(f"{name_of(part)} {field}" for part, field in zip(shape.parts, shape.fields, strict=True))
    return f"record {shape.name}({fields}) {{}}"


def declared(draft: Draft) -> str:
    """The function's head."""
    parameters = listed(f"{name_of(shape)} {name}" for name, shape in draft.parameters)
    return f"static {name_of(draft.answer)} {draft.entry}({parameters})"


def frame(draft: Draft, words: str) -> tuple[str, str]:
    """What stands before the head in a file to begin with, and the body after it."""
    before = [
        "import java.util.List;",
        "",
        "class Solution {",
        *(f"    {defined(each)}" for each in draft.structs),
    ]
    body = f' {{\n        throw new UnsupportedOperationException("{words}");\n    }}\n}}'
    return "\n".join(before), body


def driver(draft: Draft) -> tuple[str, str]:
    """The driver's file name and its text."""
    reads = " ".join(
        f"var {argument} = {_read(draft, shape)};"
        for argument, (_, shape) in zip(draft.arguments, draft.parameters, strict=True)
    )
    puts = joined(draft.structs, lambda shape: _put(draft, shape), "\n        ")
    text = _TEMPLATE.replace("@types@", "import java.util.List;\n" + joined(draft.lacking, defined)).replace(
        "@puts@", puts
    )
    return "JudgeDriver.java", text.replace(
        "@call@", f"{reads} Object found = {_holder(draft)}.{draft.entry}({listed(draft.arguments)});"
    )


def _holder(draft: Draft) -> str:
    """The submission's class that has the function: of several so called one with as many parameters."""
    head = re.compile(rf"[\w>\]]\s++{draft.entry}\s*+({PARAMETERS})[^;{{}}()]{{0,500}}+\{{")
    found = sorted(met(head, draft.text), key=lambda each: _count(each[1]) != len(draft.parameters))
    return around(draft.text, found[0].start()) if found else ""


def _count(parameters: str) -> int:
    """How many parameters those in brackets are, as Java lists them: a type's own stand between < and >."""
    parameters = parameters[1:-1]
    if not parameters.strip():
        return 0
    depth, count = 0, 1
    for sign in re.findall("[<>,]", parameters):
        if sign == ",":
            count += not depth
        else:
            depth += 1 if sign == "<" else -1
    return count


def _where(draft: Draft, shape: Shape) -> str:
    """The type's name outside the submission's classes, in one of which it may be defined."""
    found = re.search(rf"\b(?:record|class)\s++{shape.name}\b", draft.text)
    inside = found and around(draft.text, found.start())
    return f"{inside}.{shape.name}" if inside else shape.name


def _read(draft: Draft, shape: Shape) -> str:
    if shape.kind == "tuple":
        return f"new {_where(draft, shape)}({listed(_read(draft, part) for part in shape.parts)})"
    if shape.packed:
        return "reals()" if shape.inner.kind == "real" else "integers()"
    if shape.kind == "list":
        return f"list(() -> {_read(draft, shape.inner)})"
    if shape.kind == "optional":
        return f"none() ? null : {_read(draft, shape.inner)}"
    return _READS[shape.kind]


def _put(draft: Draft, shape: Shape) -> str:
    """How a tuple is written: the parts of a record are asked, those of a class are its fields."""
    record = shape.name not in draft.own or re.search(rf"\brecord\s++{shape.name}\b", draft.text)
    parts = listed(f"v.{field}{'()' if record else ''}" for field in shape.fields)
    return (
        f"else if (value instanceof {_where(draft, shape)} v) put(java.util.Arrays.<Object>asList({parts}));"
    )


_TEMPLATE = r"""@types@
final class JudgeDriver {
    private static byte[] in;
    private static int at;
    private static final StringBuilder out = new StringBuilder();
    private static String token() {
        while (at < in.length && in[at] <= ' ') at++;
        int from = at;
        while (at < in.length && in[at] > ' ') at++;
        return new String(in, 0, from, at - from);
    }
    private static double real() { return Double.parseDouble(token()); }
    private static long integer() { return Long.parseLong(token()); }
    private static boolean none() { int before = at; if (token().equals("none")) return true; at = before; return false; }
    private static <T> List<T> list(java.util.function.Supplier<T> read) {
        var found = new java.util.ArrayList<T>();
        for (long left = integer(); left > 0; left--) found.add(read.get());
        return found;
    }
    private static double[] reals() { var found = new double[(int) integer()]; for (int i = 0; i < found.length; i++) found[i] = real(); return found; }
    private static long[] integers() { var found = new long[(int) integer()]; for (int i = 0; i < found.length; i++) found[i] = integer(); return found; }
    private static void put(Object value) {
        if (value == null) out.append("null");
        else if (value instanceof Float single) put((double) single);
        else if (value instanceof Double d && !Double.isFinite(d)) out.append("{\"type\":\"float\",\"text\":\"").append(Double.isNaN(d) ? "nan" : d < 0 ? "-inf" : "inf").append("\"}");
        else if (value instanceof Number) out.append(value);
        else if (value instanceof Iterable<?> items) { out.append('['); String gap = ""; for (Object item : items) { out.append(gap); put(item); gap = ","; } out.append(']'); }
        else if (value.getClass().isArray()) { out.append('['); for (int i = 0; i < java.lang.reflect.Array.getLength(value); i++) { if (i > 0) out.append(','); put(java.lang.reflect.Array.get(value, i)); } out.append(']'); }
        else if (value instanceof java.util.Optional<?> held) put(held.orElse(null));
        @puts@
        else if (value instanceof String word) text(word);
        else { out.append("{\"type\":"); text(value.getClass().getSimpleName()); out.append(",\"text\":"); text(String.valueOf(value)); out.append('}'); }
    }
    private static void text(String word) {
        out.append('"');
        for (char c : word.toCharArray()) if (c == '"' || c == '\\' || c < 32 || c > 126) out.append(String.format("\\u%04x", (int) c)); else out.append(c);
        out.append('"');
    }
    private static void answer() throws Throwable { @call@ out.append("[0,"); put(found); }
    public static void main(String[] words) throws java.io.IOException {
        var answers = new java.io.FileOutputStream(java.io.FileDescriptor.out);
        System.setOut(System.err);
        in = System.in.readAllBytes();
        for (String first = token(); !first.isEmpty(); first = token()) {
            boolean atOnce = integer() == 1;
            for (long cases = Long.parseLong(first); cases > 0; cases--) {
                int start = out.length();
                while (at < in.length && in[at] <= ' ') at++;
                int line = at;
                while (line < in.length && in[line] != '\n') line++;
                try { answer(); }
                catch (OutOfMemoryError fault) { throw fault; }
                catch (Throwable fault) { out.setLength(start); out.append("[1,"); text((fault instanceof ExceptionInInitializerError && fault.getCause() != null ? fault.getCause() : fault).toString()); }
                at = line;
                out.append("]\n");
                if (atOnce || cases == 1) { answers.write(out.toString().getBytes()); out.setLength(0); }
            }
        }
        System.exit(0);
    }
}
"""
