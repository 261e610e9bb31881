"""Values as the text of a session writes them."""

import json
import os
from typing import Any, Mapping, Optional, Union

from . import _native

PathLike = Union[str, "os.PathLike[str]"]


def _plain(value: Any) -> Any:
    """Arrays and numbers of NumPy, and paths, as JSON values."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise _native.InputError(f"{value!r}: this can't stand in a session.")


def to_json(value: Any) -> str:
    """The text of a value, with all digits of its numbers."""
    return json.dumps(value, default=_plain)


def event(kind: str, **keys: Any) -> str:
    """The text of an event; keys that are None are left out."""
    return to_json({"type": kind, **{k: v for k, v in keys.items() if v is not None}})


def source(session: Union[PathLike, Mapping[str, Any]], material: Optional[PathLike],
           params: Optional[Mapping[str, Any]]) -> "_native.SessionSource":
    """A session by its file or its content, with other parameters at its start."""
    settings = [(name, to_json(value)) for name, value in (params or {}).items()]
    chosen = "" if material is None else os.fspath(material)
    if isinstance(session, Mapping):
        return _native.SessionSource("", to_json(dict(session)), chosen, settings)
    return _native.SessionSource(os.fspath(session), "", chosen, settings)
