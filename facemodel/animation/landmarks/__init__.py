"""A performance of landmarks, as trackers of face meshes see them, on a face of ours."""

from facemodel.animation.landmarks.solving import captured
from facemodel.animation.landmarks.track import MESH, WITH_IRISES, LandmarkTrack

__all__ = ["MESH", "WITH_IRISES", "LandmarkTrack", "captured"]
