"""Submissions and validators as boxes: one file or a folder of several, in whatever language that is known.

A single Python file runs in the judge's own fork server, as submissions to katas do; what is compiled, and
Python of several files, is started as a program of its own. Several files are one program in Python (from
`__main__.py` or `main.py`), in C and C++ (all of them are compiled) and in Java.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Sequence
from functools import partial
from pathlib import PurePosixPath
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.languages import NAME as PYTHON
from judge.languages import SUFFIX

if TYPE_CHECKING:
    from judge.languages.model import Language
    from judge.sandbox.boundary import Box
    from judge.sandbox.factory import Boxes
    from judge.sandbox.recipe import Recipe, Sources
    from judge.sandbox.tool import ToolBox

Content = Sequence[tuple[str, bytes]]  # of files by name, which may have folders in it

_OTHER_ENDS = {".py3": SUFFIX, ".C": ".cpp", ".c++": ".cpp"}
_OLD_PYTHON = re.compile(rb"#!.*python2\b")
_STARTS = ("__main__", "main", "Main")
_SCRIPTS = ("build", "run")
_SEVERAL = ("c", "cpp", "java")
_STACK_BYTES = 512 << 20  # at most; the format says that the stack is as large as the memory
_PYTHON_ALLOWANCE = 512 << 20
_CHECK = "import sys; compile(open(sys.argv[1], 'rb').read(), sys.argv[1].rpartition('/')[2], 'exec')"
_START = ("-s", "-B", "-X", "utf8")


class NotRunError(Exception):
    """A program that is not run here, and why."""


class Program(Struct, frozen=True):
    """A program: its name for a person, its files, the one that it starts with first; its language's id."""

    name: str
    files: tuple[tuple[str, bytes], ...]
    id: str = ""

    @property
    def language(self) -> str:
        """The language's name."""
        found = _language(self.id)
        return found.name if found else PYTHON


def program_of(name: str, files: Content) -> Program:
    """The program of these files. Raises NotRunError."""
    if len(files) > 1 and any(path in _SCRIPTS for path, _ in files):
        raise NotRunError("it is built or run by a script of its own, which is not done")
    renamed = [(_usual(path), content) for path, content in files]
    kinds = {path: kind for path, _ in renamed if (kind := _kind(path)) is not None}
    if not kinds:
        raise NotRunError("it is in no language that is known here")
    (first, most), *others = Counter(kinds.values()).most_common()
    if others and others[0][1] == most:
        raise NotRunError("its files are in several languages")
    own = [path for path in kinds if kinds[path] == first]
    language = _language(first)
    if language is None:
        _check_python(renamed, own)
    else:
        _check_installed(language)
    if len(own) > 1 and language is not None and first not in _SEVERAL:
        raise NotRunError(f"several files of {language.name} are not judged as one program")
    start = _start(own)
    ordered = sorted(renamed, key=lambda each: each[0] != start)
    return Program(name, tuple(ordered), first)


def is_one_program(files: Content) -> bool:
    """Whether the files of a folder that somebody names are one program, and not one each."""
    names = [PurePosixPath(_usual(path)) for path, _ in files]
    if any(len(path.parts) == 1 and path.stem in _STARTS for path in names):
        return True
    native = [content for path, content in files if _kind(_usual(path)) in ("c", "cpp")]
    starts = sum(re.search(rb"\bmain\s*\(", content) is not None for content in native)
    return len(native) > 1 and starts == 1


def submission_box(program: Program, boxes: Boxes, memory: int) -> Box:
    """The box that a submission runs in; `memory` bytes bound its stack too."""
    language = _language(program.id)
    if language is None and len(program.files) == 1:
        (name, content), *_ = program.files
        return boxes(content, PurePosixPath(name).name)
    from judge.languages.store import CacheStore
    from judge.sandbox.native import NativeBox

    order = partial(_order, program, min(memory, _STACK_BYTES))
    return NativeBox(
        order, boxes, CacheStore(), idle=False
    )  # limits of a package are those of a whole process


def validator_box(program: Program, boxes: Boxes) -> ToolBox:
    """The box that an output validator runs in."""
    from judge.languages.store import CacheStore
    from judge.sandbox.tool import ToolBox

    return ToolBox(partial(_order, program, _STACK_BYTES), boxes, CacheStore())


def _usual(path: str) -> str:
    """The name with the end that the judge knows for its language."""
    end = PurePosixPath(path).suffix
    return path.removesuffix(end) + _OTHER_ENDS[end] if end in _OTHER_ENDS else path


def _kind(path: str) -> str | None:
    """The id of the language of a file, "" for Python's; None where it is in none."""
    from judge.languages import language_of

    if path.endswith(".py2"):
        raise NotRunError("it is Python 2, which is not judged")
    language = language_of(path)
    if language is not None:
        return language.id
    return "" if path.endswith(SUFFIX) else None


def _language(name: str) -> Language | None:
    if not name:
        return None
    from judge.languages.model import language_called

    return language_called(name)


def _check_python(files: Content, own: Sequence[str]) -> None:
    if any(path in own and _OLD_PYTHON.match(content) for path, content in files):
        raise NotRunError("it is Python 2, which is not judged")


def _check_installed(language: Language) -> None:
    from judge.languages.find import why_not

    why = why_not(language)
    if why:
        raise NotRunError(why)


def _start(own: Sequence[str]) -> str:
    """The file that the program starts with."""
    for stem in _STARTS:
        for path in own:
            if PurePosixPath(path).stem == stem and len(PurePosixPath(path).parts) == 1:
                return path
    return min(own, key=lambda path: (path.count("/"), path))


def _order(program: Program, stack: int) -> tuple[Recipe, Sources]:
    """How it is compiled and run. Raises JudgeError where a tool does not answer."""
    from judge.languages.boxes import recipe_of
    from judge.languages.find import toolchain
    from judge.languages.sources import sources_of
    from judge.sandbox.recipe import Sources

    language = _language(program.id)
    if language is None:
        return _python(), Sources(program.files, program.files[0][0])
    recipe = recipe_of(toolchain(language))
    recipe = recipe._replace(stack=recipe.stack or stack)
    if len(program.files) == 1:
        return recipe, sources_of(language, program.files[0][1])
    units = [path for path, _ in program.files if _kind(path) == program.id]
    if program.id == "java":
        return recipe, Sources(tuple(each for each in program.files if each[0] in units), program.files[0][0])
    steps = tuple(tuple(_each(step, units)) for step in recipe.steps)
    return recipe._replace(steps=steps, key=f"{recipe.key} all"), Sources(program.files, program.files[0][0])


def _each(step: Sequence[str], units: Sequence[str]) -> list[str]:
    """A compiler's command line with all files of the program in place of the one."""
    found: list[str] = []
    for word in step:
        found += [f"{{folder}}/{path}" for path in units] if word == "{source}" else [word]
    return found


def _python() -> Recipe:
    """This interpreter, started by itself, with the modules that are installed for it."""
    from judge.sandbox.recipe import Recipe
    from judge.sandbox.roots import find_roots

    roots = find_roots()
    python = roots.executable
    return Recipe(
        name=PYTHON,
        key=f"{python} {sys.version}",
        steps=((python, *_START, "-c", _CHECK, "{source}"),),
        compile_reads=(),
        compile_runs=(python,),
        compile_environment={},
        keeps=True,
        command=(python, *_START, "{box}/{main}"),
        reads=(),
        runs=(python,),
        environment={
            "PYTHONPATH": ":".join(roots.imports),
            "PYTHONHASHSEED": "0",
            "OPENBLAS_NUM_THREADS": "1",
            "OMP_NUM_THREADS": "1",
        },
        stack=64 << 20,
        allowance=_PYTHON_ALLOWANCE,
        out_of_memory="MemoryError",
        empty=("main.py", b"import sys\n"),
        modules=True,
    )
