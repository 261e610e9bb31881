"""Cut soft 3D models from Python, step by step.

    import kerf

    sim = kerf.Simulation("sphere768", params={"gravity": [0, 0, 0]})
    sim.move_blade([-0.8, 0.6, 0.02], [0.8, 0.6, 0.05])
    sim.sweep([-0.8, -0.65, 0.02], [0.8, -0.65, 0.05], steps=120)
    sim.lift_blade()
    print(sim.report.pieces, sim.positions.shape)

All lengths are metres, all times seconds, as in session files. What can't be done raises a
kerf.Error with the message of the command line.

replay() works with any Python from 3.9 on. All else needs NumPy and the compiled module, which is
for some versions of Python; with another one its names raise an ImportError that says so.
"""

from . import _absent, _program
from ._errors import CheckFailed, Error, InputError, LimitError, OpenGLError
from .replay import replay

try:
    from ._native import Report, Snapshot
    from ._native import builtin_materials, builtin_models, paper_experiments, parameters
    from ._native import set_program_folder as _set_program_folder
    from ._native import version as __version__
    from .simulation import Mesh, Pieces, Simulation
    from .study import Study

    _set_program_folder(str(_program.folder()))
except ImportError as error:
    _reason = _absent.reason(error)

    def __getattr__(name: str) -> str:
        if name == "__version__":
            return _program.version()
        if name in __all__:
            raise ImportError(f"kerf.{name} {_reason}; kerf.replay() and `python -m kerf` work.")
        raise AttributeError(f"module 'kerf' has no attribute '{name}'")

__all__ = [
    "CheckFailed", "Error", "InputError", "LimitError", "Mesh", "OpenGLError", "Pieces", "Report",
    "Simulation", "Snapshot", "Study", "__version__", "builtin_materials", "builtin_models",
    "paper_experiments", "parameters", "replay",
]
