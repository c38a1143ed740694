"""Why a submission is wrong: the simplest case that breaks it, and how to judge that case again."""

from judge.diagnose.counterexample import Counterexample
from judge.diagnose.shrink import shrink

__all__ = ["Counterexample", "shrink"]
