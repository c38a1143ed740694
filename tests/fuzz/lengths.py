"""Texts that grow: whatever reads a text from outside in the judge's own process takes time as it grows.

A text is a token again and again, perhaps after another one that opens something. Each reader is given texts
of a thousand characters, of four thousand and so on, until one takes some time: that may be at most so many
times what a quarter of it takes. What takes the square takes sixteen times as long.
"""

from __future__ import annotations

import gc
import random
import signal
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache, partial
from itertools import count
from pathlib import Path
from typing import Any

from msgspec.structs import replace

from judge.batch.duplicates import normal_form
from judge.batch.roster import read_students
from judge.data.parse import read_case
from judge.errors import JudgeError
from judge.languages import scan
from judge.languages.model import language_of_file, languages
from judge.languages.signature import Signature
from judge.languages.sources import sources_of
from judge.problem import Verdict
from judge.problem.find import find_problem, fitting_problems, meant_problem, signs
from judge.problem.toml import line_of, parse_toml
from judge.report import formats, tell
from judge.run import entry, printed, program
from judge.run.result import judge_fault
from judge.sandbox import calls, native
from judge.sandbox import compile as compiling
from judge.sandbox.boundary import Inspection
from judge.sandbox.recipe import Sources
from judge.values import reading
from judge.values.grammar import TypeFault, parse

SIZES = (1_000, 4_000, 16_000, 64_000, 256_000)  # characters
ENOUGH = 0.015  # CPU seconds from which on a time tells how it grows
FLAT, MOST = 6.0, 10.0  # times what a quarter of the text takes: certainly linear, and certainly not
ENDLESS = 30.0  # CPU seconds after which a reader is said not to end

_ENTRY = Signature("line_count", (("r", parse("real")), ("A", parse("point"))), parse("[vec2; 0..2]"))
A_C = Sources((("a.c", b""),), "a.c")
_FILES = {
    "c": "a.c", "cpp": "a.cpp", "go": "a.go", "java": "A.java", "javascript": "a.js", "rust": "a.rs",
    "pypy": "a.pypy", "python": "a.py",
}  # fmt: skip
_TOKENS = (
    *("\"'`\\()[]{}<>,;.:=+-*/%#@!&|$ \t\n\r\0é1a_"),
    '"""', "'''", "//", "/*", "*/", "/**/", "#!", "#![", "->", "=[", "=/[", "= /", "\\\\", "\u0301\u0316",
    "\\\n", "\n ", "\r\n", "\n#", "\n//", ") ", "()", "[]", "{}", "( ", "a(", "a b", "a,", "a: ", "a=1\n",
    "x line_count(", "x line_count()", "auto line_count()->", "line_count ", "> lineCount(a<",
    "int lineCount(", ") throws a", ") noexcept", "fn line_count(", "func lineCount(", "function lineCount",
    "const lineCount", "def line_count(", "\ndef a(", "\n def a(", "\nline_count:", "async def ", "lambda:",
    "class ", "main ", "a if b else ", "public ", "final ", "abstract ", "record Pt", "struct Pt {",
    "Pt struct{", "\nPt ", "typedef ", "} Pt", "\nimport {", "import a,", "import * as ", "\nexport {",
    "\npackage a", "package ", "private", "a as ", 'R"(', 'r#"', 'R"a', "throws ", "f'{a}'", "not ", "1+",
    "a.", "():", "if a:\n ", "from ",
)  # fmt: skip


def repeated(token: str, before: str = "", after: str = "") -> Callable[[int], str]:
    """Texts of so many characters."""
    return lambda size: before + token * (max(0, size - len(before) - len(after)) // len(token)) + after


def halved(one: str, other: str, before: str = "", after: str = "") -> Callable[[int], str]:
    """Texts of so many characters, the second half of them of the other token."""
    return lambda size: repeated(one, before)(size // 2) + repeated(other, "", after)(size // 2)


def counted(token: str, before: str = "") -> Callable[[int], str]:
    """Texts of the token with another number in it each time, for names that are all different."""

    def text(size: int) -> str:
        parts, length = [before], len(before)
        for number in count():
            parts.append(token.replace("N", str(number)))
            length += len(parts[-1])
            if length > size:
                break
        return "".join(parts)

    return text


@dataclass(frozen=True)
class Case:
    """A reader with a text that grows."""

    reader: str
    what: str
    text: Callable[[int], str]


@dataclass(frozen=True)
class Growth:
    """How long a reader took for texts of these sizes, in CPU seconds."""

    case: Case
    size: int
    before: float  # of a quarter of it
    seconds: float

    @property
    def steep(self) -> bool:
        """Whether it grows more than a text does."""
        return self.seconds > MOST * self.before

    def __str__(self) -> str:
        told = f"{self.before:.3f} s and {self.seconds:.3f} s" if self.before else "no end"
        return f"{self.case.reader}: {self.case.what}: {told} up to {self.size:,} characters"


# -- readers -----------------------------------------------------------------------------------------------


@cache
def _place() -> Path:
    """A folder for readers of files; it goes with the process."""
    folder = tempfile.TemporaryDirectory(prefix="judge-tests-")
    _kept.append(folder)
    return Path(folder.name)


_kept: list[Any] = []


def _problem(name: str, text: str) -> None:
    found = signs(text.encode(), name)
    fitting_problems(found)
    meant_problem(found)


def _sources(name: str, text: str) -> None:
    language = language_of_file(name)
    assert language is not None
    for source in (text, f"{text}\n{_FUNCTIONS[name]}", f"{_FUNCTIONS[name]}\n{text}"):
        sources_of(language, source.encode(), _ENTRY)


_FUNCTIONS = {
    "a.c": "int line_count(double r, Pt A, Pt out[2]) {",
    "a.cpp": "std::vector<Pt> line_count(double r, Pt A) {",
    "a.go": "func lineCount(r float64, A Pt) []Pt {",
    "A.java": "static List<Pt> lineCount(double r, Pt A) {",
    "a.js": "function lineCount(r, A) {",
    "a.rs": "fn line_count(r: f64, a: Pt) -> Vec<Pt> {",
    "a.pypy": "\ndef line_count(r, A):",
}


def _normal(name: str, text: str) -> None:
    normal_form(text.encode(), name, "line_count")


def _failed(text: str) -> None:
    """An exception's message, wherever it is looked at."""
    result = judge_fault("count", "a.py", text)
    for verdict in (Verdict.CE, Verdict.RTE):
        tell.fault_place(replace(result, verdict=verdict))
    program._CHOKED.match(text)
    entry._NO_MODULE.match(text)
    formats.annotation(result, b"", find_problem("count"), {})
    list(formats.editor_lines(result, b"", find_problem("count")))
    formats.junit([result])


def _annotated(text: str) -> None:
    tell.annotated_place(judge_fault("count", "a.py", ""), text.encode(), "line_count")
    names = tuple((word, 1) for word in dict.fromkeys(text.split()))[:10_000]
    entry.missing_entry(find_problem("count"), Inspection(None, names), f"{text} stdin".encode())


def _complaint(text: str) -> None:
    for complaint in ("", *(each.compiling.complaint for each in languages())):
        for before in ("", "a.c:1:"):
            said = compiling.wire_lines(before + text)
            compiling._told(said, A_C, complaint, 1)
    for each in languages():
        own = each.file.replace("{class}", "A")
        said = compiling.wire_lines(f"{own}:1:1: warning: {text}")
        compiling._warned(said, Sources(((own, b""),), own), each.compiling.warning)


def _printed(text: str) -> None:
    native.placed(native.last_words(text.encode()), text.encode(), A_C)
    printed.text_of(text.encode())
    calls.replies(text.encode(), 100)


def _answers(text: str) -> None:
    for form in ("real", "int", "[point; 0..2]", "word(left|right)", "[int]", "real?"):
        type_ = parse(form)
        reading.read_line(type_, text)


def _case(text: str) -> None:
    problem = find_problem("count")
    read_case(problem, text[:20_000])


def _type(text: str) -> None:
    with suppress(TypeFault):
        parse(text)


def _students(text: str) -> None:
    path = _place() / "students.csv"
    path.write_text(f"id;name\n{text}", encoding="utf-8", newline="")
    read_students(path)


def _readers() -> dict[str, Callable[[str], None]]:
    found: dict[str, Callable[[str], None]] = {}
    for language, name in _FILES.items():
        found[f"{language} problem"] = partial(_problem, name)
        found[f"{language} normal"] = partial(_normal, name)
        if language != "python":
            found[f"{language} sources"] = partial(_sources, name)
    return {
        **found,
        "message": _failed,
        "annotation": _annotated,
        "complaint": _complaint,
        "printed": _printed,
        "answers": _answers,
        "case": _case,
        "students": _students,
        "type": _type,
        "toml lines": partial(line_of, path=("a", "b", 7, "c")),
        "toml": partial(parse_toml, name="cards.toml"),
    }


READERS = _readers()
_TOML = ("[a", "[[a", ".a", "'a'", '"a"', "a.", "a .", "a=", "\na = 1", '\\"', '"\\"".')
_OWN_TOKENS = {
    "complaint": (
        "a.c:1: ", "a.c:1:1: error: ", ":1", ": warning", "required from here\n", "/a", "symbol: ", "^",
        'File "a', "undefined reference ",
    ),
    "message": (
        "(line 1)", "index out of range", "after 0 lines", "IndexError: ", "InvalidOperation",
        "ConversionSyntax", "ModuleNotFoundError: No module named 'a",
    ),
    "toml lines": _TOML,
    "toml": _TOML,
}  # fmt: skip
_FILLING = (" ", "a", "1", "\n", ",", ") ", "'a", "{")  # what goes on and on after something is opened
_DIFFERENT = (
    "def nN(a): pass\n", "nN = 1\n", "int nN(int a) { return 1; }\n", "nN(", "line_countN ", "nN,", "nN: N\n",
    "[nN]\n", "struct nN { nN a; };\n",
)  # fmt: skip


def cases(reader: str, pairs: int, seed: int = 0) -> Iterator[Case]:
    """Each token alone, numbered ones, and so many pairs: both again and again, or one before the other."""
    signs_of = (*_TOKENS, *_OWN_TOKENS.get(reader, ()))
    chance = random.Random(f"{reader}:{seed}")
    for token in signs_of:
        yield Case(reader, repr(token), repeated(token))
    for token in _DIFFERENT:
        yield Case(reader, repr(token), counted(token))
    for _ in range(pairs):
        one, other = chance.choice(signs_of), chance.choice((*signs_of, *_FILLING * 9))
        if other not in _FILLING or chance.random() < 0.3:
            yield Case(reader, repr(one + other), repeated(one + other))
        else:
            yield Case(reader, f"{one!r} before {other!r}", repeated(other, one))


# -- measuring ---------------------------------------------------------------------------------------------


class _NoEndError(Exception):
    pass


@contextmanager
def _bounded() -> Iterator[None]:
    """A reader that does not end is ended; in the main thread, which alone hears signals."""

    def end(*_: object) -> None:
        raise _NoEndError

    before = signal.signal(signal.SIGPROF, end)
    signal.setitimer(signal.ITIMER_PROF, ENDLESS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def _seconds(read: Callable[[str], None], text: str, tries: int = 1) -> float:
    """The least CPU seconds of some tries."""
    least = float("inf")
    for _ in range(tries):
        gc.collect(0)
        began = time.thread_time()
        with suppress(JudgeError):
            read(text)
        least = min(least, time.thread_time() - began)
    return least


def growth(case: Case) -> Growth | None:
    """How the time of a case grows, where it takes enough to be told.

    What seems steep is asked of a longer text too, for a reader may look ahead so far and no further.
    """
    read, found, size = READERS[case.reader], None, 100
    gc.disable()
    limit, scan.SECONDS = scan.SECONDS, float("inf")  # which would end what is to be measured
    try:
        with _bounded():
            _seconds(read, case.text(size))  # what it needs is there then
            for size in SIZES:
                text = case.text(size)
                if _seconds(read, text) < ENOUGH:
                    continue
                steep = found is not None and found.steep
                found = Growth(case, size, _seconds(read, case.text(size // 4), 3), _seconds(read, text, 3))
                if found.seconds <= FLAT * found.before or (steep and found.steep):
                    break
    except _NoEndError:
        return Growth(case, size, 0.0, float("inf"))
    finally:
        gc.enable()
        scan.SECONDS = limit
    return found


def steep(reader: str, pairs: int, seed: int = 0) -> Iterator[Growth]:
    """The cases of a reader whose time grows more than the text."""
    for case in cases(reader, pairs, seed):
        found = growth(case)
        if found is not None and found.steep:
            found = growth(case)  # the machine may have been busy
            if found is not None and found.steep:
                yield found
