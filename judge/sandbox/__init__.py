"""Containment: running a source that nobody trusts. Knows nothing of problems."""
