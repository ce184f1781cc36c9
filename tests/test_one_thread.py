"""What the program asks of the machine before anything is loaded."""

import subprocess
import sys
from pathlib import Path

import pytest

PRODUCT = """
import sys, ui.launch
import numpy as np
from scipy.linalg.blas import sgemv
sgemv(1.0, np.ones((200_000, 8), dtype=np.float32), np.ones(8, dtype=np.float32))
print(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("Threads:")))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="counts the threads of its own process as Linux tells them")
def test_a_large_product_is_made_by_one_thread(repository: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
        monkeypatch.delenv(name, raising=False)
    done = subprocess.run([sys.executable, "-c", PRODUCT], cwd=repository, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "1"
