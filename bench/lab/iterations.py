"""Auto steps and iterations: the error that they leave in motions of the paper's models."""

import typing

import kerf
import numpy as np

from .workshop import progress, publish, remove, table

TIME_STEP = 1 / 60  # [s]: auto divides it as each step needs
#: Of the motion that counts as true: iterations, and time steps instead of one.
TRUE_ITERATIONS, TRUE_STEPS = 60, 10
GRAVITY, DRAG = 9.81, 1  # [m/s^2], [1/s]
FALL, FALL_STEPS, IMPACT_STEPS = 0.2, 12, 8  # [m], until the floor, from there on
SWING_STEPS = {"sphere20": 12, "sphere80": 12, "sphere768": 12, "banana": 8, "octopus": 6}
PINNED = 0.1  # of the length, at one end
MOTIONS = ("first swing", "drop")
CUTS = ("in half", "half through")
CUT_AT, CUT_STEPS = 0.513, 8  # of the box, beside its middle, where edges lie
MODULI = (1e5, 1e6, 1e7)
ASKED = 0.02  # the parameter `iteration_error`
ALL_ASKED, ASKED_OF = (0.02, 0.01, 0.005, 0.002), ("sphere768", 3e5)


class Setting(typing.NamedTuple):
    """A motion of a model."""
    model: str
    modulus: float  #: [Pa]
    motion: str  #: one of MOTIONS
    cut: str = "none"  #: or one of CUTS


class Run(typing.NamedTuple):
    """A motion with auto steps and iterations."""
    setting: Setting
    asked: float
    steps: tuple  #: implicit steps of a time step, the least and the most
    iterations: tuple  #: of a stage, the least and the most
    error: float


def begin(setting, params):
    """A model that is about to swing from a pinned end, or to fall on the floor."""
    rest = kerf.Simulation(setting.model, undo_memory=0).mesh.rest_positions
    low, high = rest.min(axis=0), rest.max(axis=0)
    drops = setting.motion == "drop"
    sim = kerf.Simulation(setting.model, undo_memory=0, params={
        "youngs_modulus": setting.modulus, "gravity": [0, -GRAVITY, 0], "air_drag": DRAG,
        "floor": float(low[1]) - FALL if drops else None, **params})
    along = 1 if setting.model.startswith("sphere") else int(np.argmax(high - low))
    if setting.cut != "none":
        make_cut(sim, setting.cut, low, high, along)
    if not drops:
        low[along] = high[along] - PINNED * (high - low)[along]
        sim.pin(low=low - 1e-3, high=high + 1e-3)
    return sim


def make_cut(sim, cut, low, high, along):
    """While time stands still: along the longest axis, so that pins hold both halves; or across it,
    from one side to the middle."""
    across = {0: (2, 1), 1: (2, 0), 2: (1, 0)}[along]
    normal, forth = (across[0], along) if cut == "in half" else (along, 0 if along == 1 else 1)
    span = 3 - normal - forth
    beside = 0.05 * (high - low).max()
    blade = np.array([(low + high) / 2] * 2)
    blade[:, normal] = low[normal] + CUT_AT * (high - low)[normal]
    blade[:, span] = low[span] - beside, high[span] + beside
    first, last = blade.copy(), blade
    if cut == "in half":
        first[:, forth], last[:, forth] = low[forth] - beside, high[forth] + beside
    else:
        first[:, forth] = high[forth] + beside
    sim.hold()
    sim.move_blade(*first)
    sim.step()
    sim.sweep(*last, CUT_STEPS)
    sim.lift_blade()
    sim.step(2)
    sim.resume()


def move(setting, iterations, error=ASKED, steps=1):
    """Positions after each time step, and the report of each. `steps`: time steps instead of
    one."""
    sim = begin(setting, {"iterations": iterations, "iteration_error": error,
                          "time_step": TIME_STEP / steps})
    count = (FALL_STEPS + IMPACT_STEPS if setting.motion == "drop"
             else SWING_STEPS[setting.model])
    places, reports = [], []
    for _ in range(count):
        reports.append(sim.step(steps))
        places.append(sim.positions)
    return np.array(places), reports


def undisturbed(setting, rest):
    """Where all would be without the floor, or the load."""
    places = np.repeat(rest[None], FALL_STEPS + IMPACT_STEPS if setting.motion == "drop"
                       else SWING_STEPS[setting.model], axis=0)
    if setting.motion == "drop":
        times = TIME_STEP * np.arange(1, len(places) + 1)
        fall = GRAVITY * (times / DRAG - (1 - np.exp(-DRAG * times)) / DRAG**2)
        places[:, :, 1] -= fall[:, None]
    return places


class Truth:
    """A motion in short steps with the most iterations, against which others are held."""

    def __init__(self, setting):
        self.setting = setting
        self.places = move(setting, TRUE_ITERATIONS, steps=TRUE_STEPS)[0]
        rest = begin(setting, {}).mesh.rest_positions
        self.first = FALL_STEPS if setting.motion == "drop" else 0
        self.way = self.rms(undisturbed(setting, rest))

    def rms(self, places):
        """How far others are from it, from the impact or the load on [m]."""
        apart = (places - self.places)[self.first:]
        return np.sqrt((apart**2).sum(axis=2).mean())

    def error_of(self, places):
        """As a share of the way that load or floor has moved all by."""
        return self.rms(places) / self.way


def measure(setting, all_asked=(ASKED,)):
    truth, runs = Truth(setting), []
    for asked in all_asked:
        places, reports = move(setting, "auto", asked)
        steps, iterations = ((min(numbers), max(numbers)) for numbers in (
            [r.implicit_steps for r in reports], [r.iterations for r in reports]))
        runs.append(Run(setting, asked, steps, iterations, truth.error_of(places)))
    return runs


COLUMNS = ("steps", "iterations", "error, %")


def errors_table(runs):
    """A row for each body and modulus, with both motions."""
    by_setting = {r.setting: r for r in runs}
    bodies = dict.fromkeys((s.model, s.cut, s.modulus) for s in by_setting)
    return table(["model", "cut", "E, Pa",
                  *(f"{motion}: {what}" for motion in MOTIONS for what in COLUMNS)],
                 [[model, cut, f"{modulus:.0e}",
                   *(cell for motion in MOTIONS
                     for cell in cells(by_setting.get(Setting(model, modulus, motion, cut))))]
                  for model, cut, modulus in bodies])


def cells(run):
    def range_of(numbers):
        """"5 to 7"."""
        least, most = numbers
        return str(most) if least == most else f"{least} to {most}"

    return [""] * len(COLUMNS) if run is None else [
        range_of(run.steps), range_of(run.iterations), f"{100 * run.error:.2g}"]


def report_of(runs, by_asked):
    return (
        "# Auto steps and iterations\n\n"
        f"Models in time steps of {1000 * TIME_STEP:.3g} ms, each of as many implicit steps as "
        "auto takes: the first swing after gravity is switched on, one end pinned; and a drop from "
        "0.2 m, from the impact on. Some are cut before. Errors are against "
        f"{TRUE_ITERATIONS} iterations in time steps of {1000 * TIME_STEP / TRUE_STEPS:.3g} ms, "
        "RMS over vertices and steps, in per cent of the way that load or floor has moved all by. "
        f"`iteration_error` is {ASKED:g}.\n\n" + errors_table(runs)
        + (f"## Error asked and reached\n\n{ASKED_OF[0]}, {ASKED_OF[1]:.0e} Pa.\n\n"
           + table(["asked, %", *(f"{motion}: {what}" for motion in MOTIONS for what in COLUMNS)],
                   [[f"{100 * asked:g}", *(cell for r in by_asked if r.asked == asked
                                           for cell in cells(r))] for asked in ALL_ASKED])
           if by_asked else ""))


def summary_of(runs):
    return {"runs": [{**r.setting._asdict(), **r._asdict(), "setting": str(r.setting)}
                     for r in runs]}


def run(arguments):
    """Prints the report or the summary. Nothing fails."""
    folder = arguments.out / "iterations"
    remove(folder, "report.md", "summary.json")
    runs = []
    for setting in (Setting(model, modulus, motion, cut) for cut in ("none", *CUTS)
                    for model in SWING_STEPS for modulus in MODULI for motion in MOTIONS):
        progress(f"{setting.model}, cut: {setting.cut}, {setting.modulus:.0e} Pa, {setting.motion}")
        runs += measure(setting)
    by_asked = [r for motion in MOTIONS for r in measure(Setting(*ASKED_OF, motion), ALL_ASKED)]
    publish(arguments, folder, report_of(runs, by_asked), summary_of(runs + by_asked))
    return ""
