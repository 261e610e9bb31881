"""Cut soft 3D models from Python, step by step.

    import kerf

    sim = kerf.Simulation("sphere768", params={"gravity": [0, 0, 0]})
    sim.move_blade([-0.8, 0.6, 0.02], [0.8, 0.6, 0.05])
    sim.sweep([-0.8, -0.65, 0.02], [0.8, -0.65, 0.05], steps=120)
    sim.lift_blade()
    print(sim.report.pieces, sim.positions.shape)

All lengths are metres, all times seconds, as in session files. What can't be done raises a
kerf.Error with the message of the command line.
"""

from . import _interpreter

_interpreter.refuse_another()

from . import _program
from ._native import CheckFailed, Error, InputError, LimitError, OpenGLError, Report, Snapshot
from ._native import builtin_materials, builtin_models, paper_experiments, parameters
from ._native import version as __version__
from .replay import replay
from .simulation import Mesh, Pieces, Simulation
from .study import Study

_program.tell_native()

__all__ = [
    "CheckFailed", "Error", "InputError", "LimitError", "Mesh", "OpenGLError", "Pieces", "Report",
    "Simulation", "Snapshot", "Study", "__version__", "builtin_materials", "builtin_models",
    "paper_experiments", "parameters", "replay",
]
