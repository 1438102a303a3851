# Two commands do all the set-up: `make record` runs the main job, `make test` passes the tests.
PYTHON ?= python3
VENV := .venv
RUN := $(VENV)/bin

.PHONY: record test lint slow benchmark gallery clean

record: $(VENV)/installed
	$(RUN)/studio record --scene doorway

test: $(VENV)/installed
	$(RUN)/pytest

lint: $(VENV)/installed
	$(RUN)/ruff check
	$(RUN)/ruff format --check
	$(RUN)/mypy

slow: $(VENV)/installed
	$(RUN)/pytest -m slow

benchmark: $(VENV)/installed
	$(RUN)/python -m benchmarks.engine
	$(RUN)/python -m benchmarks.commands
	$(RUN)/python -m benchmarks.drawing
	$(RUN)/python -m benchmarks.learning

gallery: $(VENV)/installed
	$(RUN)/python -m docs.make_gallery

clean:
	rm -rf $(VENV)

$(VENV)/installed: pyproject.toml constraints.txt
	test -x $(RUN)/python || $(PYTHON) -m venv $(VENV)
	$(RUN)/python -m pip install --quiet --disable-pip-version-check \
		--constraint constraints.txt --editable '.[test,lint]'
	touch $@
