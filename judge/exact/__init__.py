"""Exact numbers over integers. Knows nothing of judging."""

from judge.exact.surd import Surd

__all__ = ["Surd"]
