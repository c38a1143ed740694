"""Whether what is installed of a language works: its empty program, compiled and run contained."""

from __future__ import annotations

from msgspec.structs import replace

from judge.errors import JudgeError
from judge.languages.boxes import recipe_of
from judge.languages.find import Availability, remedy, toolchain
from judge.languages.model import Language
from judge.sandbox.boundary import Usage
from judge.sandbox.factory import Containment
from judge.sandbox.native import measured
from judge.sandbox.recipe import Files


class _Nothing:
    """A store that keeps nothing: all is made anew."""

    def artifact(self, _key: str) -> Files | None:
        return None

    def keep_artifact(self, _key: str, _files: Files) -> None:
        return None

    def idle(self, _key: str) -> Usage | None:
        return None

    def keep_idle(self, _key: str, _usage: Usage) -> None:
        return None


def tried(language: Language, found: Availability, boxes: Containment) -> Availability:
    """What was found of a language, with whether its empty program compiles and runs in such boxes.

    What is not installed, or does not say its version, stays as it is.
    """
    if found.missing or found.why_not:
        return found
    try:
        measured(recipe_of(toolchain(language)), boxes, _Nothing())
    except JudgeError as fault:
        return replace(found, works=False, why_not=fault.what, remedy=f"repair it, or {remedy(language)}")
    return replace(found, works=True)
