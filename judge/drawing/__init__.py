"""Drawing any Picture: as SVG, and in braille characters for a terminal.

shapes.py     what a drawing is made of
clip.py       cutting to a panel
labels.py     placing labels
plain.py      tables and graphs
lengths.py    lengths as a person reads them
svg.py, braille.py      drawing.css has the colours
"""

from judge.drawing.plain import graph, table
from judge.drawing.shapes import Picture, Role

__all__ = ["Picture", "Role", "graph", "table"]
