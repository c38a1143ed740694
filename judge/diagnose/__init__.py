"""Saying why a submission is wrong: the mistakes that people make, and recognising them."""

from judge.diagnose.mistakes import Mistake, known_mistakes
from judge.diagnose.namer import Namer

__all__ = ["Mistake", "Namer", "known_mistakes"]
