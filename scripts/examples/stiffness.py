# %% [markdown]
# Sweep a stiffness and plot: how far does a ball sag that hangs from its top?
#
#     scripts/examples/stiffness.py [--out DIR] [--quick]

# %%
import argparse
import pathlib

import numpy as np

import kerf

parser = argparse.ArgumentParser()
parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/stiffness"))
parser.add_argument("--quick", action="store_true", help="few values, few steps")
arguments = parser.parse_args()
arguments.out.mkdir(parents=True, exist_ok=True)

moduli = np.geomspace(2e4, 2e6, 3 if arguments.quick else 9)  # [Pa]
steps = 40 if arguments.quick else 400


# %% A run: pin the top, let it hang, and see where its lowest point comes to rest.
def sag(modulus: float) -> float:
    """How far the lowest point has come down [m]."""
    sim = kerf.Simulation("sphere80", params={"youngs_modulus": modulus, "floor": None,
                                              "air_drag": 5})
    lowest = sim.positions[:, 1].min()
    sim.pin(low=[-1, 0.35, -1], high=[1, 1, 1])
    sim.step(steps)
    return lowest - sim.positions[:, 1].min()


sags = np.array([sag(modulus) for modulus in moduli])
for modulus, depth in zip(moduli, sags):
    print(f"{modulus:10.0f} Pa   {1000 * depth:7.2f} mm")

# %% Twice as stiff, half as far: the slope of the line is near -1 where strains are small.
slope = np.polyfit(np.log(moduli[-3:]), np.log(sags[-3:]), 1)[0]
print(f"slope at the stiff end: {slope:.2f}")

# %% The plot.
try:
    import matplotlib
except ImportError:
    print("Without matplotlib (apt install python3-matplotlib) there is no plot.")
else:
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6, 4), layout="constrained")
    axes.loglog(moduli, 1000 * sags, "o-")
    axes.set(xlabel="Young's modulus [Pa]", ylabel="sag [mm]", title="A ball that hangs")
    axes.grid(which="both", alpha=0.3)
    figure.savefig(arguments.out / "stiffness.png", dpi=120)
    print("written:", arguments.out / "stiffness.png")
