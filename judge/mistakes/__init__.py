"""The mistakes that people make in a problem: read, rendered as programs, recognised in a submission."""
