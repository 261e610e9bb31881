"""Sweeps of parameters over sessions."""

import json
import os
from typing import Any, Dict, List, NamedTuple, Tuple

from . import _native
from ._text import PathLike


class StudyRun(NamedTuple):
    """One run of a study."""

    session: str  #: as the study names it
    params: Dict[str, Any]  #: that the run sets at the start of its session


class Study:
    """A study of `kerf sweep`: sessions, and values of parameters to run them with.

    Each run writes a subfolder of one folder, which appears only when complete. Runs may be done in
    any order, and shared among processes and machines: `kerf sweep` and this class can even work on
    the same folder. See docs/sweeps.md.
    """

    def __init__(self, file: PathLike) -> None:
        """Reads a study and checks it with all its sessions. Raises kerf.InputError."""
        self.file = os.path.abspath(os.fspath(file))
        self._native = _native.Study(self.file)

    def __reduce__(self) -> Tuple[Any, ...]:
        """Other processes get a study by its file."""
        return Study, (self.file,)

    def __len__(self) -> int:
        """How many runs there are."""
        return len(self._native)

    def __getitem__(self, number: int) -> StudyRun:
        """The run of a number, from 0."""
        if not 0 <= number < len(self):
            raise IndexError(f"the study has runs 0 to {len(self) - 1}")
        session, settings = self._native.describe(number)
        return StudyRun(session, {name: json.loads(value) for name, value in settings})

    def run(self, number: int, out: PathLike) -> Tuple[int, str]:
        """Does one run, unless already done, as `kerf sweep --run` in a process of its own.

        Returns its exit code and, where that is not 0, a clause on what went wrong.
        """
        return self._native.run(number, os.fspath(out))

    def gather(self, out: PathLike) -> Tuple[List[int], List[int]]:
        """Writes table.csv of the runs that are done. Returns those that failed or are missing."""
        return self._native.gather(os.fspath(out))
