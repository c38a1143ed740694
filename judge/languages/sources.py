"""What of a submission is compiled, and whether it is a function, a class or a whole program.

As in Python: a source that defines the problem's function or class is called, another one is run. What is in
comments and strings defines nothing.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Sequence
from functools import partial
from itertools import islice

from judge.errors import nearest
from judge.languages import NAME
from judge.languages.model import Language, languages
from judge.languages.scan import changed, met, reading, stripped
from judge.languages.shapes import Unsupported
from judge.languages.signature import Signature
from judge.languages.spec import Spec, around, spec_of
from judge.languages.spell import Writer
from judge.sandbox.boundary import SourceFault
from judge.sandbox.recipe import Sources

_UTF16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_CLASS = re.compile(r"\bclass\s+(\w+)")
_PUBLIC_CLASS = re.compile(r"\bpublic\s++(?>(?:(?:final|abstract)\s++)*)class\s++(\w+)")
_CALLED = re.compile(r"\b([A-Za-z_]\w*+)\s*+\(")
_TOKEN = re.compile(r"\w+|[^\w\s]")
_UNSAID = ("const", "&", "std", ":", "final", "public")  # in a head that is declared otherwise and fits
_MOST_NAMES = 10_000  # of functions, one of which may be meant


def sources_of(language: Language, source: bytes, signature: Signature | None = None) -> Sources:
    """The files that a submission is compiled from. Raises JudgeError as `judge.languages.scan.reading`."""
    with reading():
        return _sources_of(language, source, signature)


def _sources_of(language: Language, source: bytes, signature: Signature | None) -> Sources:
    source, text = _kept(language, source), stripped(source, language.tokens)
    own = own_file(language, text, signature)
    whole = Sources(((own, source),), own)
    if source.startswith(_UTF16):
        return whole._replace(fault=SourceFault("it is UTF-16: save it as UTF-8"))
    if signature is None or not signature.entry:
        return whole
    found = _asked(language, text, signature)
    if found:
        try:
            return _called(language, signature, source, text, found.end())
        except Unsupported:
            if signature.is_run and language.main and not _met(language.main, text):
                what = f"{language.name} functions of this problem's types cannot be called: give it a main"
                return whole._replace(fault=SourceFault(what))
    if signature.methods and not (signature.is_run and _met(language.main, text)):
        return whole._replace(fault=_no_class(language, text, signature.entry))
    if not language.main:
        return whole
    if not _met(language.main, text):
        return whole._replace(fault=_neither(language, text, signature.entry))
    return whole


def definition(language: Language, source: bytes, entry: str) -> re.Match[str] | None:
    """Where a source defines what is called `entry` in Python; None where it does not."""
    return defined(language, stripped(source, language.tokens), entry)


def defined(language: Language, text: str, entry: str) -> re.Match[str] | None:
    """The same of a source without comments and strings."""
    return _defined(language, text, entry, is_class=False) or _defined(language, text, entry, is_class=True)


def _defined(language: Language, text: str, entry: str, *, is_class: bool) -> re.Match[str] | None:
    pattern = language.head(entry, is_class=is_class) if language.spelt(entry) in text else ""
    return _met(pattern, text) if pattern else None


def _asked(language: Language, text: str, signature: Signature) -> re.Match[str] | None:
    """Where it defines what the problem asks for."""
    return _defined(language, text, signature.entry, is_class=bool(signature.methods))


def _met(pattern: str, text: str) -> re.Match[str] | None:
    """Where a text first meets a pattern of the description."""
    return next(met(re.compile(pattern), text), None)


def _called(language: Language, signature: Signature, source: bytes, text: str, end: int) -> Sources:
    """The submission's function with the driver that calls it. Raises Unsupported."""
    own = own_file(language, text, signature)
    spec = spec_of(language, signature, text, own)
    writer = Writer(language, spec)
    name, content = writer.driver()
    head = writer.text("head")
    stub = stripped((head + writer.text("body")).encode(), language.tokens)
    empty = "".join(stub.split()) in "".join(text.split())
    declared = writer.text("declared") if spec.methods and "declared" in writer else head
    mismatch = f"{spec.entry} is not declared as the problem says: {declared}"
    other = _undeclared(writer.text("heads").split(";"), spec, text) if "heads" in writer else []
    if spec.methods and other:
        mismatch = f"{spec.entry} must declare: {'; '.join(other)}"
    if spec.own and "struct" in writer:
        types = (writer.text("struct", each) for each in spec.structs if each.name in spec.own)
        mismatch = f"{mismatch}, with {' and '.join(types)}"
    files = ((name, content.encode()), (own, writer.adapted(source)))
    return Sources(files, own, signature.entry, text.count("\n", 0, end) + 1, mismatch, empty=empty)


def _undeclared(heads: Sequence[str], spec: Spec, text: str) -> list[str]:
    """The heads of a class's members that the source lacks, whatever the names of their parameters.

    Those that take other things come first: where there are some, what others return is most likely fine.
    """
    names = {name for _, member in spec.members for name, _ in member.parameters}
    source = " ".join(each for each in _TOKEN.findall(text) if each not in _UNSAID)

    def lacks(head: str, of: str = "") -> bool:
        said = [each for each in _TOKEN.findall(head) if each not in _UNSAID]
        said = said[said.index(of) if of else 0 :]
        return not re.search(" ".join(r"\w+" if each in names else re.escape(each) for each in said), source)

    every = zip(heads, (member.entry for _, member in spec.members), strict=False)
    pairs = [(head, name) for head, name in every if head.strip() != f"{spec.entry}()"]  # every class has it
    taking = [head.strip() for head, name in pairs if lacks(head, name)]
    return taking or [head.strip() for head, _ in pairs if lacks(head)]


def own_file(language: Language, text: str, signature: Signature | None = None) -> str:
    """What the submission's own file is called where it is compiled.

    A public class says so itself; else it is the one with the problem's function, or with the main.
    """
    if "{class}" not in language.file:
        return language.file
    starts = (_asked(language, text, signature) if signature else None, _met(language.main, text))
    holders = (around(text, found.start()) for found in starts if found)
    said = _PUBLIC_CLASS.search(text)
    first = _CLASS.search(text)
    name = said[1] if said else next(filter(None, holders), first[1] if first else "Main")
    return language.file.replace("{class}", name)


def _kept(language: Language, source: bytes) -> bytes:
    """The source without what the language drops, and with what it swaps; places stay where they were."""
    if language.drops:
        source = changed(source, language.drops, _blank, language.tokens)
    for pattern, text in language.swaps:
        source = changed(source, pattern, partial(_swapped, text), language.tokens)
    return source


def _blank(found: re.Match[str]) -> str:
    return re.sub(r"[^\n]", " ", found[0])


def _swapped(text: str, found: re.Match[str]) -> str:
    """The text instead of what was found, as long where that is longer."""
    return text.ljust(len(found[0]))


def why_no_class(language: Language, entry: str) -> str:
    """Why a class cannot be called in a language, and what to do."""
    *names, last = (NAME, *(each.name for each in languages() if each.classes))
    return f"{entry} is a class; in {language.name} none is called: write it in {', '.join(names)} or {last}"


def _no_class(language: Language, text: str, entry: str) -> SourceFault:
    if not language.classes:
        return SourceFault(why_no_class(language, entry))
    wanted = language.spelt(entry)
    names = islice(_CLASS.finditer(text), _MOST_NAMES)
    other = nearest(wanted, dict.fromkeys(found[1] for found in names))
    if other == wanted:
        return SourceFault(f"{wanted} has types that {language.name} is not called with")
    meant = f": write {wanted} for {other}" if other else ""
    return SourceFault(f"it defines no class {wanted}{meant}")


def _neither(language: Language, text: str, entry: str) -> SourceFault:
    wanted = language.spelt(entry)
    method = re.search(rf"\b{re.escape(wanted)}\s*\(", text)
    if method and (holder := around(text, method.start())):
        return SourceFault(f"{wanted} is a method of {holder}: write it as a function")
    calls = islice(_CALLED.finditer(text), _MOST_NAMES)
    other = nearest(wanted, dict.fromkeys(found[1] for found in calls))
    meant = f": write {wanted} for {other}" if other and other != wanted else ""
    lacking = f"neither {wanted} nor main" if "main" in language.main else f"no {wanted}, and reads no input"
    return SourceFault(f"it defines {lacking}{meant}")
