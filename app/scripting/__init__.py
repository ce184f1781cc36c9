"""The console and scripts: Python of the user's own, over the commands that the mouse uses.

This is the one place where Risorius runs text as code, and only text that a person types or chooses to run; projects
and all other files are data for ever (`tests.test_architecture`).
"""

from app.scripting.console import Console, Outcome, run_script

__all__ = ["Console", "Outcome", "run_script"]
