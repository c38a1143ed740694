"""Types of answers and parameters by composition: each reads, shows, decides and compares its own values.

`judge.values.tree` has the exact answers, `grammar` the language that types are written in. Nothing here
needs exact numbers before it must ask for them.
"""

from judge.values.grammar import TypeFault, parse
from judge.values.likeness import Outline, Usual
from judge.values.outcome import Accepted, Outcome, Rejection, Words
from judge.values.tolerance import Tolerance
from judge.values.tree import AnyOf, Enclosure, Exact, Judged, Real, Run, vector
from judge.values.type import ExactOf, Number, Raw, Target, Type

__all__ = [
    "Accepted",
    "AnyOf",
    "Enclosure",
    "Exact",
    "ExactOf",
    "Judged",
    "Number",
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
