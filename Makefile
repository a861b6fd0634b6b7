# Two commands: `make repro` regenerates every table, `make test` runs every test (`make test-quick` most of them).
# Both first install what they need, pinned, into .venv: the tests also need what renders the homes.
# `make bench` times each piece beside what one would use instead, which it installs too.
PYTHON ?= python3
# Hydra overrides that choose other data or settings, e.g. SET="dataset=vpc2009 dataset.root=PATH".
SET ?=
# Pieces to measure, e.g. PIECE="dependency_tree rvm"; by default all.
PIECE ?=
# What `make choose` is for: cues, systems or smoothing; by default all.
KIND ?=
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.installed
READY_TEST := $(VENV)/.installed-test
READY_BENCH := $(VENV)/.installed-bench
# tests/conftest.py orders the tests.
WORKERS := -n 2 --dist loadgroup --no-loadscope-reorder

# Packages of elsewhere would be taken before those of .venv.
unexport PYTHONPATH PYTHONHOME
export PYTHONNOUSERSITE := 1

# An environment that was moved with the project is made anew.
ifneq ($(shell $(PYTHON) install.py --moved),)
.PHONY: $(READY) $(READY_TEST) $(READY_BENCH)
endif

.PHONY: repro test test-quick campaign choose bench bench-scale docs lint ui lock clean

repro: $(READY)
	$(BIN)/placecat repro $(SET)

test: $(READY_TEST) lint
	$(BIN)/python -m pytest $(WORKERS) tests

# Without what runs DVC, a server, a browser or the renderer, or takes more than a few seconds.
test-quick: $(READY_TEST)
	$(BIN)/python -m pytest $(WORKERS) -m "not slow" tests

bench: $(READY_BENCH)
	$(BIN)/python -m placecat_bench $(PIECE)

# Needs what `make repro` left; takes about an hour.
bench-scale: $(READY)
	$(BIN)/python -m placecat_bench.scale

# Damages inputs, kills runs, fills disks, for SECONDS in all; counts what became of it in reports/robustness.csv.
SECONDS ?= 1800
SEED ?= 0
campaign: $(READY_TEST)
	$(BIN)/python tests/campaign/campaign.py --seconds $(SECONDS) --seed $(SEED)

# Judges what the thesis leaves open on training homes, from what `make repro` left (conf/choice.yaml).
choose: $(READY)
	$(BIN)/python -m placecat.choice $(KIND)

docs: $(READY_TEST) ## fill the numbers of README.md and docs/ from the result files, build both into site/
	$(BIN)/python docs/fill.py
	$(BIN)/sphinx-build -q -W --keep-going -c docs -d site/.doctrees . site
	@echo "Open site/index.html."

lint: $(READY_TEST)
	$(BIN)/ruff format --check src tests docs/*.py
	$(BIN)/ruff check src tests docs/*.py
	$(BIN)/mypy

# All locks hold the same version of a package, so that they go together in any order.
$(READY): requirements.lock pyproject.toml
$(READY_TEST): requirements-test.lock pyproject.toml
$(READY_BENCH): requirements-bench.lock pyproject.toml
$(READY) $(READY_TEST) $(READY_BENCH):
	$(PYTHON) install.py $< $@

ui: $(READY)
	MLFLOW_SERVER_ENABLE_JOB_EXECUTION=false MLFLOW_DISABLE_TELEMETRY=true \
		$(BIN)/mlflow ui --backend-store-uri sqlite:///mlflow.db --workers 1

# Needs uv; run after changing the dependencies in pyproject.toml.
COMPILE := uv pip compile pyproject.toml --universal --python-version 3.11 --generate-hashes --no-header --upgrade
TESTED := --extra build --extra cluster --extra dask --extra docs --extra render --extra search --extra test
lock:
	$(COMPILE) $(TESTED) -o requirements-test.lock
	$(COMPILE) --extra build -c requirements-test.lock -o requirements.lock
	$(COMPILE) $(TESTED) --extra bench -c requirements-test.lock -o requirements-bench.lock

clean:
	rm -rf $(VENV)
