"""Composing action units and emotions: pure functions from frozen projects to frozen projects."""
