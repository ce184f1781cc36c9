"""The bone under a face as something to edit: where it lies, how deep, what is imported; pure functions."""
