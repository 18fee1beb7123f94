"""What the contact costs."""

from __future__ import annotations

import time
from typing import Any

from fmc_contact_dolfinx import DolfinxContact


class Timed:
    """A contact, and the processor time spent in it, s."""

    def __init__(self, contact: DolfinxContact) -> None:
        self.inner, self.seconds = contact, 0.0

    def __getattr__(self, name: str) -> Any:
        found = getattr(self.inner, name)
        if not callable(found):
            return found

        def call(*arguments: Any, **options: Any) -> Any:
            clock = time.process_time()
            try:
                return found(*arguments, **options)
            finally:
                self.seconds += time.process_time() - clock

        return call
