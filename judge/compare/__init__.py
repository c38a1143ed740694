"""Deciding answers exactly: acceptance intervals, reasons, the text of program mode."""
