"""`kerf reduce`: makes a session for which a command fails as small as it can."""

import hashlib
import json
import logging
import math
import os
import pathlib
import subprocess
import sys
import time
from types import MappingProxyType
from typing import Any, Callable, Dict, List, Mapping, Sequence, Tuple

from . import _program, _text
from ._errors import Error, InputError
from .replay import replay

Session = Dict[str, Any]

_EDGES_IN_LENGTH = (2, 3, 4, 6, 8, 12, 16, 24, 32)  # of the model's diagonal: coarsest first
_SPARE_KEYS = ("$schema", "task", "view", "material", "boxes", "more_models", "placement", "params")


def main(words: Sequence[str]) -> int:
    """`kerf reduce` with the words SESSION OUT COMMAND... Returns its exit code."""
    begin = time.monotonic()
    logging.disable()  # warnings about sessions that are tried
    session, folder, command = words[0], pathlib.Path(words[1]), list(words[2:])
    try:
        reduction = Reduction(_read(session), Verdicts(command, folder))
        print(reduction.run() + f"; {time.monotonic() - begin:.0f} s")
    except KeyboardInterrupt:
        print("kerf: Stopped; the same call goes on from here.", file=sys.stderr)
        return 130
    except Error as error:
        print(f"kerf: {error}", file=sys.stderr)
        return 3
    return 0


def _read(file: str) -> Session:
    """A session with absolute paths, and its events in the order in which they happen."""
    try:
        session = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        session["events"] = sorted(session.get("events", []), key=lambda event: event["step"])
        return _text.movable(session, os.path.dirname(os.path.abspath(file)))
    except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
        raise InputError(f"{file}: this can't be read as a session ({error}).") from error


class Verdicts:
    """Whether the command fails for a session as it does for the first one: by its exit status.

    The statuses are kept in a file of the folder, so a reduction that was stopped repeats no run.
    """

    def __init__(self, command: List[str], folder: pathlib.Path) -> None:
        self.folder = folder.absolute()
        self.candidate = self.folder / "candidate.kerf.json"
        name = str(self.candidate)
        named = [word.replace("{}", name) for word in command]
        self._command = named if named != command else [*command, name]
        self._known: Dict[str, int] = {}
        self.runs = 0

    def begin(self, session: Session) -> None:
        """Takes the first session, for which the command must fail."""
        self.folder.mkdir(parents=True, exist_ok=True)
        kept = self.folder / "verdicts"
        title = hashlib.sha256(_formatted([self._command, session]).encode()).hexdigest()
        lines = kept.read_text().splitlines() if kept.exists() else [title]
        if lines[0] != title:
            raise InputError(f"{kept}: this is of another session or command; choose another --out.")
        self._known = {key: int(status) for key, status in map(str.split, lines[1:])}
        self._file = open(kept, "a", buffering=1, encoding="utf-8")
        if not kept.stat().st_size:
            self._file.write(title + "\n")
        self._wanted = self._status(session)
        if self._wanted == 0:
            raise InputError("The command ends with exit code 0 for the session itself, so there is "
                             "nothing to look for.")

    def fails(self, session: Session) -> bool:
        return self._status(session) == self._wanted

    def _status(self, session: Session) -> int:
        text = _formatted(session)
        key = hashlib.sha256(text.encode()).hexdigest()
        if key not in self._known:
            self.candidate.write_text(text, encoding="utf-8")
            self._known[key] = self._run()
            self._file.write(f"{key} {self._known[key]}\n")
        return self._known[key]

    def _run(self) -> int:
        self.runs += 1
        with open(self.folder / "command.log", "w", encoding="utf-8") as log:
            try:
                return subprocess.run(self._command, stdin=subprocess.DEVNULL, stdout=log,
                                      stderr=log, check=False).returncode
            except OSError as error:
                raise InputError(f"{self._command[0]}: can't be started ({error.strerror}).") from error


class Reduction:
    """A session that becomes smaller while the command fails."""

    def __init__(self, session: Session, verdicts: Verdicts) -> None:
        self.session = session
        self._verdicts = verdicts
        self._triangles: Dict[str, float] = {}

    def run(self) -> str:
        """Reduces it until a round changes nothing. Returns a sentence on what came of it."""
        self._verdicts.begin(self.session)
        first = size = self._size()
        for number in range(1, sys.maxsize):
            for part in (self._end_sooner, self._coarsen, self._drop_keys, self._drop_events,
                         self._close_gaps, self._trim_strokes):  # what makes the runs short comes first
                part()
            before, size = size, self._size()
            print(f"round {number}: {_named(size)}, {self._verdicts.runs} runs", file=sys.stderr)
            if size == before:
                break
        result = self._verdicts.folder / "reduced.kerf.json"
        result.write_text(_formatted(self.session), encoding="utf-8")
        return f"{result}: {_named(size)}, of {_named(first)}; {self._verdicts.runs} runs"

    def _size(self) -> Tuple[float, ...]:
        keys = json.dumps({**self.session, "events": 0, "steps": 0})
        return (len(self.session["events"]), self.session["steps"], len(keys),
                self._triangles_of(self.session))

    def _keep(self, **changes: Any) -> bool:
        """Goes on with these keys, if the command fails for them too; None is no key."""
        changed = {k: v for k, v in {**self.session, **changes}.items() if v is not None}
        if not self._verdicts.fails(changed):
            return False
        self.session = changed
        return True

    def _end_sooner(self) -> None:
        events = self.session["events"]
        least(1, self.session["steps"], lambda steps: self._keep(
            steps=steps, events=[event for event in events if event["step"] <= steps]))

    def _drop_keys(self) -> None:
        for key in _SPARE_KEYS:
            value = self.session.get(key)
            if value is None or self._keep(**{key: None}):
                continue
            if isinstance(value, list):
                thinned(value, lambda rest, key=key: self._keep(**{key: rest}))
            elif key in ("params", "placement"):
                thinned(list(value.items()), lambda rest, key=key: self._keep(**{key: dict(rest)}))

    def _drop_events(self) -> None:
        thinned(self.session["events"], lambda rest: self._keep(events=rest))

    def _trim_strokes(self) -> None:
        """Less of the blade's way between two poses, from its start and its end, at its speed."""
        for i in range(len(self.session["events"]) - 1):
            for kept, moved in ((i + 1, i), (i, i + 1)):
                poses, gaps = self.session["events"], self._gaps()
                if poses[kept]["type"] == poses[moved]["type"] == "blade":
                    least(1, gaps[i + 1], lambda steps: self._keep_gaps(
                        [*gaps[:i + 1], steps, *gaps[i + 2:]],
                        {moved: _between(poses[kept], poses[moved], steps / gaps[i + 1])}))

    def _close_gaps(self) -> None:
        """Fewer steps before each event, and after the last."""
        for divisor in (64, 16, 4, 2):
            while any(self._gaps()) and self._keep_gaps([gap // divisor for gap in self._gaps()]):
                pass
        gaps = self._gaps()
        for i in sorted(range(len(gaps)), key=lambda i: -gaps[i]):
            least(0, gaps[i], lambda gap, i=i: self._keep_gaps(
                [gap if k == i else other for k, other in enumerate(self._gaps())]))

    def _gaps(self) -> List[int]:
        steps = [0, *(event["step"] for event in self.session["events"]), self.session["steps"]]
        return [after - before for before, after in zip(steps, steps[1:])]

    def _keep_gaps(self, gaps: List[int], poses: Mapping[int, Session] = MappingProxyType({})) -> bool:
        """Goes on with these, and with other poses of some events, if the command still fails."""
        if sum(gaps) < 1 or gaps == self._gaps():
            return False
        events = [{**event, **poses.get(i, {}), "step": sum(gaps[:i + 1])}
                  for i, event in enumerate(self.session["events"])]
        return self._keep(steps=sum(gaps), events=events)

    def _coarsen(self) -> None:
        """Fewer triangles of each model: the reader makes them even, with longer edges."""
        for i, model in enumerate([self.session["model"], *self.session.get("more_models", [])]):
            length = _diagonal(model)
            for parts in _EDGES_IN_LENGTH if length else ():
                coarse = {**model, "remesh": True, "remesh_edge": length / parts}
                if i == 0:
                    changes: Session = {"model": coarse}
                else:
                    more = list(self.session["more_models"])
                    more[i - 1] = coarse
                    changes = {"more_models": more}
                count = self._triangles_of({**self.session, **changes})
                finer = math.inf > count >= self._triangles_of(self.session)
                if finer or (count < math.inf and self._keep(**changes)):
                    break

    def _triangles_of(self, session: Session) -> float:
        """Those of its models; infinitely many where they can't be made."""
        scene = {key: session[key] for key in ("format", "version", "model", "more_models", "placement")
                 if key in session}
        key = json.dumps(scene)
        if key not in self._triangles:
            try:
                summary = replay({**scene, "steps": 1})
                self._triangles[key] = summary["before"]["triangles"]
            except Error:
                self._triangles[key] = math.inf
        return self._triangles[key]


def _between(kept: Session, moved: Session, share: float) -> Session:
    """A pose on the way from `kept` to `moved`."""
    return {end: [p + (q - p) * share for p, q in zip(kept[end], moved[end])] for end in "ab"}


def least(low: int, high: int, holds: Callable[[int], bool]) -> int:
    """By bisection the smallest number from low to high that holds, where high is known to."""
    while low < high:
        middle = (low + high) // 2
        if holds(middle):
            high = middle
        else:
            low = middle + 1
    return high


def thinned(items: List[Any], holds: Callable[[List[Any]], bool]) -> List[Any]:
    """By delta debugging a list of which no single item can go, where the list is known to hold."""
    size = len(items)
    while size > 0:
        end = len(items)
        while end > 0:
            rest = items[:max(0, end - size)] + items[end:]
            if holds(rest):
                items = rest
            end -= size
        size //= 2
    return items


def _diagonal(model: Session) -> float:
    """Of the box around a model, in the unit of its file; 0 where it can't be read."""
    name = model.get("path", model.get("builtin"))
    done = subprocess.run([_program.path(), "inspect", "--json", "--", name], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if done.returncode != 0:
        return 0
    bounds = json.loads(done.stdout)["bounds"]
    return math.dist(bounds["low"], bounds["high"])


def _formatted(value: Any) -> str:
    return json.dumps(value, indent=1) + "\n"


def _named(size: Tuple[float, ...]) -> str:
    events, steps, _, triangles = size
    return ", ".join(f"{count} {what}" + "s" * (count != 1) for count, what in
                     ((events, "event"), (steps, "step"), (triangles, "triangle")))
