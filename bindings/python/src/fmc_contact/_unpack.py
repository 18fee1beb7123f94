"""``Unpack`` of keyword arguments, which Python has from 3.11 on."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if sys.version_info >= (3, 11):
    from typing import Unpack
elif TYPE_CHECKING:
    from typing_extensions import Unpack
else:

    class Unpack:
        """What ``typing.get_type_hints`` sees before Python 3.11: the type of the keywords itself."""

        def __class_getitem__(cls, item: Any) -> Any:
            return item


__all__ = ["Unpack"]
