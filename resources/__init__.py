"""Data that ships with Risorius (faces, muscle atlas, FACS table, icons, themes) and a way to find it."""
