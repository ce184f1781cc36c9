"""How examples of properties are drawn: the same ones on every machine and in every run, unless asked otherwise.

``pytest --hypothesis-profile=wild`` draws at random, and remembers in ``.hypothesis`` what failed.
"""

from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

REPEATABLE = "repeatable"
WILD = "wild"


def register() -> None:
    """Register both ways, and take the repeatable one; neither depends on how fast a machine is."""
    plain = settings.get_profile("default")
    timeless = {"deadline": None, "print_blob": True, "suppress_health_check": [HealthCheck.too_slow]}
    settings.register_profile(REPEATABLE, plain, derandomize=True, database=None, **timeless)
    settings.register_profile(WILD, plain, **timeless)
    settings.load_profile(REPEATABLE)


def repeatable() -> bool:
    """Tell whether the profile in use draws the same examples each time."""
    return bool(settings.default.derandomize)


def hold_still() -> None:
    """Draw without looking at what is loaded.

    Hypothesis likes to draw numbers and texts that stand in the sources of the loaded modules. Which ones are loaded
    depends on the tests that ran before in the same process, and so would all examples, although their seeds are fixed.
    """
    if repeatable():
        providers._get_local_constants = providers.Constants
