"""Edits of an animation: pure functions from values to values.

Keys are named by the row that they lie in and their place in it, see `selection`.  Whatever edits many keys at once
returns the animation and the same keys, named by where they are now.  Rows of locked tracks are left as they are.
"""
