# %% [markdown]
# Drive a cut from a controller at each step: a blade is pressed through a ball, and its speed is
# regulated so that the force on it stays near a target, as a robot would.
#
#     scripts/examples/controller.py [--out DIR] [--quick]

# %%
import argparse
import pathlib

import numpy as np

import kerf

parser = argparse.ArgumentParser()
parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/controller"))
parser.add_argument("--quick", action="store_true", help="few steps")
arguments = parser.parse_args()
arguments.out.mkdir(parents=True, exist_ok=True)

target = 60.0  # [N]
slowest, fastest = 0.02, 2.0  # [m/s]
gain = 0.3  # change of the speed for a force that is off by all of the target
most_steps = 60 if arguments.quick else 2000

# %% A ball in a bowl of boxes, and a blade with a blunt body that pushes what it meets.
sim = kerf.Simulation("sphere80", forces=True, params={"floor": -0.5, "blade_push": 1})
sim.pin(low=[-1, -1, -1], high=[1, -0.42, 1])
top, bottom = 0.6, -0.3
height, speed = top, 1.0
sim.move_blade([-0.8, height, 0.01], [0.8, height, 0.03])

# %% The loop of control: measure, decide, move, step.
heights, speeds, forces = [], [], []
time_step = sim.params["time_step"]
while height > bottom and len(heights) < most_steps:
    height -= speed * time_step
    sim.move_blade([-0.8, height, 0.01], [0.8, height, 0.03])
    report = sim.step()
    force = report.blade_force[1]  # upwards, against the blade
    speed *= 1 + gain * np.clip((target - force) / target, -1, 1)
    speed = float(np.clip(speed, slowest, fastest))
    heights.append(height)
    speeds.append(speed)
    forces.append(force)
sim.lift_blade()
sim.step()
sim.save_session(arguments.out / "controller.kerf.json")

inside = np.abs(heights) < 0.4
print(f"{len(heights)} steps, from {max(speeds):.2f} down to {min(speeds):.2f} m/s")
if inside.any():
    print(f"force in the ball: mean {np.mean(np.array(forces)[inside]):.1f} N, "
          f"most {np.max(np.array(forces)[inside]):.1f} N; wanted {target:.0f} N")

# %% The plot.
try:
    import matplotlib
except ImportError:
    print("Without matplotlib (apt install python3-matplotlib) there is no plot.")
else:
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, upper, lower) = pyplot.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    left.imshow(sim.picture(480, 480))
    left.axis("off")
    upper.plot(heights, forces)
    upper.axhline(target, linestyle=":", color="grey")
    upper.set(xlabel="height of the blade [m]", ylabel="force on the blade [N]")
    lower.plot(heights, speeds)
    lower.set(xlabel="height of the blade [m]", ylabel="speed [m/s]")
    for axes in (upper, lower):
        axes.invert_xaxis()
        axes.grid(alpha=0.3)
    figure.savefig(arguments.out / "controller.png", dpi=110)
    print("written:", arguments.out / "controller.png")
