"""Circles, and lines, segments and rays that meet them."""
