"""Why a submission is wrong: the simplest case that breaks it, the name of the mistake."""

from judge.diagnose.counterexample import Counterexample
from judge.diagnose.namer import Namer
from judge.diagnose.shrink import shrink

__all__ = ["Counterexample", "Namer", "shrink"]
