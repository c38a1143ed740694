"""Boxes for submissions in any language, by the end of the file's name."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from judge.languages import language_of

if TYPE_CHECKING:
    from judge.languages.find import Toolchain
    from judge.languages.signature import Signature
    from judge.sandbox.boundary import Box
    from judge.sandbox.factory import Containment
    from judge.sandbox.recipe import Recipe, Sources


class AnyBoxes:
    """A `BoxFactory`: Python's boxes for Python, others for what is in another language.

    `signature` is that of the problem whose function a source may define; without it each is a program.
    """

    def __init__(self, boxes: Containment, signature: Signature | None = None) -> None:
        self.boxes = boxes
        self._signature = signature

    def __call__(self, source: bytes, name: str) -> Box:
        """A box for this source; `name` is its file's. Raises as `Containment`."""
        language = language_of(name)
        if language is None:
            return self.boxes(source, name)
        from judge.languages.find import toolchain
        from judge.languages.sources import sources_of
        from judge.languages.store import CacheStore
        from judge.sandbox.native import NativeBox

        def order() -> tuple[Recipe, Sources]:
            return recipe_of(toolchain(language)), sources_of(language, source, self._signature)

        return NativeBox(order, self.boxes, CacheStore())


def recipe_of(found: Toolchain) -> Recipe:
    """What the sandbox has to know of a language with its tools."""
    from judge.languages.sources import own_file
    from judge.sandbox.recipe import Recipe
    from judge.sandbox.visible import package_folders

    language = found.language
    compiling, running = language.compiling, language.running
    environment, packages = dict(running.environment), []
    if running.packages:
        name, variable = running.packages
        packages = package_folders(name)
        environment[variable] = os.pathsep.join(packages)
    files = [(path.name, path.read_bytes()) for path in Path(language.folder).glob("checks.*")]
    return Recipe(
        name=language.name,
        key=found.key,
        steps=tuple(map(found.filled, compiling.steps)),
        compile_reads=found.filled(compiling.reads),
        compile_runs=found.filled(compiling.runs),
        compile_environment=_environment(found, compiling.environment),
        keeps=compiling.keeps,
        command=found.filled(running.command),
        reads=(*found.filled(running.reads), *packages),
        runs=found.filled(running.runs),
        environment=_environment(found, environment),
        stack=running.stack << 20,
        allowance=running.allowance << 20,
        out_of_memory=running.out_of_memory,
        empty=(own_file(language, language.empty), language.empty.encode()),
        complaint=compiling.complaint,
        warning=compiling.warning,
        checks=tuple(map(found.filled, compiling.checks)),
        finds=compiling.finds,
        help=(*found.files, *files),
    )


def _environment(found: Toolchain, words: Mapping[str, str]) -> dict[str, str]:
    return dict(zip(words, found.filled(words.values()), strict=True))
