"""Ctrl-C while the library computes: Python handles signals between its own instructions alone, of which there are none then."""

from __future__ import annotations

import signal
import sys
import threading
from types import FrameType
from typing import Any, Callable, Optional


class CtrlC:
    """Use it in a ``with`` statement around a call of the library, whose callback is ``ask``. Ctrl-C during the call ends it, and is then handled as
    usual. Only the main thread receives signals."""

    def __init__(self) -> None:
        self._is_pressed = False
        self._before: Optional[Callable[[int, Optional[FrameType]], Any]] = None

    def ask(self, _user: object) -> int:
        """Whether the call is to end; that Python runs this function lets it call the handler first."""
        return int(self._is_pressed)

    def _hear(self, _number: int, _frame: Optional[FrameType]) -> None:
        self._is_pressed = True

    def __enter__(self) -> None:
        before = signal.getsignal(signal.SIGINT)
        if threading.current_thread() is threading.main_thread() and callable(before) and self._before is None:
            signal.signal(signal.SIGINT, self._hear)
            self._before = before

    def __exit__(self, *_: object) -> None:
        if self._before is None:
            return
        before, self._before = self._before, None
        signal.signal(signal.SIGINT, before)
        if self._is_pressed:
            self._is_pressed = False
            before(signal.SIGINT, sys._getframe())
