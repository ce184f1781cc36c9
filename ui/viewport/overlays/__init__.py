"""What can be drawn with the skin; every overlay adds and removes its own actors."""
