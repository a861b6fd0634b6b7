# `make` lists the targets. Each target first installs the pinned packages that it needs into .venv; the tests also need
# the packages of the renderer, and `make bench` needs the libraries that it compares placecat with.
PYTHON ?= python3
# Hydra overrides that choose other data or settings, such as SET="dataset=vpc2009 dataset.root=PATH".
SET ?=
# Pieces that `make bench` measures, such as PIECE="dependency_tree rvm"; all by default.
PIECE ?=
# Settings that `make choose` judges: cues, systems or smoothing; all by default.
KIND ?=
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.installed
READY_TEST := $(VENV)/.installed-test
READY_BENCH := $(VENV)/.installed-bench
# tests/conftest.py orders the tests.
WORKERS := -n 2 --dist loadgroup --no-loadscope-reorder

# Packages on PYTHONPATH would hide those in .venv.
unexport PYTHONPATH PYTHONHOME
# Without bytecode, each process would compile all modules again.
unexport PYTHONDONTWRITEBYTECODE
export PYTHONNOUSERSITE := 1

# If the project was moved, .venv must be created again.
ifneq ($(shell $(PYTHON) install.py --moved),)
.PHONY: $(READY) $(READY_TEST) $(READY_BENCH)
endif

.PHONY: help demo repro replicate test test-quick campaign choose bench bench-scale docs lint ui lock clean
.DEFAULT_GOAL := help

help: ## list these targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1|\2/p' $(MAKEFILE_LIST) | awk -F'|' '{printf "%-20s%s\n", $$1, $$2}'

demo: $(READY) ## show a first result in a minute: train on five homes, classify a walk through the sixth
	$(BIN)/placecat demo

repro: $(READY) ## compute every table, figure and number; SET="dataset=..." chooses other data or settings
	$(BIN)/placecat repro $(SET)

# Homes that already exist are not rendered again.
replicate: $(READY_TEST) ## render 24 homes, run them in groups of six, judge the findings on all of them; SET="dataset=..." uses others
ifeq ($(SET),)
	$(BIN)/placecat-homes --homes 24 --seed 1 --to data/homes_of_seed_1
endif
	$(BIN)/placecat replicate $(or $(SET),dataset=homes_of_seed_1)

test: $(READY_TEST) lint ## run every test
	$(BIN)/python -m pytest $(WORKERS) tests

test-quick: $(READY_TEST) ## run only the quick tests, without DVC, servers, browsers or the renderer
	$(BIN)/python -m pytest $(WORKERS) -m "not slow" --hypothesis-profile quick tests

bench: $(READY_BENCH) $(VENV)/contributed ## compare the speed of each piece with alternatives; PIECE="..." selects pieces
	$(BIN)/python -m placecat_bench $(PIECE)

bench-scale: $(READY) ## measure how time and memory grow with the data; needs `make repro`, takes about an hour
	$(BIN)/python -m placecat_bench.scale

# The counts are written to reports/robustness.csv.
SECONDS ?= 1800
SEED ?= 0
campaign: $(READY_TEST) ## test robustness for SECONDS: damage inputs, kill runs, fill disks, and count the outcomes
	$(BIN)/python tests/campaign/campaign.py --seconds $(SECONDS) --seed $(SEED)

# conf/choice.yaml lists the candidates.
choose: $(READY) ## compare, on training homes, settings that the thesis leaves open; needs `make repro`
	$(BIN)/python -m placecat.choice $(KIND)

docs: $(READY_TEST) ## update the numbers in README.md and docs/ from the result files, and build site/
	$(BIN)/python docs/fill.py
	$(BIN)/sphinx-build -q -W --keep-going -c docs -d site/.doctrees . site
	@echo "Open site/index.html."

lint: $(READY_TEST) ## check format, style and types
	$(BIN)/ruff format --check src tests docs/*.py
	$(BIN)/ruff check src tests docs/*.py
	$(BIN)/mypy

# All lock files have the same version of each package, so they can be installed in any order.
$(READY): requirements.lock pyproject.toml
$(READY_TEST): requirements-test.lock pyproject.toml
$(READY_BENCH): requirements-bench.lock pyproject.toml
$(READY) $(READY_TEST) $(READY_BENCH):
	$(PYTHON) install.py $< $@

# OpenCV with its contributed modules goes to a separate folder, since it would replace placecat's OpenCV.
$(VENV)/contributed: $(READY_BENCH)
	$(BIN)/python -m pip install -qq --no-deps --upgrade --target $@ opencv-contrib-python-headless==4.14.0.94

ui: $(READY) ## open MLflow with the runs that `make repro` logged
	MLFLOW_SERVER_ENABLE_JOB_EXECUTION=false MLFLOW_DISABLE_TELEMETRY=true PYTHONWARNINGS=ignore:starlette \
		$(BIN)/mlflow ui --backend-store-uri sqlite:///mlflow.db --workers 1

# `fewest` selects one version of each package for all Python versions, so that their results are bit-identical.
COMPILE := uv pip compile pyproject.toml --universal --python-version 3.11 --fork-strategy fewest --generate-hashes \
	--no-header --upgrade
TESTED := --extra build --extra cluster --extra dask --extra docs --extra render --extra rerun --extra robot \
	--extra search --extra test
lock: ## write the lock files after a change to the dependencies in pyproject.toml; needs uv
	$(COMPILE) $(TESTED) -o requirements-test.lock
	$(COMPILE) --extra build -c requirements-test.lock -o requirements.lock
	$(COMPILE) $(TESTED) --extra bench -c requirements-test.lock -o requirements-bench.lock

clean: ## remove .venv
	rm -rf $(VENV)
