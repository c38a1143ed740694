"""The commands: `judge NAME` is the click command of that name in the module that judge/cli/table.py names.

It is imported when it is used. What the commands share is one folder up.
"""
