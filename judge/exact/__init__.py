"""Exact numbers and line-circle geometry over integers. Knows nothing of judging."""
