"""What Risorius costs in time and memory, each figure beside the yardstick it is held against; see `benchmarks.report`.

``python -m benchmarks`` measures everything, ``python -m benchmarks solving frames`` only what is named.
"""
