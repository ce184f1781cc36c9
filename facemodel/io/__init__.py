"""File formats: projects, faces and exports."""
