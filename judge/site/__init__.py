"""The judge in a browser's tab, and the site that brings it there."""
