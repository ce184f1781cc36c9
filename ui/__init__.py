"""The editor and the headless renderer: the only package that knows Qt and VTK."""
