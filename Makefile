# SPDX-License-Identifier: Apache-2.0
# The whole project from a fresh machine with git, make and python3 (3.11 or newer, with venv).

PYTHON ?= python3
VENV   ?= .venv
BIN    := $(VENV)/bin
STAMP  := $(VENV)/.installed
DOCS_STAMP := $(VENV)/.installed-docs
JOBS   ?= 2
EXAMPLE := examples/backlash-oscillator
export PYTHONUTF8 := 1
# tests and benchmarks start hundreds of processes: without bytecode each one compiles the package again
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.PHONY: help install demo test warmup lint pytest nojit stock newest-numba bench validate viewer glue docs clean

help:
	@echo "make demo      install, compile, run the main example, write a report"
	@echo "make test      style, import contracts, types, all tests"
	@echo "make bench     speed table, build/bench.json"
	@echo "make validate  published cases as one page, docs/validation.md; long studies"
	@echo "make viewer    the scripts of the 3-D scene and of plots (needs Node.js 20)"
	@echo "make glue      the functions of FMUs, from C to LLVM text (needs the extra fmi)"
	@echo "make docs      the documentation as a site, build/docs/html"
	@echo "make newest-numba  the first five minutes of README in a fresh environment with the newest Numba"
	@echo "make lint      style, import contracts and types only"
	@echo "make clean     remove build products (keeps $(VENV))"

# ------------------------------------------------------------------------------------------------ install

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit("pitchpoint needs Python 3.11 or newer; call make PYTHON=python3.12" if sys.version_info < (3, 11) else 0)'
	@$(PYTHON) -m venv $(VENV) || { rm -rf $(VENV); echo "python3 -m venv failed; on Debian and Ubuntu: apt install python3-venv"; exit 1; }

$(STAMP): pyproject.toml constraints.txt | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e ".[dev]"
	@touch $@

$(DOCS_STAMP): $(STAMP)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e ".[dev,docs]"
	@touch $@

install: $(STAMP)

# --------------------------------------------------------------------------------------------------- demo

# each command compiles what it uses: the whole of `warmup` would take several times as long
demo: $(STAMP)
	@mkdir -p build/demo
	$(BIN)/pitchpoint run $(EXAMPLE)/model.yaml --scenario steady -o build/demo/steady.h5
	$(BIN)/pitchpoint sweep $(EXAMPLE)/model.yaml --scenario sweep -o build/demo/sweep.h5
	$(BIN)/pitchpoint report $(EXAMPLE)/model.yaml build/demo/steady.h5 build/demo/sweep.h5 -o build/demo/report.html
	@echo
	@echo "The report is ready, open it in a browser: $(CURDIR)/build/demo/report.html"

# -------------------------------------------------------------------------------------------------- tests

# types are checked while kernels are compiled, and the short runs share the processors: each leaves one idle
test: $(STAMP)
	@$(MAKE) --no-print-directory -j 2 --output-sync=target lint warmup
	@$(MAKE) --no-print-directory pytest
	@$(MAKE) --no-print-directory -j 2 --output-sync=target nojit stock

# every worker of the tests would compile the kernels for itself
warmup: $(STAMP)
	$(BIN)/pitchpoint warmup -q

lint: $(STAMP)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports --no-logo
	$(BIN)/mypy

# studies run in validate; tests/conftest.py puts long files first, and workers keep this order: files of many
# small tests fill what these leave; examples in docstrings of geometry and contact are among the tests of these
pytest: warmup
	$(BIN)/python -m pytest -q -n $(JOBS) --dist loadfile --no-loadscope-reorder -m "not study" tests --doctest-modules src/pitchpoint --ignore=src/pitchpoint/geometry --ignore=src/pitchpoint/contact

# the same kernels as plain Python: what the compiler accepts must also be right without it; some parameter sets
# of each test, all of them in validate
nojit: $(STAMP)
	NUMBA_DISABLE_JIT=1 $(BIN)/python -m pytest -q -n $(JOBS) --dist loadfile -m nojit --thin 8 tests

# the same through the public interface of Numba alone, which untested versions of Numba get
stock: $(STAMP)
	PITCHPOINT_STOCK_NUMBA=1 $(BIN)/python -m pytest -q -n $(JOBS) --dist loadfile -m stock tests

newest-numba: $(STAMP)
	$(BIN)/python -m tests.support.fresh_environment build/newest-numba

# ---------------------------------------------------------------------------------------- bench, validate

# the peers are wanted but not needed: without them their rows stay empty
bench: $(STAMP)
	@mkdir -p build
	-@$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[peers]"
	$(BIN)/python -m benchmarks --json build/bench.json

validate: $(STAMP)
	$(BIN)/python tests/validation/render.py --output docs/validation.md
	$(BIN)/python -m pytest -q -n $(JOBS) -m "study and not validation" tests
	NUMBA_DISABLE_JIT=1 $(BIN)/python -m pytest -q -n $(JOBS) --dist loadfile -m nojit tests

# the built script is in the repository: nobody who does not change it needs Node.js
viewer:
	cd viewer && npm ci && node build.mjs

# a fresh environment each time: notebooks and the reference follow from the package, which Sphinx does not watch
# the text is in the repository: nobody who does not change the C files needs ziglang
glue: $(STAMP)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[fmi]"
	$(BIN)/python -m pitchpoint.io.fmu.glue.make

docs: $(DOCS_STAMP)
	$(BIN)/python docs/generate.py build/docs/source
	$(BIN)/python -m sphinx -b html -E -W --keep-going -q -j $(JOBS) build/docs/source build/docs/html
	$(BIN)/python docs/check_site.py build/docs/html
	@echo "The documentation is ready, open it in a browser: $(CURDIR)/build/docs/html/index.html"

clean:
	rm -rf build dist .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis
	find src tests benchmarks examples docs -name __pycache__ -type d -prune -exec rm -rf {} +
