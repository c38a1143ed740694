"""Why a submission is wrong: the simplest case that breaks it, the name of the mistake."""

from judge.diagnose.counterexample import Counterexample
from judge.diagnose.mistakes import Mistake, known_mistakes
from judge.diagnose.namer import Namer
from judge.diagnose.shrink import shrink

__all__ = ["Counterexample", "Mistake", "Namer", "known_mistakes", "shrink"]
