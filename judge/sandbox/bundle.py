"""The code of a seed as one file, so that no path of the package is needed inside it.

A descriptor carries marshal data: (modules, config). The interpreter inside, the same as the judge's, reads
it, makes the modules under their own names and is the seed, which forgets those names again.
"""

from __future__ import annotations

import marshal
import sys
from functools import cache
from importlib.machinery import SourceFileLoader
from importlib.util import find_spec
from types import CodeType
from typing import Any

_ALWAYS = (  # in the order in which they import one another
    "judge.sandbox.encode",
    "judge.sandbox.inside.again",
    "judge.sandbox.inside.wire",
    "judge.sandbox.inside.source",
    "judge.sandbox.inside.child",
    "judge.sandbox.inside.confine",
    "judge.sandbox.inside.unseen",
    "judge.sandbox.inside.server",
    "judge.sandbox.inside.seed",
)
_ON_LINUX = "judge.sandbox.inside.linux"

# argv: the bundle's descriptor, the channel's
BOOTSTRAP = """\
import marshal, sys
from types import ModuleType
bundle, channel = map(int, sys.argv[1:])
with open(bundle, "rb") as file:
    modules, config = marshal.loads(file.read())
for name in ("judge", "judge.sandbox", "judge.sandbox.inside"):
    sys.modules[name] = ModuleType(name)
    sys.modules[name].__path__ = []
for name, code in modules:
    module = sys.modules[name] = ModuleType(name)
    package, _, own = name.rpartition(".")
    setattr(sys.modules[package], own, module)
    exec(code, module.__dict__)
module.start(channel, config)
"""


def pack(config: dict[str, Any]) -> bytes:
    """The bundle's bytes; the last of its modules starts it. `config` holds plain values only."""
    first = [_ON_LINUX] if sys.platform == "linux" else []
    return marshal.dumps((tuple(map(_module, (*first, *_ALWAYS))), config))


@cache
def _module(name: str) -> tuple[str, CodeType]:
    return name, _code_of(name)


def _code_of(name: str) -> CodeType:
    """A module's code as its file has it: pytest imports judge through a hook that rewrites its asserts."""
    spec = find_spec(name)
    loader: Any = spec.loader if spec else None
    if spec and spec.origin and spec.origin.endswith(".py"):
        loader = SourceFileLoader(name, spec.origin)
    code = loader.get_code(name) if loader else None
    if not isinstance(code, CodeType):
        raise ImportError(f"no code for {name}", name=name)
    return _as(f"{name.replace('.', '/')}.py", code)


def _as(path: str, code: CodeType) -> CodeType:
    """The code as of a file of that name: where the judge lies is in the memory of no submission."""
    inner = tuple(_as(path, each) if isinstance(each, CodeType) else each for each in code.co_consts)
    return code.replace(co_filename=path, co_consts=inner)
