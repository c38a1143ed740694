"""Why a file cannot be run as a program: it is of another kind, or the compiler says why."""

from __future__ import annotations

import codecs
import re
import sys
from keyword import kwlist
from pathlib import Path

from judge.errors import one_slip
from judge.problem import Problem
from judge.problem.solutions import install_command, requirement
from judge.sandbox.boundary import SourceFault

_KINDS = {  # by how they begin
    rb"[^\t -~][\s\S]\r\n": "compiled Python",
    rb"(?i)\s*<(!doctype\s+html|html)\b": "a web page (HTML)",
    rb"%PDF-": "a PDF file",
    rb"PK(\x03\x04|\x05\x06)": "a zip file",
    rb"\x1f\x8b": "a gzip file",
    rb"7z\xbc\xaf": "a 7z file",
    rb"Rar!": "a rar file",
    rb"\{\\rtf": "a rich text file (RTF)",
    rb"\xd0\xcf\x11\xe0": "an old Word file",
    rb"\x89PNG|\xff\xd8\xff": "a picture",
    rb"\x7fELF|MZ|\xca\xfe\xba\xbe": "a compiled program",
}
_NOTEBOOK = re.compile(rb"\s*\{")
_LINES = {  # what a line that is not of the program begins with
    r"<<<<<<<|=======$|>>>>>>> ": "is a merge conflict: keep one of the two versions",
    r"@@ -|\+\+\+ |diff --git ": "is a diff: hand in the file itself",
    r">>> |\.\.\. ": "is a dialog with Python: take the '>>> ' out",
    r"```|~~~": "is a fence of Markdown: take it out",
}


_NEWER = re.compile(r"type \w+.* = |(def|class) \w+\[")  # what Python 3.12 brought
_UNDEFINED = re.compile(r"NameError: name '(\w+)' is not defined")
_NO_MODULE = re.compile(r".*Error: Cannot find module '(\.*/*)([^']*)'", re.DOTALL)  # as node says it
_STARTS = re.compile(r"\b(Lock|Pool|Popen|Process|Queue|fork|spawn\w*|subprocess|system|popen)\b")
_NO_FILE = ("No usable temporary directory", "Read-only file system")


def why_ended(message: str, line: str, submission: str = "") -> str:
    """What ended a program, where the `message` of its language does not say it; `line` is where it stood.

    A `submission` that is the adapter of a library says which version it calls.
    """
    if (unknown := _UNDEFINED.match(message)) and (said := _slipped(line.strip(), unknown[1])):
        return said
    error = message.partition(" (line ")[0]
    if error.startswith(("FileNotFoundError", "PermissionError", "OSError")):
        if _STARTS.search(line):
            return f"{error}. A submission may start no process."
        if any(each in error for each in _NO_FILE):
            return f"{error}. A submission may write no file."
    if absent := _NO_MODULE.match(message):
        if library := "" if absent[1] else requirement(Path(submission)):
            where = "and name its node_modules in $JUDGE_PACKAGES"
            return f"{absent[2]} is not installed: {install_command(library)}, {where}"
        what, bundle = "another file" if absent[1] else "a package", "npx esbuild --platform=node --bundle"
        more = "" if absent[1] else ", or name a node_modules with it in $JUDGE_PACKAGES"
        return f"{absent[2]} is {what}, and a submission is one file. Bundle it: {bundle} a.js{more}"
    return ""


def _slipped(line: str, word: str = "") -> str:
    """Of a statement that begins one slip beside a keyword, which was meant."""
    first = re.match(r"\w*", line)[0]  # type: ignore[index]  # it always matches
    meant = next((each for each in kwlist if one_slip(first, each)), "")
    if meant and word in ("", first) and first not in kwlist:
        return f"{first} is not a word of Python. {meant}?"
    return ""


def other_order(problem: Problem, text: str) -> str:
    """That the parameters are those of the kata in another order; nothing where they are not."""
    names = [each.name for each in problem.parameters]
    defined = re.search(rf"^def {problem.entry}\(([\w, ]*)\)", text, re.M)
    own = re.findall(r"\w+", defined[1]) if defined else names
    if own == names or sorted(own) != sorted(names):
        return ""
    return f"The parameters are ({', '.join(own)}); they are handed over as ({', '.join(names)})."


def why_unreadable(source: bytes, fault: SourceFault | None) -> str:
    """Why the file cannot be run, in one line; `fault` is the compiler's. Nothing where it can be."""
    kind = next((kind for start, kind in _KINDS.items() if re.match(start, source)), "")
    if kind and fault:
        return f"This is {kind}, not a program."
    if _NOTEBOOK.match(source) and b'"nbformat"' in source and b'"cells"' in source:
        return "This is a notebook. Export it: File, Save as, .py"
    return _text(fault, source) if fault else ""


def _text(fault: SourceFault, source: bytes) -> str:
    """Why a source does not compile, in one line."""
    if source.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)) or (
        len(source) > 15 and not any(source[1:16:2])
    ):
        return "the file is UTF-16; save it as UTF-8"
    if "unicode error" in fault.message:
        try:
            source.decode()
        except UnicodeDecodeError as error:
            line = source.count(b"\n", 0, error.start) + 1
            byte = f"0x{source[error.start]:02x}"
            return f"the file is not UTF-8: byte {byte} (line {line}); save it as UTF-8"
    text = fault.text.strip()
    told = next((told for start, told in _LINES.items() if re.match(start, text)), "")
    if told:
        return f"Line {fault.line} {told}."
    message = _slipped(text) or fault.message
    if _NEWER.match(text) and sys.version_info < (3, 12):
        message = "this is Python 3.12; the judge runs {}.{}".format(*sys.version_info)
    place = f"line {fault.line}" if fault.line else ""
    place += f", column {fault.column}" if fault.line and fault.column else ""
    quoted = f": {text[:120]}" if text else ""
    return f"{message} ({place}){quoted}" if place else message
