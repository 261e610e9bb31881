#!/usr/bin/env python3
"""Draws docs/images/drag.svg: the way of a drag from the pointer to the picture.

Fails where a function that the figure names no longer stands in its folder.
"""
import re

from svg import BLUE, GREEN, GREY, INK, ORANGE, ROOT, Drawing, mixed

# Heading, colour; then what happens, the function, its folder.
COLUMNS = [
    ("1  The pointer moves", ORANGE, [
        ("the system tells of a move", "Window::State::onMove", "app/window"),
        ("it waits for the next picture", "Editor::post", "app/editor"),
        ("the editor takes all that waits", "EditorView::move", "app/editor/view"),
        ("pixels become poses of the blade", "StrokeSpace::bladeAt", "app/scene"),
        ("poses queue up, close together", "BladeStroke::moveTo", "app/scene"),
    ]),
    ("2  A step", BLUE, [
        ("one pose, as a recorded command", "SceneTimeline::perform", "app/scene/timeline"),
        ("the blade is told", "Simulation::execute", "sim/run"),
        ("what must come back is asked for", "MeshSync::prefetch", "sim/run/parts"),
        ("the soft body moves, on the GPU", "GpuSolver::step", "sim/solve"),
        ("the cutter takes the pose", "Cutter::advance", "sim/cut/stroke"),
        ("it plans one try after the other", "cut::planStep", "sim/cut/plan"),
        ("one succeeds: the mesh changes", "cut::commit", "sim/cut/commit"),
        ("model and GPU follow the change", "followCut", "sim/run/blade"),
        ("counts and volumes are there", "Simulation::State::publish", "sim/run"),
    ]),
    ("3  The picture", GREEN, [
        ("series of the plots grow", "EditorReadings::addStep", "app/scene/readout"),
        ("passes draw the solver's buffers", "Renderer::draw", "render"),
        ("panels go over a copy of that", "Interface::draw", "ui"),
        ("the window shows it", "Window::show", "app/window"),
        ("panels read the new numbers", "Editor::State::describe", "app/editor"),
    ]),
]
LEFT, WIDTH, TOP, STEP, HEIGHT = 22, 278, 84, 62, 48


def require(function, folder):
    name = re.escape(function.removeprefix("cut::"))
    if not any(re.search(rf"\b{name}\(", source.read_text())
               for source in (ROOT / folder).glob("*.cpp")):
        raise SystemExit(f"no {function} in {folder}")


def main():
    rows = max(len(column[2]) for column in COLUMNS)
    height = TOP + rows * STEP + 30
    d = Drawing(920, height, "The way of a drag from the pointer to the picture")
    tops = []
    for c, (heading, color, steps) in enumerate(COLUMNS):
        x = LEFT + c * (WIDTH + 21)
        d.box(x, 20, WIDTH, height - 40, mixed(color, "#ffffff", 0.94), mixed(color, "#ffffff", 0.65), 12)
        d.text((x + 16, 50), heading, color, size=17, weight="bold")
        top = TOP - 14
        tops.append((x, top + (len(steps) - 1) * STEP))
        for i, (words, function, folder) in enumerate(steps):
            require(function, folder)
            y = top + i * STEP
            d.box(x + 14, y, WIDTH - 28, HEIGHT, "#ffffff", color, 7, 1.3)
            d.text((x + 24, y + 19), words, INK, size=13.5)
            d.text((x + 24, y + 37), function, color, size=12, family="monospace")
            if i:
                d.line([(x + WIDTH / 2, y - STEP + HEIGHT), (x + WIDTH / 2, y - 1)], color, 1.6, arrow=True)
    for (x, y), color in zip(tops[:2], (ORANGE, BLUE)):
        d.way([(x + WIDTH - 14, y + HEIGHT / 2), (x + WIDTH + 10, y + HEIGHT / 2),
               (x + WIDTH + 10, TOP - 14 + HEIGHT / 2), (x + WIDTH + 33, TOP - 14 + HEIGHT / 2)], color)
    notes = {0: ["Nothing here touches the body.", "Steps take the queued poses up,",
                 "one each."],
             2: ["Panels show a step one picture later.", "They only read: what they answer is",
                 "a command of a later step."]}
    for c, lines in notes.items():
        x = LEFT + c * (WIDTH + 21) + 16
        for i, line in enumerate(lines):
            d.text((x, TOP + 5 * STEP + 22 + 19 * i), line, GREY, size=13.5)
    d.save("drag.svg")


if __name__ == "__main__":
    main()
