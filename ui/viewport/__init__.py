"""What is seen: the skin and what lies behind it, lights, camera, overlays, picking; on any `pyvista.Plotter`."""
