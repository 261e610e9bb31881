"""Simulations that a script controls."""

import json
import os
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _native, _png, _text
from ._errors import InputError
from ._native import Report, Snapshot
from ._text import PathLike

Point = Union[Sequence[float], "npt.NDArray[np.float64]"]
Keys = Mapping[str, Any]

_MOST_STEPS = 1_000_000  # of a session
_UNDO_MEMORY = 512_000_000  # as in the editor


class Mesh(NamedTuple):
    """The surface between two steps. The arrays are read-only and never change.

    Numbers of vertices stay valid from step to step; cuts add new ones at the end. A vertex that no
    triangle uses any more keeps its row.
    """

    triangles: "npt.NDArray[np.int32]"  #: [triangles, 3] vertices, counter-clockwise from outside
    cut: "npt.NDArray[np.bool_]"  #: [triangles] whether a cut made the face
    piece: "npt.NDArray[np.int32]"  #: [triangles] number of its piece
    rest_positions: "npt.NDArray[np.float64]"  #: [vertices, 3] where they are at rest [m]


class Pieces(NamedTuple):
    """The pieces between two steps, numbered in the order in which they split off."""

    triangles: "npt.NDArray[np.int32]"  #: [pieces] how many
    model: "npt.NDArray[np.int32]"  #: [pieces] the model of the scene that it was part of
    volume: "npt.NDArray[np.float64]"  #: [pieces] [m^3]
    rest_volume: "npt.NDArray[np.float64]"  #: [pieces] [m^3]
    low: "npt.NDArray[np.float64]"  #: [pieces, 3] corner of the box around it [m]
    high: "npt.NDArray[np.float64]"  #: [pieces, 3] the opposite corner [m]


class Simulation:
    """A soft body, a blade and the parameters, advanced step by step.

    Commands are those of session files; each takes effect in the next step. Equal commands at equal
    steps give results equal bit by bit, also to those of `kerf replay`. Several simulations may run
    side by side, and be called from any thread.
    """

    def __init__(self, model: Union[PathLike, Keys], *, placement: Optional[Keys] = None,
                 more_models: Optional[Sequence[Keys]] = None,
                 material: Optional[PathLike] = None, params: Optional[Keys] = None,
                 boxes: Optional[Sequence[Keys]] = None, view: Optional[Keys] = None,
                 forces: bool = False, fine: bool = False,
                 undo_memory: int = _UNDO_MEMORY) -> None:
        """Begins with a model at rest.

        model: the name of a builtin model, a model file, or the key `model` of a session as a dict:
            {"path": "liver.obj", "repair": True}.
        placement, more_models, material, params, boxes, view: as in a session; what is left out
            has the default of a session. Files are relative to the working folder.
        forces: measures the force of the body on a blade that pushes; changes no result.
        fine: pictures with smooth edges and soft shadows.
        undo_memory: for the undo history [bytes]; 0 keeps none.

        Raises kerf.Error.
        """
        session: Dict[str, Any] = {
            "format": "kerf-session", "version": 1, "model": _model_keys(model),
            "steps": _MOST_STEPS,
        }
        optional = {"placement": placement, "more_models": more_models, "material": material,
                    "params": params, "boxes": boxes, "view": view}
        session.update({key: value for key, value in optional.items() if value is not None})
        self._begin(_source(session, None, None), forces, fine, undo_memory, True)

    @classmethod
    def from_session(cls, session: Union[PathLike, Keys], *, params: Optional[Keys] = None,
                     material: Optional[PathLike] = None, forces: bool = False, fine: bool = False,
                     undo_memory: int = 4 << 30, check_hashes: bool = True) -> "Simulation":
        """Starts from a session, whose events then take place by themselves.

        session: a file, or its content as a dict.
        params, material: replace those at the start of the session.
        check_hashes: False ignores the state hashes in the session's own checks.

        Screenshots and exports are skipped; kerf.replay() writes them. Where a check fails, step()
        raises kerf.CheckFailed.
        """
        made = cls.__new__(cls)
        made._begin(_source(session, material, params), forces, fine, undo_memory,
                    check_hashes)
        return made

    def _begin(self, source: "_native.SessionSource", forces: bool, fine: bool, undo_memory: int,
               check_hashes: bool) -> None:
        self._run = _native.Run(source, undo_memory, fine, forces, check_hashes)

    # --- Steps ----------------------------------------------------------------------------------

    def step(self, count: int = 1) -> Report:
        """Runs `count` steps and returns the report of the last one."""
        return self._run.step(count)

    def play(self) -> Report:
        """Runs a session to its end, with the events after its last step."""
        report = self._run.step(max(0, self._run.steps() - self.step_count))
        self._run.finish()
        return report

    @property
    def step_count(self) -> int:
        """Steps done so far: the number of the next one."""
        return self._run.step_count()

    @property
    def report(self) -> Report:
        """The report of the last step; before the first one, that of the body at rest."""
        return self._run.report()

    @property
    def messages(self) -> List[str]:
        """Problems in the steps so far, such as a refused cut, as sentences."""
        return self._run.messages()

    @property
    def tear_sentence(self) -> str:
        """Why the body tore in the last step or did not, with `tearing`; else "".

        It is what the window says below a body that a hand pulls.
        """
        return self._run.tear_sentence()

    @property
    def state_hash(self) -> str:
        """A checksum of the state, the same as that of `kerf replay`: 16 hexadecimal digits."""
        return self._run.state_hash()

    # --- The blade ------------------------------------------------------------------------------

    def move_blade(self, a: Point, b: Point) -> None:
        """Moves the blade to the segment from `a` to `b` [m] during the next step.

        The first pose after the start or a lift places it without cutting. After that, each
        step cuts along the quad that the blade sweeps.
        """
        self.apply("blade", a=a, b=b)

    def sweep(self, a: Point, b: Point, steps: int) -> Report:
        """Moves the blade from where it is to `a`, `b` in `steps` steps, and runs them.

        The ends move linearly, as between two `blade` events of a session. Raises kerf.InputError
        where no blade is placed.
        """
        start = self.blade
        if start is None:
            raise InputError("There is no blade to sweep; place it by move_blade() first.")
        for step in range(1, steps):
            t = step / steps
            self.move_blade(*(old + (np.asarray(new, float) - old) * t
                              for old, new in zip(start, (a, b))))
            self.step()
        self.move_blade(a, b)
        return self.step()

    def lift_blade(self) -> None:
        """Removes the blade and ends the stroke."""
        self.apply("lift")

    @property
    def blade(self) -> "Optional[Tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]]":
        """The ends of the blade [m] as last moved; None while it is lifted."""
        pose = self._run.blade()
        return None if pose is None else (np.array(pose[0]), np.array(pose[1]))

    # --- Parameters -----------------------------------------------------------------------------

    def set(self, name: str, value: Any) -> None:
        """Changes a parameter from the next step on; kerf.parameters() lists them."""
        self._run.apply(_text.to_json({"type": "set", "name": name, "value": value}))

    @property
    def params(self) -> Dict[str, Any]:
        """A copy of all current parameters, by name; set() changes one."""
        return {row["name"]: self._run.param(row["name"]) for row in _native.parameters()}

    # --- Hands, pins and boxes ------------------------------------------------------------------

    def grab(self, at: Point, radius: float, *, hand: int = 0, surface: bool = False) -> None:
        """Grabs all vertices within `radius` of `at` [m] that no other hand holds.

        With `surface` the radius is measured along the surface, so only one side of a cut is taken.
        """
        self.apply("grab", hand=hand, at=at, radius=radius, surface=surface)

    def drag(self, to: Point, *, hand: int = 0) -> None:
        """Moves a hand, and what it holds, to a point [m] during the next step."""
        self.apply("drag", hand=hand, to=to)

    def release(self, *, hand: int = 0) -> None:
        """Releases what a hand holds."""
        self.apply("release", hand=hand)

    def pin(self, *, center: Optional[Point] = None, radius: Optional[float] = None,
            low: Optional[Point] = None, high: Optional[Point] = None,
            velocity: Optional[Point] = None, seconds: Optional[float] = None) -> None:
        """Pins the vertices now in a ball (`center`, `radius`) or a box (`low`, `high`) [m].

        With a `velocity` [m/s] they move, for `seconds` or for good.
        """
        self.apply("pin", center=center, radius=radius, low=low, high=high, velocity=velocity,
                   seconds=seconds)

    def force(self, newtons: Point, *, center: Optional[Point] = None,
              radius: Optional[float] = None, low: Optional[Point] = None,
              high: Optional[Point] = None) -> None:
        """A force [N] on what is now in a ball or a box, as for pin(); 0 takes forces away."""
        self.apply("force", newtons=newtons, center=center, radius=radius, low=low, high=high)

    def unpin(self, *, center: Optional[Point] = None, radius: Optional[float] = None,
              low: Optional[Point] = None, high: Optional[Point] = None) -> None:
        """Unpins what is now in a ball or a box, given as for pin()."""
        self.apply("unpin", center=center, radius=radius, low=low, high=high)

    def move_pins(self, by: Point, rotate: Optional[Point] = None) -> None:
        """Rotates the pinned vertices about their middle [degrees] and moves them [m], at once."""
        self.apply("move_pins", by=by, rotate=rotate)

    @property
    def pinned(self) -> "npt.NDArray[np.uint32]":
        """Numbers of the vertices that are pinned, ascending."""
        return self._run.pinned()

    def add_box(self, center: Point, size: Point, rotate: Optional[Point] = None) -> None:
        """Adds a box that the body collides with, at the end of the list [m, degrees]."""
        self.apply("add_box", center=center, size=size, rotate=rotate)

    def change_box(self, box: int, center: Point, size: Point,
                   rotate: Optional[Point] = None) -> None:
        """Changes box number `box`, from 0, at once."""
        self.apply("change_box", box=box, center=center, size=size, rotate=rotate)

    def remove_box(self, box: int) -> None:
        """Removes a box; those after it in the list move up."""
        self.apply("remove_box", box=box)

    def remove_piece(self, piece: int) -> None:
        """Removes a piece, by its place in `pieces`, from 0; those after it move up."""
        self.apply("remove_piece", piece=piece)

    @property
    def boxes(self) -> List[Dict[str, Tuple[float, float, float]]]:
        """The current boxes: `center`, `size` [m], `rotate` [degrees]."""
        return self._run.boxes()

    # --- Time -----------------------------------------------------------------------------------

    def hold(self) -> None:
        """Pauses time: the blade still cuts, but the body does not move."""
        self.apply("hold")

    def resume(self) -> None:
        """Resumes time after hold()."""
        self.apply("run")

    def restart(self) -> None:
        """Restores the uncut body at rest, without blade, hands and pins. Time goes on."""
        self.apply("restart")

    def undo(self) -> None:
        """Undoes the last change. Time goes on. Raises kerf.InputError where there is none."""
        self.apply("undo")

    def redo(self) -> None:
        """Redoes the last change undone."""
        self.apply("redo")

    def snapshot(self) -> Snapshot:
        """A copy of the whole current state, to restore() as often as you like."""
        return self._run.snapshot()

    def restore(self, snapshot: Snapshot) -> None:
        """Returns to a snapshot of this simulation. It continues with the same bits."""
        self._run.restore(snapshot)

    def apply(self, event: str, **keys: Any) -> None:
        """Applies any event of a session that changes the body, by its type and its keys.

        Keys that are None are left out. See docs/session-format.md. Raises kerf.InputError, and
        changes nothing then.
        """
        self._run.apply(_text.event(event, **keys))

    # --- The state of the body ------------------------------------------------------------------

    @property
    def positions(self) -> "npt.NDArray[np.float64]":
        """Positions of all vertices, [vertices, 3] in metres: read-only, and never changed later.

        Between two steps each call returns the same numbers without a copy.
        """
        return self._run.positions()

    @property
    def velocities(self) -> "npt.NDArray[np.float64]":
        """Velocities of all vertices, [vertices, 3] in m/s."""
        return self._run.velocities()

    @property
    def mesh(self) -> Mesh:
        """Triangles, their pieces, and the rest shape; the same arrays until a cut changes them."""
        triangles, cut, piece, rest = self._run.triangles()
        return Mesh(triangles, cut.view(np.bool_), piece, rest)

    @property
    def strains(self) -> "npt.NDArray[np.float64]":
        """The principal strain of larger magnitude of each triangle of `mesh`."""
        return self._run.strains()

    @property
    def pieces(self) -> Pieces:
        """The pieces: their volumes and the boxes around them."""
        return Pieces(*self._run.pieces())

    @property
    def cut_report(self) -> Optional[Dict[str, Any]]:
        """The quality of the cuts, as `cut_report` of summary.json; None without a cut."""
        report: Optional[Dict[str, Any]] = json.loads(self._run.cut_report())
        return report

    # --- Pictures and files ---------------------------------------------------------------------

    def picture(self, width: int = 1280, height: int = 720,
                view: Optional[Keys] = None) -> "npt.NDArray[np.uint8]":
        """A picture, [height, width, 4] bytes of red, green, blue and alpha, top row first.

        view: the camera as in a session ({"eye": ..., "target": ...}) instead of its own.
        """
        size = _text.event("screenshot", file="picture.png", width=width, height=height)
        return self._run.picture(size, "" if view is None else _text.to_json(dict(view)))

    def _repr_png_(self) -> bytes:
        """What notebooks show of a simulation."""
        return _png.encoded(self.picture(640, 360))

    def export(self, file: PathLike, *, per_piece: bool = False,
               coordinates: Optional[str] = None) -> List[str]:
        """Writes the mesh: .ply, .obj, .stl, .glb, .gltf or .vtp, as the event `export` does.

        coordinates: "model", those of the model's own file, or "scene", metres. Returns the names
        of the files, all in one folder.
        """
        folder, name = os.path.split(os.fspath(file))
        event = _text.event("export", file=name, per_piece=per_piece, coordinates=coordinates)
        return self._run.export(folder or ".", event)

    def save_session(self, file: PathLike) -> None:
        """Writes everything done since the start as a session, with a check of the state.

        `kerf replay` runs it to the same bits, and the editor opens it.
        """
        self._run.save_session(os.fspath(file))


def _source(session: Union[PathLike, Keys], material: Optional[PathLike],
            params: Optional[Keys]) -> "_native.SessionSource":
    """A session by its file or its content, with other parameters at its start."""
    settings = [(name, _text.to_json(value)) for name, value in (params or {}).items()]
    chosen = "" if material is None else os.fspath(material)
    if isinstance(session, Mapping):
        return _native.SessionSource("", _text.to_json(dict(session)), chosen, settings)
    return _native.SessionSource(os.fspath(session), "", chosen, settings)


def _model_keys(model: Union[PathLike, Keys]) -> Dict[str, Any]:
    """The key `model` of a session."""
    if isinstance(model, Mapping):
        return dict(model)
    name = os.fspath(model)
    return {"builtin": name} if name in _native.builtin_models() else {"path": name}
