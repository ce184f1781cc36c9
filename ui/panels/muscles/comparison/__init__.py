"""The models of a muscle side by side on the face: pictures, figures, and a click that chooses one."""
