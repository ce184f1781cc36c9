"""Anatomy in words: where muscles run and how tissue is made, by landmarks, the same for every head."""
