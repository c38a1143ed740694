"""C: the source is included into the driver. What a function cannot return is written where it is told to.

(T *out) and true or false               an optional answer
(T out[most]) and how many, or -1        a list, or none where the answer is optional
(const T *items, int count)              a parameter that is a list
const char *                             the digits of an integer of any size; one as the answer is a long long
"""

from __future__ import annotations

from collections.abc import Iterator

from judge.languages.shapes import Shape, Unsupported
from judge.languages.spec import Spec as Draft
from judge.languages.spec import joined, listed

_ATOMS = {"real": "double", "int": "long long", "word": "const char *", "big": "const char *"}
_READS = {"real": "judge_real()", "int": "judge_int()", "word": "judge_token()", "big": "judge_token()"}
_PUTS = {
    "real": "judge_put_real",
    "int": "judge_put_int",
    "word": "judge_put_word",
    "big": "judge_put_digits",
}
_MOST = 100_000  # items of an answer


def name_of(shape: Shape) -> str:
    """The type. Raises Unsupported for one that C has no usual form of."""
    if shape.kind not in ("tuple", *_ATOMS):
        raise Unsupported(shape.kind)
    return shape.name or _ATOMS[shape.kind]


def _named(shape: Shape, name: str) -> str:
    """The type and what has it, as C spells pointers."""
    return f"{name_of(shape)} {name}".replace("* ", "*")


def defined(shape: Shape) -> str:
    """The definition of a tuple."""
    fields = (f"{_named(part, field)};" for part, field in zip(shape.parts, shape.fields, strict=True))
    return f"typedef struct {{ {' '.join(fields)} }} {shape.name};"


def declared(draft: Draft) -> str:
    """The function's head."""
    parameters = [word for name, shape in draft.parameters for word in _parameter(name, shape)]
    inner, always = _answer(draft)
    if inner.kind == "list":
        if inner.most is None or inner.most > _MOST:
            raise Unsupported("a list of any length")
        return f"int {draft.entry}({listed([*parameters, _named(inner.inner, f'out[{inner.most}]')])})"
    if always:
        return _named(inner, f"{draft.entry}({listed(parameters)})")
    return f"bool {draft.entry}({listed([*parameters, _named(inner, '*out')])})"


def _answer(draft: Draft) -> tuple[Shape, bool]:
    """What is answered, and whether there always is one. One integer is a long long: most count, or are signs."""
    always = draft.answer.kind != "optional"
    inner = draft.answer if always else draft.answer.inner
    return (Shape("int") if inner.kind == "big" else inner), always


def _parameter(name: str, shape: Shape) -> Iterator[str]:
    if shape.kind == "list":
        yield f"const {_named(shape.inner, f'*{name}')}"
        yield f"int {name}_count"
    else:
        yield _named(shape, name)


def frame(draft: Draft, words: str) -> tuple[str, str]:
    """What stands before the head in a file to begin with, and the body after it."""
    before = [
        "#include <stdbool.h>",
        "#include <stdio.h>",
        "#include <stdlib.h>",
        "",
    ]
    if draft.is_big:
        before.append("// An int of any size comes as the text of its digits.")
    before += map(defined, draft.structs)
    body = f' {{\n    fputs("error: {words}\\n", stderr);\n    abort();\n}}'
    return "\n".join(before).rstrip(), body


def driver(draft: Draft) -> tuple[str, str]:
    """The driver's file name and its text."""
    declared(draft)  # raises for what it does not know
    reads, arguments = [], []
    for name, (_, shape) in zip(draft.arguments, draft.parameters, strict=True):
        if shape.kind == "list":
            inner = name_of(shape.inner)
            reads.append(
                f"int {name}_count = judge_int(); {inner} *{name} = malloc(({name}_count + 1) * sizeof *{name});"
            )
            reads.append(f"for (int i = 0; i < {name}_count; i++) {name}[i] = {_read(shape.inner)};")
            arguments += [name, f"{name}_count"]
        else:
            reads.append(f"{name_of(shape)} {name} = {_read(shape)};")
            arguments.append(name)
    text = _TEMPLATE.replace("@types@", joined(draft.lacking, defined)).replace("@file@", draft.file)
    text = text.replace("@tuples@", joined(draft.structs, _read_and_put))
    return "judge_driver.c", text.replace("@call@", f"{' '.join(reads)} {_call(draft, arguments)}")


def _call(draft: Draft, arguments: list[str]) -> str:
    inner, always = _answer(draft)
    if inner.kind == "list":
        item = name_of(inner.inner)
        return (
            f"static {item} found[{inner.most or 1}]; int n = {draft.entry}({listed([*arguments, 'found'])}); "
            f"if (n < 0) fputs(\"null\", judge_out); else {{ fputc('[', judge_out); for (int i = 0; i < n && i < {inner.most}; i++) "
            f"{{ if (i) fputc(',', judge_out); {_put(inner.inner, 'found[i]')}; }} fputc(']', judge_out); }}"
        )
    if always:
        return f"{name_of(inner)} found = {draft.entry}({listed(arguments)}); {_put(inner, 'found')};"
    call = f"{draft.entry}({listed([*arguments, '&found'])})"
    return (
        f'{name_of(inner)} found = {{0}}; if ({call}) {_put(inner, "found")}; else fputs("null", judge_out);'
    )


def _read(shape: Shape) -> str:
    return f"judge_read_{shape.name}()" if shape.kind == "tuple" else _READS[shape.kind]


def _put(shape: Shape, value: str) -> str:
    return f"{f'judge_put_{shape.name}' if shape.kind == 'tuple' else _PUTS[shape.kind]}({value})"


def _read_and_put(shape: Shape) -> str:
    pairs = list(zip(shape.parts, shape.fields, strict=True))
    reads = " ".join(f"v.{field} = {_read(part)};" for part, field in pairs)
    puts = " fputc(',', judge_out); ".join(f"{_put(part, f'v.{field}')};" for part, field in pairs)
    return f"""static {shape.name} judge_read_{shape.name}(void) {{ {shape.name} v; {reads} return v; }}
static void judge_put_{shape.name}({shape.name} v) {{ fputc('[', judge_out); {puts} fputc(']', judge_out); }}"""


# What reads and writes stands before the source, whose macros and pragmas are none of its business.
_TEMPLATE = r"""#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int dup(int), dup2(int, int); /* not all of unistd.h: the source may call something of its own read or link */
void _exit(int);
static char *judge_at;
static FILE *judge_out;
__attribute__((constructor(101))) static void judge_take_stdout(void) { judge_out = fdopen(dup(1), "w"); dup2(2, 1); }
static double judge_real(void) { return strtod(judge_at, &judge_at); }
static long long judge_int(void) { return strtoll(judge_at, &judge_at, 10); }
static const char *judge_token(void) { while (*judge_at && *judge_at <= ' ') judge_at++; char *from = judge_at; while (*judge_at > ' ') judge_at++; return strndup(from, judge_at - from); }
static void judge_put_digits(const char *v) { fputs(v && *v ? v : "null", judge_out); }
static void judge_put_int(long long v) { fprintf(judge_out, "%lld", v); }
static void judge_put_real(double v) { if (isfinite(v)) fprintf(judge_out, "%.17g", v); else fprintf(judge_out, "{\"type\":\"float\",\"text\":\"%s\"}", isnan(v) ? "nan" : v < 0 ? "-inf" : "inf"); }
static void judge_put_word(const char *v) { if (!v) { fputs("null", judge_out); return; } fputc('"', judge_out); for (; *v; v++) if (*v == '"' || *v == '\\' || *v < 32 || *v > 126) fprintf(judge_out, "\\u%04x", (unsigned char)*v); else fputc(*v, judge_out); fputc('"', judge_out); }
static int judge_drive(void (*answer)(void)) {
    size_t size = 0, room = 1 << 16;
    char *in = malloc(room + 1);
    size_t n;
    while ((n = fread(in + size, 1, room - size, stdin)) > 0) { size += n; if (size == room) in = realloc(in, (room *= 2) + 1); }
    in[size] = 0;
    for (judge_at = in; judge_at < in + size;) {
        long long cases = judge_int(), at_once = judge_int();
        for (judge_at++; cases > 0; cases--) {
            char *line = strchr(judge_at, '\n');
            answer();
            judge_at = line ? line + 1 : in + size;
            if (at_once) fflush(judge_out);
        }
        fflush(judge_out);
    }
    _exit(fclose(judge_out) != 0);
}
@types@
#define main judge_the_learners_main
#include "@file@"
#undef main
#undef int
#undef double
#pragma GCC diagnostic error "-Wincompatible-pointer-types"
#pragma GCC diagnostic error "-Wint-conversion"
@tuples@
static void judge_answer(void) { fputs("[0,", judge_out); @call@ fputs("]\n", judge_out); }
int main(void) { return judge_drive(judge_answer); }
"""
