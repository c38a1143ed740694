"""JavaScript: a script imports nothing, it requires."""

from __future__ import annotations

import re

from judge.languages.scan import changed, usual_tokens

_NAMES = r"(?>(?:\*\s*+as\s++)?)([\w$]++|\{[^{}]{0,1500}+\})"
_FROM = rf"(?>(?:(?>(?:([\w$]++)\s*+,\s*+)?){_NAMES}\s*+from\s*+)?)"
_IMPORT = rf"""^(?:\xef\xbb\xbf)?[ \t]*+import\s*+{_FROM}("[^"\n]*+"|'[^'\n]*+')"""


def adapted(source: bytes) -> bytes:
    """The source as a script."""
    return changed(source, _IMPORT, _required, usual_tokens("//"))


def _required(found: re.Match[str]) -> str:
    """An import's names as those of constants, on as many lines."""
    of = f"require({found[3]})"
    names = (re.sub(r"(?<![\w$])([\w$]++)\s++as\s", r"\1: ", each) for each in (found[1], found[2]) if each)
    constants = ", ".join(f"{name} = {of}" for name in names)
    made = f"const {constants};" if constants else f"{of};"
    return made + "\n" * (found[0].count("\n") - made.count("\n"))
