"""The errors of Kerf, by the exit codes of the command line."""

from typing import Any, Dict


class Error(Exception):
    """Any failure of Kerf, with the message of the command line."""


class InputError(Error):
    """An input is missing, invalid or impossible (exit code 3)."""


class CheckFailed(Error):
    """A check or an invariant failed (exit code 1). Of a replay, `summary` is that of the run."""

    summary: Dict[str, Any]


class OpenGLError(Error):
    """No usable OpenGL 4.5 (exit code 4)."""


class LimitError(Error):
    """Memory, disk, time or another limit is used up (exit code 5)."""


for _kind in (Error, InputError, CheckFailed, OpenGLError, LimitError):
    _kind.__module__ = "kerf"  # as people write and pickle them
