"""Transcripts of commands; see play.py."""
