"""The shared library: where it is found, which version it must have, and how its statuses become exceptions.

It is searched for, in this order, at the path in the environment variable ``FMC_CONTACT_LIBRARY``, in this package, and
where the system's loader looks.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import os
from pathlib import Path

from ._constants import FMC_ABI_VERSION
from ._signatures import FUNCTIONS
from .errors import LibraryError, of_status

VARIABLE = "FMC_CONTACT_LIBRARY"


def _path() -> str:
    given = os.environ.get(VARIABLE)
    if given:
        return given
    folder = Path(__file__).parent / "_native"
    for pattern in ("*.so", "*.dylib", "*.dll"):
        for found in sorted(folder.glob(pattern)):
            return str(found)
    installed = ctypes.util.find_library("fmc_contact")
    if installed:
        return installed
    raise LibraryError(
        f"the shared library of fmc_contact is neither in {folder} nor known to the system: install the package with "
        f"pip, or set {VARIABLE} to the path of libfmc_contact.so"
    )


def load(path: str) -> ctypes.CDLL:
    """Opens a library, checks its version, and declares its functions. ctypes lets other threads run during a call."""
    try:
        library = ctypes.CDLL(path)
        library.fmc_abi_version.restype = ctypes.c_int32
        version = library.fmc_abi_version()
    except (OSError, AttributeError) as error:
        raise LibraryError(f"{path} is not a library that fmc_contact can load: {error}") from error
    if version != FMC_ABI_VERSION:
        raise LibraryError(
            f"{path} has version {version} of the binary interface, this package is for version {FMC_ABI_VERSION}: "
            "install package and library from one release"
        )
    for name, (result, arguments) in FUNCTIONS.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise LibraryError(
                f"{path} has no function {name}: it is older than this package; install both from one release"
            ) from None
        function.restype, function.argtypes = result, arguments
    return library


library = load(_path())


def check(status: int) -> None:
    """Raises the exception of a status, with the library's message. To be called on the thread of the failed call."""
    if status != 0:
        raise of_status(status, library.fmc_last_error().decode())
