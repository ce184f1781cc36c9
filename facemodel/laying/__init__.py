"""Laying muscles: pure functions from frozen muscles to frozen muscles, for whatever hand or script asks for them."""
