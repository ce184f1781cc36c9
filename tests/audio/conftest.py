from tests.app.conftest import document as document
from tests.app.conftest import project as project
