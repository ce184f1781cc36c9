"""A timeline over the small face, with a bit of everything on it."""

import pytest

from app.document import Document
from app.playback import Playhead
from app.timeline.timeline import Timeline
from tests.app.conftest import context as context
from tests.app.conftest import desk as desk
from tests.app.conftest import other_project as other_project
from tests.app.conftest import project as project
from tests.timeline.stage import lively, with_animation


@pytest.fixture
def document(project) -> Document:
    return Document(with_animation(project, lively()))


@pytest.fixture
def timeline(document: Document) -> Timeline:
    return Timeline(document, Playhead(document))
