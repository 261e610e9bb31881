"""The text of report.md: the paper's tables and figures remade, in its order and with its numbers.

Each section is Markdown that ends with an empty line, or nothing where the runs give it nothing to
tell. The pictures are those of paper_figures.
"""

import re

import kerf

from . import paper_figures as figures
from .paper import NEGLIGIBLE, fps
from .workshop import (NOT_GIVEN, ROOT, bullets, caption, percent, picture, section, table,
                       value_text)

# What counts as far from the paper's figure.
FAR_RATE = 2  # ratio of frame rates, either way
FAR_VOLUME = 1  # difference of mean volumes [%]
DEEP_VOLUME = 5  # loss where the paper says "negligible" [%]
DECISIVE_SHARE = 0.1  # of a step that a search takes
PATTERNS = ["1-to-4", "1-to-3a", "1-to-2", "1-to-3b", "other"]


def report(results, figure_2, published):
    return "".join([
        head(results, published),
        section("What did not hold", sentences(results, "failures")),
        section("Remarks", sentences(results, "remarks")),
        differences(results, published),
        method(results, figure_2, published),
        cutting(results),
        deformation(results),
        performance(results),
        search(results),
        settings(results, published),
    ])


def per_model(head_cells, results, cells):
    return table(["model", *head_cells], [[r.label, *cells(r)] for r in results])


def sentences(results, key):
    return [f"{r.label}: {sentence}" for r in results for sentence in r.summary[key]]


def spread(values):
    """"mean (smallest to largest)" of rows, or of what summary.json has of them."""
    if not isinstance(values, dict):
        values = {"mean": values.mean(), "min": values.min(), "max": values.max()}
    return f"{values['mean']:.3f} ({values['min']:.3f} to {values['max']:.3f})"


def head(results, published):
    method_sentence = (
        "Solver, iterations, contact between pieces and course of the cut are the paper's as well "
        "(`solver` pbd, `paper_contact`, `open_cut`): the body is open while the blade is in it. "
        "What that leaves open is seen in the pictures of the cut where two hands draw the lips "
        "apart, for the picture alone. Stiffness factors, which the paper does not give, are our "
        "sessions'."
        if published else
        "Solver, iterations, contact and cut are Kerf's own; with `--published` they are the "
        "paper's.")
    return (
        "# The paper's experiments, remade\n\n"
        "The blade comes down through each body at rest, then gravity acts and the pieces fall on "
        "the floor (the paper's sections 3.1 and 3.2). Time steps are the paper's, the models are "
        f"our own of the same kinds and names. {method_sentence}\n\n"
        "Tables and figures have the paper's numbers. A dash stands where its text, all that is "
        f"known of its tables, gives no figure. Renderer: {results[0].summary['renderer']}.\n\n")


# --- What differs ---------------------------------------------------------------------------------


def differences(results, published):
    far = [sentence for r in results
           for sentence in (far_rate(r), far_volume(r, published), deep_volume(r)) if sentence]
    return ("## What differs from the paper, and why\n\n"
            + bullets(difference_paragraphs(results, published))
            + ("Figures that are far from the paper's:\n\n" + bullets(far) if far else ""))


def difference_paragraphs(results, published):
    return [
        "**Volume.** Edges, bends and ISPCs alone hold it, as in the paper. How much is lost at "
        "the impact depends on their stiffness factors, which the paper does not give."
        if published else
        "**Volume.** Kerf's own solver holds the volume of each piece by a constraint of its own, "
        "whenever `ispc_stiffness` is above 0. So 100 % is not the work of the ISPCs, and no loss "
        "at the impact can be seen. With `--published` ISPCs alone hold it.",
        times_paragraph(results),
        "**No drawing.** A frame here is a step without a picture. The paper's frames are drawn "
        "by Unity.",
        "**Machine.** The paper's computer had an NVIDIA GeForce RTX 3060 Ti and an Intel Core "
        "i7-7700, so times and frame rates do not compare from one machine to the other.",
        "**Course of the cut.** As in the paper, the body is hollow while the blade is in it, and "
        "its wounds are patched when the stroke ends. So that step is the longest one of the cut."
        if published else
        "**Course of the cut.** The paper leaves a hole that is patched when the cut is complete. "
        "Kerf closes each step by walls, so the body is closed all the time and no step stands "
        "out.",
        "**Search.** The paper walks over adjacent triangles from one that is hit, and owes its "
        "gain to that. Kerf finds all triangles in a tree.",
        "**Solver.** The paper's is \"Gauss-Seidel-like\". Kerf solves constraints of one kind at "
        "once (Jacobi), which is softer at equal iterations but gives the same bits for any "
        "number of threads."
        if published else
        "**Solver.** The paper's sweeps solve one constraint after the other. Kerf takes implicit "
        "steps of a material as stiff as `youngs_modulus` says, with as many iterations of "
        "conjugate gradients as each step needs.",
        "**Models.** They are our own, of the same kinds and names: the paper's octopus and "
        "banana are not published, nor are their counts.",
    ]


def times_paragraph(results):
    deform, collide, cut = (sum(r.summary["stages_ms"][stage]["mean"] for r in results)
                            for stage in ("deform", "collide", "cut"))
    course = ("So it is here." if cut > deform + collide else
              "Here it is the other way round: solving and contact take most of a step, and the "
              "cut, which touches only what lies near the blade, little.")
    return ("**What takes the time.** In the paper deforming and contact run on a GPU and take "
            f"next to nothing, so the cut decides the frame rate. {course} For all models "
            f"together, the means of a step are {deform:.1f} ms for deforming, {collide:.1f} ms "
            f"for contact and {cut:.2f} ms for cutting (renderer: "
            f"{results[0].summary['renderer']}).")


def far_rate(r):
    rate, stages = r.summary["fps"]["mean"], r.summary["stages_ms"]
    ratio = rate / r.paper["mean_fps"]
    if 1 / FAR_RATE < ratio < FAR_RATE:
        return ""
    return (f"{r.label}: {rate:.1f} frames a second are {ratio:.2f} of the paper's "
            f"{r.paper['mean_fps']:.1f}. Of {r.rows['frame_ms'].mean():.1f} ms of a step, "
            f"deforming takes {stages['deform']['mean']:.1f}, contact "
            f"{stages['collide']['mean']:.1f} and cutting {stages['cut']['mean']:.2f}.")


def far_volume(r, published):
    mean = 100 * r.summary["volume_ratio"]["mean"]
    if abs(mean - r.paper["mean_volume"]) <= FAR_VOLUME:
        return ""
    why = ("stiffness factors and model are other ones" if published else "a constraint holds it")
    return (f"{r.label}: a mean volume of {mean:.2f} % where the paper has "
            f"{r.paper['mean_volume']:.1f} %: {why}.")


def deep_volume(r):
    least = 100 * r.summary["volume_ratio"]["min"]
    if least > 100 - DEEP_VOLUME or r.paper["course"] != NEGLIGIBLE:
        return ""
    return (f"{r.label}: the volume falls to {least:.1f} % where the paper speaks of negligible "
            "change. Thin parts fold at the impact; the paper's bending stiffness is not known.")


# --- Method ---------------------------------------------------------------------------------------


def shader_buffers():
    """Binding, name, entries and contents of each buffer that kernels of the simulation see."""
    header = (ROOT / "shaders/shared/bindings.h").read_text()
    return re.findall(r"^SHARED_CONST uint k(\w+)Binding =\s+(\d+)u;\s*//\s*([^:\n]*): (.*)$",
                      header, re.MULTILINE)


def group_size():
    """Threads of a work group, in nearly every kernel."""
    records = (ROOT / "shaders/shared/body_records.h").read_text()
    return int(re.search(r"kGroupSize = (\d+)", records).group(1))


def method(results, figure_2, published):
    kernels = sum(1 for _ in (ROOT / "shaders/sim").rglob("*.comp"))
    threads = group_size()
    groups = ", ".join(f"{r.label} {-(-r.summary['after']['vertices'] // threads)}"
                       for r in results)
    return (
        "## Method (the paper's section 2)\n\n"
        + (figure_two(*figure_2, published) if figure_2 else "")
        + table(["binding", "buffer", "entries", "what an entry holds"],
                [[binding, name, *rest] for name, binding, *rest in shader_buffers()])
        + caption("Table 1", (
            "GPU buffers of the solver, read from `shaders/shared/bindings.h`. Buffers that no "
            f"kernel needs together share a binding. {kernels} kernels run with {threads} threads "
            "in a group. A kernel runs as many groups as its entries need; over the vertices at "
            f"the end these are at least: {groups}. With `pbd` one group makes all sweeps of a "
            "small body that meets nothing but the floor. The paper has 10 buffers, for N "
            "vertices, M distance and bending constraints, L ISPCs and the cubes, and 8 groups of "
            "1024 threads in all kernels.")))


def figure_two(without, with_ispcs, published):
    reason = ("As in the paper, the halves collapse without ISPCs."
              if without.picture_volume < 0.9 else
              "The paper's loss is not seen: with stiffness 1 the bends of plain PBD hold the skin "
              "up alone. The paper does not give its stiffness of bending."
              if published else "The paper's loss is not seen here.")

    def remark(label, run):
        final, steps = run.summary["volume_ratio"]["final"], run.summary["steps"]
        return " ".join([f"{label}: the volume is {percent(run.picture_volume)} % in the picture "
                         f"and {percent(final)} % after {steps} steps.", *run.summary["remarks"]])

    return (picture("Two halves on the floor without and with ISPCs", figures.FIGURE_2_FILE)
            + caption("Figure 2", "Volume and shape after cutting and falling: (a) without ISPCs "
                                  f"(`ispc_stiffness` 0); (b) with ISPCs. {reason} "
                                  f"{remark('(a)', without)} {remark('(b)', with_ispcs)}"))


# --- Cutting and deformation ----------------------------------------------------------------------


def cutting(results):
    def chain(r, count):
        return (f"{r.summary['before'][count]} / {r.after_stroke[count]:.0f} / "
                f"{r.summary['after'][count]}")

    return (
        "## Progressive cutting (the paper's section 3.1)\n\n"
        + per_model(["vertices", "triangles", "ISPCs", "paper: triangles before"], results,
                    lambda r: [*(chain(r, count) for count in ("vertices", "triangles", "ispcs")),
                               r.paper["triangles"] or NOT_GIVEN])
        + caption("Table 2", (
            "Counts before the cut / right after it / at the end of the run. Between the last two, "
            "slivers and folded edges of the cut faces are collapsed. The paper's text gives none "
            "of its counts; those of the spheres are in their names."))
        + strips(results, "Cutting simulation", figures.cutting_figure)
        + per_model(PATTERNS, results, lambda r: [r.summary["subdivisions"][p] for p in PATTERNS])
        + "Triangles of the surface by how they were divided, with the names of the paper's "
          "figure 4. \"Other\" are triangles in which the blade's way bends or that it meets "
          "twice.\n\n")


def strips(results, title, figure_of):
    """Figures of strips, one below the other, each with its caption."""
    text = ""
    for number in sorted({figure_of(r.name).number for r in results}):
        own = [(r, figure_of(r.name)) for r in results if figure_of(r.name).number == number]
        text += "".join(picture(f"{title} of {r.label}", part.file) for r, part in own)
        parts = "; ".join(f"{part.label} {r.label}: {figures.settings_of(r)}" for r, part in own)
        text += caption(f"Figure {number}", f"{title}: {parts}.")
    return text


def deformation(results):
    parts = "; ".join(f"{figures.volume_label(r.name)} {r.label}" for r in results)
    return (
        "## Deformation with ISPCs (the paper's section 3.2)\n\n"
        + strips(results, "Deformation after cutting", figures.fall_figure)
        + per_model(["mean", "min", "final", "paper: mean", "paper: course"], results,
                    lambda r: [*(percent(r.summary["volume_ratio"][k])
                                 for k in ("mean", "min", "final")),
                               f"{r.paper['mean_volume']:.1f}", r.paper["course"]])
        + picture("Volume against time", figures.FIGURE_10_FILE)
        + caption("Figure 10", f"Volume against time, % of rest: {parts}. Dashed: the paper's "
                               "mean. It has no error bars: the same session gives the same bits "
                               "in each run, so its volume has no spread."))


# --- Performance ----------------------------------------------------------------------------------


def previous_fps(paper):
    """Frames per second of the paper's previous method, as its gain says."""
    return paper["mean_fps"] / (1 + paper["gain"] / 100) if paper["gain"] else None


def performance(results):
    return ("## Performance (the paper's sections 3.2 and 3.3)\n\n" + figure_nine(results)
            + rates_table(results) + table_three(results))


def figure_nine(results):
    runs = len(results[0].strokes)
    return (
        picture("Average frames per second of all models", figures.FIGURE_9_FILE)
        + caption("Figure 9", (
            "Average frames per second. \"While the blade cuts\" is the mean of "
            f"{runs} {'run' if runs == 1 else 'runs'}, one after the other, from the first pose of "
            "the blade to the end of the stroke: the complete run and repetitions of its stroke "
            "alone. Error bars are the smallest and the largest mean of one run. A frame is a step "
            "without a window and without pictures: solving, contact and cutting.")))


def rates_table(results):
    def cells(r):
        rates = r.rates()
        shown = [sum(rates) / len(rates), min(rates), max(rates), r.summary["fps"]["mean"],
                 r.rows["frame_ms"].max(), r.paper["mean_fps"]]
        return [f"{value:.1f}" for value in shown]

    return per_model(["while the blade cuts: mean", "smallest", "largest", "whole run",
                      "slowest frame, ms", "paper"], results, cells)


def table_three(results):
    def cells(r):
        rate, previous, stages = r.paper["mean_fps"], previous_fps(r.paper), r.summary["stages_ms"]
        return [f"{previous:.1f}" if previous else f"above {rate:.1f}", f"{rate:.1f}", gain_of(r),
                f"{r.summary['fps']['mean']:.1f}",
                *(spread(stages[stage]) for stage in ("deform", "collide", "cut")),
                spread(r.strokes[0]["cut_ms"])]

    return (
        per_model(["paper: previous method, frames/s", "paper: ISPC method, frames/s",
                   "paper: gain, %", "Kerf, frames/s", "deform, ms", "collide, ms", "cut, ms",
                   "cut, of a stroke's steps, ms"], results, cells)
        + caption("Table 3", (
            "Frame rates of the paper's previous and its ISPC method beside ours, and our stage "
            "times as mean (smallest to largest) of the steps of the whole run. Those of the "
            "previous method follow from the gains that the text gives; of Sphere 20 and 80 it "
            "says that the previous method was faster. The text has no stage times: deforming and "
            "colliding take very little for all models; cutting takes little on average, growing "
            "with the model, and far more than both at most, the banana above all.")))


def gain_of(r):
    return f"{r.paper['gain']:.2f}" if r.paper["gain"] else NOT_GIVEN


# --- Search ---------------------------------------------------------------------------------------


def search(results):
    return (
        "## The search for triangles (the paper's section 4)\n\n"
        "The paper attributes its gain to a search among adjacent triangles instead of all. "
        "`cut_search` has both, and the tree that Kerf uses; all three find the same triangles, "
        "so the cut is the same bit for bit. The paper's search ends with the walk from its first "
        "seed, which misses what hangs together with no seed, such as a second arm; ours goes on "
        "to the end of the list for more seeds. Each row is one run of the stroke alone.\n\n"
        + table(["model", "`cut_search`", "triangles tested", "search, ms",
                 "of it, walk from the first seed, ms", "most seeds", "cut, ms", "frames/s"],
                [way_cells(r, way) for r in results for way in r.searches])
        + picture("Times of the three ways to search", figures.SEARCH_FILE)
        + "Gain of `adjacency` over `all`. As measured, it has all that disturbs the times of two "
          "runs. \"By the walk alone\" is what the paper's search would give, if all other times "
          f"were as they are with `all`.{share_sentence(results)}\n\n"
        + per_model(["paper: gain, %", "frames/s, as measured, %", "frames/s, by the walk alone, %",
                     "cuts/s, by the walk alone, %"], results, gain_cells))


def way_cells(r, way):
    rows = r.searches[way]
    walk = ([spread(rows["search_walk_ms"]), f"{rows['search_seeds'].max():.0f}"]
            if way == "adjacency" else [NOT_GIVEN] * 2)
    return [r.label, way, f"{rows['search_tests'].mean():.0f}", spread(rows["search_ms"]), *walk,
            spread(rows["cut_ms"]), f"{fps(rows):.1f}"]


def gain_cells(r):
    """The last two columns leave all other times as they are among all triangles."""
    walk, every = r.searches["adjacency"], r.searches["all"]
    saved = every["search_ms"].mean() - walk["search_walk_ms"].mean()
    frame, cut = every["frame_ms"].mean(), every["cut_ms"].mean()

    def gain(before, now):
        return f"{100 * (before / now - 1):.2f}" if now > 0 else NOT_GIVEN

    return [gain_of(r), gain(frame, walk["frame_ms"].mean()), gain(frame, frame - saved),
            gain(cut, cut - saved)]


def share_sentence(results):
    """How much of a step the slowest search takes."""
    most = max(r.searches["all"]["search_ms"].mean() / r.searches["all"]["frame_ms"].mean()
               for r in results)
    return ("" if most > DECISIVE_SHARE else
            f" Even the search among all takes at most {100 * most:.1f} % of a step of a stroke "
            "here, so it cannot decide the frame rate.")


# --- Settings -------------------------------------------------------------------------------------


def settings(results, published):
    def row(name, cell):
        return [name, *(cell(r) for r in results)]

    def gravity_later(r):
        event = next(e for e in r.session["events"] if e.get("name") == "gravity")
        return f"{value_text(event['value'])} from step {event['step']}"

    rows = [row("steps", lambda r: r.summary["steps"]),
            row("gravity after the cut, m/s^2", gravity_later)]
    for p in kerf.parameters():
        name = f"`{p['name']}`" + (f", {p['unit']}" if p["unit"] else "")
        rows.append(row(name, lambda r, key=p["name"]: value_text(r.params[key])))
    rows += [row("pieces at the end", lambda r: len(r.summary["pieces"])),
             row("closed after every step",
                 lambda r: "yes" if r.summary["closed_every_step"] else "no")]
    return ("## Settings\n\nAll parameters at the start of each run, by their names in a session. "
            f"Time steps {'and iterations ' if published else ''}are the paper's; it gives no "
            "stiffness, modulus, density or friction, so these are our own.\n\n"
            + table(["setting", *(r.label for r in results)], rows))
