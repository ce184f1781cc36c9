"""The dialogs of the timeline: how a capture becomes weights, what is said, what sounds look like."""
