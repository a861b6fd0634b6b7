# Two commands: `make repro` regenerates every table, `make test` runs every test.
# Both install the pinned environment into .venv first.
PYTHON ?= python3
# Hydra overrides that choose other data or settings, e.g. SET="dataset=vpc2009 dataset.root=PATH".
SET ?=
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.installed

.PHONY: repro test lint ui lock clean

repro: $(READY)
	$(BIN)/placecat repro $(SET)

test: $(READY) lint
	$(BIN)/python -m pytest -n 2 --dist loadgroup tests

lint: $(READY)
	$(BIN)/ruff format --check src tests
	$(BIN)/ruff check src tests
	$(BIN)/mypy

$(READY): requirements.lock pyproject.toml
	$(PYTHON) -c 'import sys; sys.exit(0 if (3, 11) <= sys.version_info[:2] < (3, 14) else "placecat needs Python 3.11, 3.12 or 3.13: make PYTHON=python3.12 ...")'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
	touch $@

ui: $(READY)
	$(BIN)/mlflow ui --backend-store-uri sqlite:///mlflow.db

# Needs uv; run after changing the dependencies in pyproject.toml.
lock:
	uv pip compile pyproject.toml --extra test --universal --python-version 3.11 --generate-hashes --no-header --upgrade -o requirements.lock

clean:
	rm -rf $(VENV)
