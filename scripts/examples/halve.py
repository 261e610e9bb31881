# %% [markdown]
# Find the cut that halves a volume, by bisection: where must a blade go straight down through a
# banana, so that both sides hold the same?
#
#     scripts/examples/halve.py [--out DIR] [--quick]

# %%
import argparse
import pathlib

import numpy as np

import kerf

parser = argparse.ArgumentParser()
parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/halve"))
parser.add_argument("--quick", action="store_true", help="a coarser model, fewer cuts")
arguments = parser.parse_args()
arguments.out.mkdir(parents=True, exist_ok=True)

tolerance = 1e-2 if arguments.quick else 1e-4  # of the volume

# %% Time stands, so that the body stays where it is while it is cut.
sim = kerf.Simulation("sphere20" if arguments.quick else "banana", params={"floor": None})
sim.hold()
low, high = sim.pieces.low[0], sim.pieces.high[0]
margin = 0.2 * (high - low).max()
uncut = sim.snapshot()


# %% A try: cut at one place along the x axis, weigh what lies to its left, and go back.
def cut_at(x: float) -> float:
    """Cuts there, and returns the share of the volume to the left."""
    slant = 0.013 * margin  # no blade stands exactly upright
    sim.move_blade([x, high[1] + margin, low[2] - margin],
                   [x + slant, high[1] + margin, high[2] + margin])
    sim.sweep([x, low[1] - margin, low[2] - margin],
              [x + slant, low[1] - margin, high[2] + margin], steps=30)
    sim.lift_blade()
    sim.step()
    pieces = sim.pieces
    left = (pieces.low[:, 0] + pieces.high[:, 0]) / 2 < x
    return pieces.rest_volume[left].sum() / pieces.rest_volume.sum()


# %% The share grows from left to right.
left, right = low[0], high[0]
for number in range(1, 40):
    middle = (left + right) / 2
    share = cut_at(middle)
    print(f"cut {number:2}: x = {middle:+.5f} m, {100 * share:.3f} % to the left")
    if abs(share - 0.5) < tolerance:
        break
    left, right = (middle, right) if share < 0.5 else (left, middle)
    sim.restore(uncut)

# %% The last cut is still there. Draw its halves apart, and keep it as a session for the editor.
sim.save_session(arguments.out / "halve.kerf.json")
sim.resume()
sim.set("floor", float(low[1]))
sim.step(10 if arguments.quick else 120)
picture = sim.picture(960, 540)
try:
    from matplotlib import image
except ImportError:
    print("Without matplotlib (apt install python3-matplotlib) there is no picture.")
else:
    image.imsave(arguments.out / "halve.png", np.ascontiguousarray(picture))
    print("written:", arguments.out / "halve.png")
