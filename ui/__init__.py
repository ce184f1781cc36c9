"""The editor and the headless renderer: the only package that knows Qt and VTK.

It asks OpenBLAS for one thread, which must be done before NumPy is first imported: a second one is waited for whenever
the cores are busy, as while solving in the background, and the triangular solves of SuperLU, many small products, take
three times as long with two.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
