"""The page that exports an animation: as a film, a model that plays, or numbered meshes."""
