"""Many people's submissions to many problems: read, judged wherever there is room, kept one by one.

model.py        who hands in what, and the row that comes of it
folder.py, roster.py
                whose file is for which problem; the list of students
standard.py     by what a row is judged
plan.py         which rows are kept, which texts are judged, who gets a copy
run.py          judging them: what is missing is learnt once before, each row is kept at once
work.py         what a worker does: judge one task
store.py        the rows, in one SQLite file beside the class's folder
shards.py, __main__.py
                a class in parts that know nothing of each other, and putting these together
cohort.py       which row counts, and what the class is shown
representatives.py
                the smallest failing cases, for pages
equal.py        which hand-ins of different students are one program; normal.py what is compared
"""
