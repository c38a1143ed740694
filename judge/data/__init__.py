"""Test data: building cases, proving promises, pinning and caching them."""

from judge.data.cache import cache_folder
from judge.data.load import load_data
from judge.data.model import GroupData, ProblemData

__all__ = ["GroupData", "ProblemData", "cache_folder", "load_data"]
