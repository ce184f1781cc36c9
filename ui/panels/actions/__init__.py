"""The Actions workspace's panel: action units made of muscles and the jaw, and expressions made of action units."""
