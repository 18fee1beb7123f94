"""Options of the tests: problems that take more than 5 s are solved with ``--slow``."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))


def pytest_addoption(parser):
    parser.addoption("--slow", action="store_true", help="solve the problems that take more than 5 s too")


def pytest_configure(config):
    config.addinivalue_line("markers", "slow: takes more than 5 s; solved with --slow")


def pytest_collection_modifyitems(config, items):
    if config.getoption("--slow"):
        return
    for item in items:
        if "slow" in item.keywords:
            item.add_marker(pytest.mark.skip(reason="takes more than 5 s; --slow solves it"))
