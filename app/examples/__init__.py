"""Finished projects that a newcomer opens to see what can be done; they are made on demand, so that none gets old."""

from app.examples.demo import demo_project
from app.examples.example import Example
from app.examples.examples import EXAMPLES, examples_folder, find_example

__all__ = ["EXAMPLES", "Example", "demo_project", "examples_folder", "find_example"]
