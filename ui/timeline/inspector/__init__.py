"""The fields at the right of the timeline: numbers for whatever is chosen, and parameters of what is done to curves."""
