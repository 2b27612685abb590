"""Exceptions: one for each status of the library (wrcontact.h).

All are of class Error, so that `except wrcontact.Error` catches every one; where Python has a class
for the same kind of failure they are of that too.
"""
from __future__ import annotations

from typing import Any

from ._library import lib, string


class ContactWarning(UserWarning):
    """A doubtful profile or solution; the result is returned nevertheless (docs/warnings.md)."""


class AccuracyNote(ContactWarning):
    """An error estimate a little over the accuracy, at most twice as large: one for each call."""


class Error(Exception):
    """A call that the library refused; `status` is its number in wrcontact.h.

    `result`: what was reached nevertheless, of a solution that has not converged; otherwise None.
    """

    status: int = -1
    result: Any = None

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled without its result, which stays with its scene."""
        return type(self), self.args, {"status": self.status}


class InvalidArgument(Error, ValueError):
    """A value outside its permitted range; the text names it, its value and what is permitted."""

    status = lib.WRC_INVALID_ARGUMENT


class UnknownName(Error, LookupError):
    """A key, profile or result that does not exist."""

    status = lib.WRC_UNKNOWN_NAME


class FileUnreadable(Error, OSError):
    """A file that cannot be opened, read or written."""

    status = lib.WRC_FILE_UNREADABLE


class FileMalformed(Error, ValueError):
    """A file whose content cannot be understood."""

    status = lib.WRC_FILE_MALFORMED


class NoContact(Error):
    """Wheel and rail do not meet in the scene as posed."""

    status = lib.WRC_NO_CONTACT


class OutOfMemory(Error, MemoryError):
    """Memory could not be allocated; the object keeps its last result."""

    status = lib.WRC_OUT_OF_MEMORY


class InternalError(Error, RuntimeError):
    """A fault of the library itself."""

    status = lib.WRC_INTERNAL


class NotConverged(Error):
    """The iteration missed its tolerance. The result reached is `result`."""

    status = lib.WRC_NOT_CONVERGED


class TooSmall(Error, ValueError):
    """An array too small for the values to be copied; arrays of this package are never."""

    status = lib.WRC_TOO_SMALL


class NoResult(Error):
    """A result that has not been solved or loaded yet, or was solved again since."""

    status = lib.WRC_NO_RESULT


class Busy(Error):
    """The object is in use by another thread."""

    status = lib.WRC_BUSY


_CLASSES: dict[int, type[Error]] = {kind.status: kind for kind in Error.__subclasses__()}


def error_of(status: int, text: str = "") -> Error:
    """The exception for a status other than WRC_OK, with the library's text or the status's name."""
    error = _CLASSES.get(status, Error)(text or string(lib.wrc_status_name(status)))
    error.status = status
    return error
