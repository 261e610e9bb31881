"""Values as the text of a session writes them."""

import json
import os
from typing import Any, Dict, Mapping, Union

from ._errors import InputError

PathLike = Union[str, "os.PathLike[str]"]


def _plain(value: Any) -> Any:
    """Arrays and numbers of NumPy, and paths, as JSON values."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise InputError(f"{value!r}: this can't stand in a session.")


def to_json(value: Any) -> str:
    """The text of a value, with all digits of its numbers."""
    return json.dumps(value, default=_plain)


def event(kind: str, **keys: Any) -> str:
    """The text of an event; keys that are None are left out."""
    return to_json({"type": kind, **{k: v for k, v in keys.items() if v is not None}})


def movable(session: Mapping[str, Any], folder: PathLike = ".") -> Dict[str, Any]:
    """A session whose files are relative to `folder`, as one that may lie anywhere."""
    made: Dict[str, Any] = json.loads(to_json(dict(session)))
    more = made.get("more_models")
    for owner, key in [(made, "material"), (made.get("task"), "expert"), (made.get("model"), "path"),
                       *((model, "path") for model in (more if isinstance(more, list) else []))]:
        file = owner.get(key) if isinstance(owner, dict) else None
        if isinstance(file, str) and (key != "material" or file.endswith(".json")):
            owner[key] = os.path.abspath(os.path.join(folder, file))
    return made
