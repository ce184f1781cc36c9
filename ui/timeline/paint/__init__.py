"""How the lines of the timeline are drawn: one function for each kind of thing, from values to pixels."""
