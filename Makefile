# Every target sets up what it needs: system libraries (.ci/system) and the locked packages in .venv (.ci/setup).

PYTHON := .venv/bin/python

# Settings of another Python must not leak into ours.
unexport PYTHONPATH PYTHONHOME VIRTUAL_ENV

.PHONY: help run test lint format bench check-exports pictures plates lock clean setup setup-display

help:
	@echo "make run     open the editor; without a display, leave pictures and a .glb in output/"
	@echo "make test    lint, types, import rules and all tests"
	@echo "make bench   measure, and write the figures to benchmarks/results/"
	@echo "make check-exports  play exported faces in three.js, Blender and the validators that are installed"
	@echo "make pictures  take the pictures of README and docs anew"
	@echo "make plates    draw docs/action-units.md anew; MEASURED=FILE.npz compares it with measured expressions, too"
	@echo "make lint    only ruff, mypy and the import rules"
	@echo "make format  put the code into ruff's format"
	@echo "make lock    pin the newest allowed packages in requirements.lock"
	@echo "make clean   remove .venv, caches and output/"

run: setup
	@.ci/open

test: setup-display lint
	@.ci/test

lint: setup
	@.venv/bin/ruff check
	@.venv/bin/ruff format --check
	@.venv/bin/mypy
	@.venv/bin/lint-imports

format: setup
	@.venv/bin/ruff check --fix
	@.venv/bin/ruff format

bench: setup-display
	@$(if $(DISPLAY),,.ci/with-display) $(PYTHON) -m benchmarks

check-exports: setup
	@$(PYTHON) -m tests.clients output/clients

pictures: setup-display
	@.ci/with-display $(PYTHON) -m docs.pictures

plates: setup-display
	@.ci/with-display $(PYTHON) -m docs.plates $(MEASURED)

lock: setup
	@.ci/lock

clean:
	rm -rf .venv .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache output benchmarks/results
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

setup:
	@.ci/system run
	@.ci/setup

setup-display:
	@.ci/system test
	@.ci/setup
