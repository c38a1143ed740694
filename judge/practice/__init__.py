"""Practice: what was judged before, what it shows that a person can do, and what to do next.

    history.py      every run and its source, the files that were started, the help that was taken
    database.py     opening the SQLite file behind it, and its faults as one line each
    migrations.py   the numbered steps from an empty file to today's tables

    stub.py         the file a kata begins with; contract.py writes a statement as its docstring
    model.py        the solution that is explained afterwards
    saves.py        noticing that a file was saved
    check.py        what a setter has to get right for all of this

It stands above `diagnose` and below `report`, and prints nothing.
"""
