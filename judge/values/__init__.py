"""Types of answers and of parameters: deciding an answer, showing it, and telling one wrong one from another.

`answers` has what `solve` returns, `atoms` and `types` what types there are, `grammar` the language in which
they are written. The names below are imported when they are asked for: who lists problems decides no answer.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from judge.values.answers import AnyOf as AnyOf
    from judge.values.answers import Exact as Exact
    from judge.values.answers import Judged as Judged
    from judge.values.answers import Real as Real
    from judge.values.answers import Run as Run
    from judge.values.answers import Tolerance as Tolerance
    from judge.values.answers import Words as Words
    from judge.values.answers import vector as vector
    from judge.values.base import Target as Target
    from judge.values.base import Type as Type
    from judge.values.check import Accepted as Accepted
    from judge.values.check import ExactOf as ExactOf
    from judge.values.check import Outcome as Outcome
    from judge.values.check import Rejection as Rejection
    from judge.values.grammar import TypeFault as TypeFault
    from judge.values.grammar import parse as parse
    from judge.values.outline import Outline as Outline
    from judge.values.outline import Usual as Usual
    from judge.values.wire import Raw as Raw

_FROM = {
    **dict.fromkeys(("AnyOf", "Exact", "Judged", "Real", "Run", "Tolerance", "Words", "vector"), "answers"),
    **dict.fromkeys(("Target", "Type"), "base"),
    **dict.fromkeys(("Accepted", "ExactOf", "Outcome", "Rejection"), "check"),
    **dict.fromkeys(("TypeFault", "parse"), "grammar"),
    **dict.fromkeys(("Outline", "Usual"), "outline"),
    "Raw": "wire",
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in _FROM:
        raise AttributeError(f"module 'judge.values' has no attribute {name!r}")
    return getattr(import_module(f"judge.values.{_FROM[name]}"), name)
