# Every target does its own set-up. `make run` and `make test` are all a fresh machine needs.

SHELL := /bin/bash
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
OUT := out
CARGO ?= cargo

# The program that the manual is computed with.
FLEXURE ?= target/release/flexure

.PHONY: run test docs docs-test lint tidy bench fuzz snap build wheel clean

## Build the release binary and the wheel, run the shipped rotor, show its results.
run: build wheel
	@mkdir -p $(OUT)
	target/release/flexure verify examples/rotor/rotor.cmd
	target/release/flexure run examples/rotor/rotor.cmd --out $(OUT) --journal $(OUT)/rotor.log
	target/release/flexure simulate examples/rotor/rotor.cmd --end 0.5 --steps 500 --out $(OUT)/rotor_start.parquet
	target/release/flexure plot $(OUT)/rotor_start.parquet -o $(OUT)/rotor_tip.png -s TIP_1.X -s TIP_1.Y -s ROOT_1.X --title "Rotor: tip of blade 1 and force in its root"
	target/release/flexure plot examples/rotor/rotor.cmd -o $(OUT)/rotor_model.png
	target/release/flexure convert examples/rotor/rotor.cmd $(OUT)/rotor.adm
	$(BIN)/python examples/rotor/rotor.py $(OUT)
	@echo
	@echo "Files written:"
	@ls -1 $(OUT)/rotor*

## All tests, Rust and Python.
test: wheel
	$(CARGO) test --workspace --quiet
	$(BIN)/python -m pytest -q python/tests

## The manual, from out/docs/index.html; its figures, tables and numbers are computed by the program.
docs: $(if $(filter target/release/flexure,$(FLEXURE)),build) $(VENV)/docs
	$(BIN)/python docs/build.py --program $(FLEXURE) --out $(OUT)/docs

## Builds the manual aside and reads it: numbering, references, figures, parameter tables, no network.
docs-test: $(VENV)/docs
	FLEXURE=$(abspath $(FLEXURE)) $(BIN)/python -m pytest -q docs/tests

$(VENV)/docs: docs/requirements.txt | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --requirement docs/requirements.txt
	@touch $@

build:
	$(CARGO) build --release --package flexure-cli

$(BIN)/python:
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --requirement python/requirements-dev.txt

## The Python wheel, built and installed into .venv.
wheel: $(BIN)/python
	$(BIN)/maturin build --release --quiet --out target/wheels
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --force-reinstall --no-deps target/wheels/flexure-*.whl

## Formatting and lints; continuous integration runs this too.
lint:
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --all-targets -- -D warnings

## Compare the import table of ARCHITECTURE.md with the manifests.
tidy:
	$(CARGO) test --quiet --package flexure --test tidy

## Accept changed snapshots after looking at them.
snap:
	INSTA_UPDATE=always $(CARGO) test --workspace --quiet

## Cost over the length of a command file and of a chain, and peers where they are installed.
bench: build wheel
	$(BIN)/python bench/reading.py
	$(BIN)/python bench/bench.py

fuzz:
	PROPTEST_CASES=20000 $(CARGO) test --workspace --quiet prop
	PROPTEST_CASES=2000 $(CARGO) test --package flexure --test robust

clean:
	rm -rf $(OUT) $(VENV) target
