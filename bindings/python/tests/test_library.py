"""A library that is missing, or of another version, is refused with a sentence."""

import os
import shutil
import subprocess
import sys

import fmc_contact
import pytest
from fmc_contact import _library, errors


def import_with(path):
    environment = {**os.environ, _library.VARIABLE: str(path)}
    return subprocess.run([sys.executable, "-c", "import fmc_contact"], env=environment, capture_output=True, text=True)


def built(tmp_path, source):
    (tmp_path / "other.c").write_text(source)
    path = tmp_path / "libother.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-o", path, tmp_path / "other.c"], check=True)
    return path


def test_a_path_that_leads_nowhere_is_named(tmp_path):
    found = import_with(tmp_path / "nothing.so")
    assert found.returncode == 1
    assert "LibraryError" in found.stderr and "nothing.so" in found.stderr


needs_compiler = pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler")


@needs_compiler
def test_another_version_of_the_interface_is_refused(tmp_path):
    found = import_with(built(tmp_path, "int fmc_abi_version(void) { return 99; }"))
    assert found.returncode == 1
    assert "version 99 of the binary interface, this package is for version 3" in found.stderr


@needs_compiler
def test_a_library_without_a_function_is_refused(tmp_path):
    with pytest.raises(errors.LibraryError, match="no function fmc_version: it is older than this package"):
        _library.load(str(built(tmp_path, "int fmc_abi_version(void) { return 3; }")))


@needs_compiler
def test_a_library_of_something_else_is_refused(tmp_path):
    with pytest.raises(ImportError, match="not a library that fmc_contact can load"):
        _library.load(str(built(tmp_path, "int something_else(void) { return 1; }")))


def test_features_and_version():
    assert len(fmc_contact.__version__.split(".")) == 3
    assert fmc_contact.has_feature("shapes") and not fmc_contact.has_feature("teleport")
