"""The shared library, its texts and arrays.

The library is beside this file (docs/python.md, "How it finds the library"). Calls release the
interpreter's lock, so other threads run meanwhile.
"""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._interface import ffi

Array = NDArray[np.float64]


def _open() -> Any:
    folder = Path(__file__).parent
    for path in sorted(folder.glob("libwrcontact.so.*")):
        try:
            return ffi.dlopen(str(path))
        except OSError as error:
            raise ImportError(f"wrcontact: {path} cannot be loaded: {error}") from error
    raise ImportError(f"wrcontact: there is no libwrcontact.so.* in {folder}")


lib = _open()


def string(value: Any) -> str:
    """A copy of a text of the library; bytes that are not UTF-8 stay visible."""
    return bytes(ffi.string(value)).decode("utf-8", "backslashreplace")


def refuse_masked(values: Any) -> None:
    """InvalidArgument for masked values, whose mask would be lost."""
    parts = values if isinstance(values, (list, tuple)) else [values]
    if any(isinstance(part, np.ma.MaskedArray) and np.any(part.mask) for part in parts):
        from .errors import InvalidArgument

        raise InvalidArgument("an array has masked values; it must have none: values[~values.mask]")


def doubles(values: ArrayLike) -> Array:
    """The values as the library reads them; the same memory if they are already so. InvalidArgument if masked."""
    refuse_masked(values)
    return np.ascontiguousarray(values, dtype=np.float64)


def pointer(array: Any, kind: str = "double") -> Any:
    """To the memory of a contiguous array, which stays alive as long as the pointer."""
    return ffi.from_buffer(f"{kind}[]", array)
