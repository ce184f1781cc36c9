"""JSON as a person likes to read it."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any


def readable(document: Mapping[str, Any]) -> bytes:
    """Indented JSON with lists of plain numbers on one line each; every float comes back to the last bit."""
    text = json.dumps(document, indent=1, ensure_ascii=False)
    # A raw line break never stands inside a JSON string, so this touches lists only.
    return re.sub(r"\[\n\s*([-+.\deE,\s]+?)\s*\]", lambda m: f"[{' '.join(m[1].split())}]", text).encode()
