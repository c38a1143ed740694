"""Drawing any Picture: as SVG, and in braille characters for a terminal."""
