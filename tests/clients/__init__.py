"""Exports tried in the programs they are for: ``make check-exports``.  Not part of ``make test``, which needs none."""
