"""A context of the library: freed with its last reference, and used by one call at a time."""

from __future__ import annotations

import threading
import weakref
from ctypes import Array, Structure, byref, c_size_t
from typing import Any, Callable, TypeVar

import numpy as np

from ._constants import FMC_ERROR_UNSUPPORTED
from ._ctrl_c import CtrlC
from ._library import check, library
from ._structs import fmc_context, fmc_interrupt_callback
from .errors import BusyError

Row = TypeVar("Row", bound=Structure)


def _free(pointer: fmc_context) -> None:
    library.fmc_context_free(byref(pointer))


def guarded(function: Callable[..., None], raised: list[BaseException]) -> Callable[..., int]:
    """The function for the library to call: 0 when it returns, -1 when it raises, which goes to ``raised``."""

    def guard(*arguments: object) -> int:
        try:
            function(*arguments)
        except BaseException as error:
            raised.append(error)
            return -1
        return 0

    return guard


class Handle:
    """Owner of a context. ``with handle:`` claims it for several calls that belong together."""

    index: np.dtype[Any]
    """Type of the numbers of nodes, cells and degrees of freedom in all lists of the context."""

    def __init__(
        self, create: Callable[..., int], index: np.dtype[Any], raised: list[BaseException] | None = None
    ) -> None:
        self.index = index
        self.pointer = fmc_context()
        self._raised = [] if raised is None else raised
        status = create(byref(self.pointer))
        self._raise_again()
        check(status)
        finalizer = weakref.finalize(self, _free, self.pointer)
        # At exit a daemon thread may still be inside; the system takes the memory back.
        finalizer.atexit = False
        self._lock = threading.Lock()
        self._callbacks: dict[object, object] = {}
        self._ctrl_c = CtrlC()
        ask = fmc_interrupt_callback(self._ctrl_c.ask)
        status = library.fmc_context_set_interrupt(self.pointer, ask, None)
        # Ranks that hold a mesh in parts wait for one another.
        if status != FMC_ERROR_UNSUPPORTED:
            check(status)
            self.keep("interrupt", ask)

    def __enter__(self) -> None:
        if not self._lock.acquire(blocking=False):
            raise BusyError("the contact is in use by another call: from another thread, or from a function it calls")

    def __exit__(self, *_: object) -> None:
        self._lock.release()

    def call(self, function: Callable[..., int], *arguments: object) -> None:
        """Calls a function of the library. A callback's exception takes precedence over the status that it caused, Ctrl-C over both."""
        with self._ctrl_c:
            status = function(self.pointer, *arguments)
        self._raise_again()
        check(status)

    def rows(self, of_type: type[Row], function: Callable[..., int], *arguments: object) -> Array[Row]:
        """Rows whose number the library knows: the first call returns the number, the second the rows."""
        count = c_size_t()
        self.call(function, *arguments, None, 0, byref(count))
        rows = (of_type * count.value)()
        self.call(function, *arguments, rows, count.value, byref(count))
        return rows

    def _raise_again(self) -> None:
        if self._raised:
            raised = self._raised[0]
            self._raised.clear()
            raise raised

    def guarded(self, function: Callable[..., None]) -> Callable[..., int]:
        """The function for the library to call: 0 when it returns, -1 when it raises, which ``call`` raises again."""
        return guarded(function, self._raised)

    def message_callback(self, function: Callable[[str], None]) -> Callable[..., None]:
        """The function that the library calls with messages; ``call`` reraises its exceptions."""
        guard = self.guarded(lambda text: function(text.decode()))

        def tell(_user: object, _level: int, text: bytes) -> None:
            guard(text)

        return tell

    def keep(self, key: object, callback: object) -> None:
        """Keeps a callback alive as long as the context, or until another takes its key."""
        self._callbacks[key] = callback

    def release(self, key: object) -> None:
        """Lets the callback of a key go, if there is one."""
        self._callbacks.pop(key, None)
