"""The Muscles workspace's panel: the tree of muscles, the numbers of those that are selected, and what can be done."""
