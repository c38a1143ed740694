"""Why a file cannot be run as a program: it is of another kind, or the compiler says why."""

from __future__ import annotations

import codecs
import re

from judge.sandbox.boundary import SourceFault

_KINDS = {  # by how they begin
    b"%PDF-": "a PDF file",
    b"PK\x03\x04": "a zip file",
    b"PK\x05\x06": "a zip file",
    b"\x1f\x8b": "a gzip file",
    b"7z\xbc\xaf": "a 7z file",
    b"Rar!": "a rar file",
    b"{\\rtf": "a rich text file (RTF)",
    b"\xd0\xcf\x11\xe0": "an old Word file",
    b"\x89PNG": "a picture",
    b"\xff\xd8\xff": "a picture",
    b"\x7fELF": "a compiled program",
    b"MZ": "a compiled program",
    b"\xca\xfe\xba\xbe": "a compiled program",
}
_PAGE = re.compile(rb"\s*<(!doctype\s+html|html)\b", re.IGNORECASE)
_COMPILED = re.compile(rb"[^\t -~][\s\S]\r\n")  # Python's own code
_NOTEBOOK = re.compile(rb"\s*\{")
_LINES = {  # what a line that is not of the program begins with
    r"<<<<<<<|=======$|>>>>>>> ": "is a merge conflict: keep one of the two versions",
    r"@@ -|\+\+\+ |diff --git ": "is a diff: hand in the file itself",
    r">>> |\.\.\. ": "is a dialog with Python: take the '>>> ' out",
    r"```|~~~": "is a fence of Markdown: take it out",
}


def why_unreadable(source: bytes, fault: SourceFault | None) -> str:
    """Why the file cannot be run, in one line; `fault` is the compiler's. Nothing where it can be."""
    kind = next((kind for start, kind in _KINDS.items() if source.startswith(start)), "")
    if _PAGE.match(source):
        kind = "a web page (HTML)"
    if _COMPILED.match(source):
        kind = "compiled Python"
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
    place = f"line {fault.line}" if fault.line else ""
    place += f", column {fault.column}" if fault.line and fault.column else ""
    quoted = f": {text[:120]}" if text else ""
    return f"{fault.message} ({place}){quoted}" if place else fault.message
