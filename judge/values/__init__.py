"""Types of answers and of parameters: deciding an answer, showing it, and telling one wrong one from another.

`answers` has what `solve` returns, `atoms` and `types` what types there are, `grammar` the language in which
they are written. Nothing here needs exact numbers before it must ask for them.
"""

from judge.values.answers import AnyOf, Exact, Judged, Real, Run, Tolerance, Words, vector
from judge.values.base import Target, Type
from judge.values.check import Accepted, ExactOf, Outcome, Rejection
from judge.values.grammar import TypeFault, parse
from judge.values.outline import Outline, Usual
from judge.values.wire import Raw

__all__ = [
    "Accepted",
    "AnyOf",
    "Exact",
    "ExactOf",
    "Judged",
    "Outcome",
    "Outline",
    "Raw",
    "Real",
    "Rejection",
    "Run",
    "Target",
    "Tolerance",
    "Type",
    "TypeFault",
    "Usual",
    "Words",
    "parse",
    "vector",
]
