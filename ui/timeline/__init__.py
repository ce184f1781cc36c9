"""The timeline: transport, ruler, lines of keys, events, speech and sound, and the graph of curves."""
