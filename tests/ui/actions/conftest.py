"""A small document with all that actions work on, solved at once."""

from tests.app.conftest import context as context
from tests.app.conftest import desk as desk
