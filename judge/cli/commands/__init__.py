"""The commands, a module each: `judge NAME` is `command` in NAME.py, imported when it is used.

The table in judge/cli/app.py names them in the order of `judge --help`; what they share is one folder up.
"""
