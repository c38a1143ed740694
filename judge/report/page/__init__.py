"""The HTML report: one page that holds everything it shows, for a screen of any size and for paper.

    parts.py      what the page is made of: frozen values, ready to be shown
    record.py     a run's published result, read back
    compose.py    from runs and problems to a page
    checklist.py  the skills
    cases.py      the failing cases worth showing
    told.py       one of them in words and pictures
    plot.py       the time ratio over the attempts
    kills.py      the kill matrix as a table
    render.py     from a page to its bytes, by the templates beside it

Nothing in the page comes from elsewhere or runs: no scripts, no fonts, no images but inline SVG. Whatever a
submission is called, prints or raises is text: escaped by the templates, and without effect even if it were
not, for the page's own policy forbids everything but its one style sheet.
"""
