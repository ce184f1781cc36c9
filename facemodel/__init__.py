"""What a face is made of: frozen values and pure functions on them, file formats under ``io``."""
