"""Many people's submissions to many problems: read, judged wherever there is room, kept one by one.

model.py        who submits what, and the row that comes of it
folder.py       whose file is for which problem; zips and notebooks are opened
platforms.py    what learning platforms call the files; who of a list is meant
roster.py       the list of students
plan.py         which rows are kept, which texts are judged, who gets a copy
classroom.py    judging them, each row kept at once; the smallest failing cases for pages
work.py         what a worker does: judge one task
cluster.py      workers of a dask cluster
store.py        the rows, in one SQLite file beside the class's folder
shards.py       a class in parts that know nothing of each other, and putting these together
cohort.py       which row counts, and what the class is shown
duplicates.py   which submissions of different students are one program
"""
