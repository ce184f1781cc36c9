"""The timeline without a screen: what is chosen on it, its lines, where things snap, and what hands do there."""
