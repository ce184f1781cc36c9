"""How the mandible moves, and how the skin follows it along its arc."""
