"""Compare solved fields with measured expressions, and learn anatomy from them."""
