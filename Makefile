# Everything a newcomer types. Each target is one line that you could type yourself.
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do $$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $$p && break; done)
BIN := .venv/bin
READY := .venv/.ready
UV := $(BIN)/uv pip compile pyproject.toml --universal --no-strip-extras --generate-hashes --python-version 3.11 --no-header --no-emit-index-url --no-emit-find-links --quiet

.PHONY: setup run test campaign soak coverage check bench docs lock web
.DELETE_ON_ERROR:

setup: $(READY)  ## make .venv with everything in it, from a bare Python 3.11 or newer

$(READY): requirements/dev.txt pyproject.toml
	@test -n "$(PYTHON)" || { echo "Hoistway needs Python 3.11 or newer: install it, or say make setup PYTHON=/path/to/python3"; exit 1; }
	$(PYTHON) -m venv .venv && $(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements/dev.txt && $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable . && touch $(READY)

run: $(READY)  ## simulate the demo plant, control it, print where to look; elsewhere: make run PORT=18080
	@$(BIN)/hoistway demo $(if $(PORT),--port $(PORT))

test: $(READY)  ## all tests, on all cores, the long ones first (tests/ordering.py)
	$(BIN)/pytest -n auto

campaign: $(READY)  ## hundreds of runs in which everything goes wrong, and known mistakes that must be noticed
	$(BIN)/hoistway fuzz --plant plants/small.yaml --seeds 0-299 --need-all && $(BIN)/hoistway fuzz --plant plants/hall.yaml --seeds 0-99 --need-all && $(BIN)/hoistway fuzz --plant plants/demo.yaml --seeds 0-11 && $(BIN)/hoistway simulate --plant plants/demo.yaml --hours 2 && $(BIN)/python -m tests.acceptance.calls --seed 1 && $(BIN)/python -m tests.acceptance.power --cuts 1000 && $(BIN)/pytest -n auto -m campaign

soak: $(READY)  ## the same for hours: 20,000 runs, and each known mistake on seeds that nobody chose
	$(BIN)/hoistway fuzz --plant plants/small.yaml --seeds 1000-20999 --need-all && $(BIN)/python -m tests.acceptance.catching --seeds 1000 && $(BIN)/python -m tests.acceptance.calls --each 50

coverage: $(READY)  ## branch coverage of the pure layers; fails below 95 %
	$(BIN)/pytest -n auto --ignore=tests/e2e --ignore=tests/web --ignore=tests/api --ignore=tests/runtime --ignore=tests/acceptance/test_campaign.py --ignore=tests/acceptance/test_mistakes.py --cov=app.domain --cov=app.wire --cov=app.protocols --cov=app.planning --cov=app.plant --cov=app.fleet --cov=app.control --cov=app.store --cov-branch --cov-report=term:skip-covered --cov-fail-under=95

check: $(READY)  ## format, lint, types, import contracts; no tests
	$(BIN)/ruff format --check . && $(BIN)/ruff check . && $(BIN)/mypy && $(BIN)/lint-imports

bench: $(READY)  ## all benchmarks, each against its floor in the same run
	$(BIN)/python -m tests.bench

docs: $(READY)  ## the documentation as a site with a search, in site/html; fails for a link that leads nowhere
	$(BIN)/python -m tools.site

lock:  ## pin every dependency with hashes, for all Python versions and systems
	$(UV) -o requirements/runtime.txt && $(UV) --group dev -o requirements/dev.txt

web:  ## build the operator page from web/ into app/web (needs Node 20 or newer; nothing else here does)
	cd web && npm ci && npm run build && npm test
