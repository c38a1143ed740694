"""Kattis packages of other hands, of the formats `legacy` and `2025-09`: pass–fail problems alone.

    look.py         whether a word names a package, cheaply
    opening.py      a folder or a zip file as a folder: nothing in it leads out of it
    settings.py     its YAML files, read within bounds
    package.py      what problem.yaml says, and why a package is refused
    cases.py        its test files, in order, with the arguments of each for the output validator
    tokens.py       the default output validator
    programs.py     submissions and validators as boxes, whatever their language
    checker.py      one output held against one test file, by either kind of validator
    expected.py     what each of its own submissions should come to
    judging.py      one submission on all test files
    timing.py       the time limit, by the rule of each format

A package is as little trusted as a submission: what it brings is read within bounds, and run contained.
"""
