"""Docks: they show a document and turn gestures into its intents."""
