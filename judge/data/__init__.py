"""Test data: cases drawn, proved, solved, pinned and cached."""
