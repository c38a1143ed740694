"""Judging a submission from beginning to end, as a value: a job in, a result out, nothing printed.

public.py       `judge(problem, source)` and `run(job)`, for other people's programs
job.py          what is to be judged, and how
session.py      judging many submissions to one problem, with all that they share
executors.py    who does the work: here, or threads
containment.py, diagnosis.py, naming.py
                the boxes; the smallest case that breaks a submission; the mistake's name
stressing.py, replaying.py, routine.py
                fresh cases; one case by its id; a routine of this very process
"""

from judge.judging.job import Job, Terms
from judge.judging.public import judge, run
from judge.judging.session import Session

__all__ = ["Job", "Session", "Terms", "judge", "run"]
