"""The record of all behaviour: what the judge says today, kept as text, and how today's differs from it.

    python -m tests.record                   compare everything, by meaning
    python -m tests.record programs --only count
    python -m tests.record --write           keep what the judge says now

programs.py     every program of every kata: verdict, failing groups, smallest case, names, thresholds
transcripts.py  commands with what they show: `--json`, help pages, refusals, screens at three widths
pictures.py     digests of the pictures of two cases of every group
packages.py     digests of the files of exported packages
steady.py       results without the noise of a machine, judged once and kept
compare.py      differences by meaning

The record is in tests/golden/record.
"""
