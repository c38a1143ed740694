"""Boxes for submissions in any language, by the end of the file's name; what a driver is made from."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from judge.languages import language_of
from judge.values.atoms import IntType, Type
from judge.values.types import atoms

if TYPE_CHECKING:
    from judge.languages.find import Toolchain
    from judge.sandbox.boundary import Box
    from judge.sandbox.levels import Containment
    from judge.sandbox.recipe import Recipe, Sources
    from judge.values.calls import Method

_LONG = 1 << 63


class Signature(NamedTuple):
    """What a driver is made from: the function's name in the problem, its parameters, its answer's type.

    With `methods` it is a class, and the parameters are its constructor's. `is_run` says whether a program
    can be asked in its place.
    """

    entry: str
    parameters: tuple[tuple[str, Type], ...]  # names and types
    answer: Type
    big: bool = False  # whether a parameter's integers need more than 64 bits
    methods: tuple[Method, ...] = ()
    is_run: bool = True


class _Named(Protocol):
    @property
    def name(self) -> str: ...
    @property
    def type(self) -> Any: ...
    @property
    def low(self) -> Fraction: ...
    @property
    def high(self) -> Fraction: ...


class _Declared(Protocol):
    @property
    def entry(self) -> str: ...
    @property
    def answer(self) -> Type: ...
    @property
    def parameters(self) -> Sequence[_Named]: ...
    @property
    def methods(self) -> bool: ...
    @property
    def formatted(self) -> bool: ...


def signature_of(problem: _Declared) -> Signature:
    """The signature of a problem's function, or class."""
    own = problem.parameters[: -1 if problem.methods else None]
    methods: tuple[Method, ...] = problem.parameters[-1].type.methods if problem.methods else ()
    bounds = [bound for each in own if not each.type.measured for bound in (each.low, each.high)]
    taken = [atom for method in methods for _, type_ in method.takes for atom in atoms(type_)]
    bounds += [
        Fraction(bound or 0) for each in taken if isinstance(each, IntType) for bound in (each.low, each.high)
    ]
    big = any(abs(bound) >= _LONG for bound in bounds)
    parameters = tuple((each.name, each.type) for each in own)
    is_run = problem.formatted or not problem.methods
    return Signature(problem.entry, parameters, problem.answer, big, methods, is_run)


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
