"""`kerf experiment NAME|all --out DIR`: its words, its exit codes."""

import argparse
import json
import logging
import pathlib
import sys

import kerf

from . import (bar, blade, fem, fracture, iterations, materials, paper, paper_figures, paper_report,
               practice, tear)
from .workshop import progress, remove, write

# As `kerf --help` says.
DONE, CHECK_FAILED, USAGE, INPUT, NO_OPENGL, LIMIT = range(6)
EXIT_CODES = ("Exit codes: 0 done, 1 a check failed, 2 wrong usage, 3 input missing or invalid,\n"
              "4 no usable OpenGL 4.5, 5 out of memory or another limit.")
REPORT_FILE = "report.md"
MOST_REPEATS = 100

#: Experiments of Kerf's own, which "all" leaves out: each has a folder of its name. They print
#: their report, or with --json their summary, and return what failed as a sentence, or "".
OWN = {"bar": bar.run, "fem": fem.run, "blade": blade.run, "materials": materials.run,
       "iterations": iterations.run, "tear": tear.run, "fracture": fracture.run,
       "practice": practice.run}


class Parser(argparse.ArgumentParser):
    """Reports a mistake as one sentence."""

    def error(self, message):
        raise UsageError(message)


class UsageError(Exception):
    """The arguments are invalid."""


def parser():
    names = [*paper.PAPER, *OWN, "all"]
    made = Parser(
        prog="kerf experiment", epilog=EXIT_CODES, allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Run the paper's experiments, the virtual test bench, or a comparison with\n"
                    "finite elements, headless and write a report")

    def known(name):
        if name not in names:
            raise argparse.ArgumentTypeError(
                f"there is no experiment '{name}'; there are {', '.join(names)}")
        return name

    def folder(text):
        if not text:
            raise argparse.ArgumentTypeError("the name is empty")
        return pathlib.Path(text)

    def repeats(text):
        if not text.isdecimal() or not 1 <= int(text) <= MOST_REPEATS:
            raise argparse.ArgumentTypeError(f"'{text}' is no number from 1 to {MOST_REPEATS}")
        return int(text)

    made.add_argument("name", metavar="NAME", type=known, help=", ".join(names))
    made.add_argument("--out", metavar="DIR", type=folder, required=True,
                      help="folder for the results")
    made.add_argument("--published", action="store_true",
                      help="use the solver, contact and cut of the paper")
    made.add_argument("--runs", metavar="N", type=repeats,
                      help="runs of each stroke, for the spread of frame rates (5)")
    made.add_argument("--whole", action="store_true",
                      help="with bar: all combinations of settings, which takes hours")
    made.add_argument("--quick", action="store_true",
                      help="with tear: one run of each specimen")
    made.add_argument("--json", action="store_true", help="print one JSON object")
    return made


def parse(words):
    arguments = parser().parse_args(words)
    if arguments.name in OWN and (arguments.published or arguments.runs):
        raise UsageError(f"'{arguments.name}' is none of the paper's experiments and takes "
                         "neither --published nor --runs")
    if arguments.whole and arguments.name != "bar":
        raise UsageError("--whole is for 'bar' alone; leave it out")
    if arguments.quick and arguments.name != "tear":
        raise UsageError("--quick is for 'tear' alone; leave it out")
    return arguments


def run_paper(arguments):
    """The paper's experiment of a name, or all of them. Returns what failed first, or ""."""
    out, published = arguments.out, arguments.published
    names = list(paper.PAPER) if arguments.name == "all" else [arguments.name]
    remove(out, REPORT_FILE, *paper_figures.later_files(names))
    results = [paper.run_experiment(name, out, published, arguments.runs or 5) for name in names]
    figure_2 = paper.run_figure_2(out, published) if paper.FIGURE_2_MODEL in names else None
    progress("figures")
    paper_figures.draw_all(results, figure_2, out)
    write(out / REPORT_FILE, paper_report.report(results, figure_2, published))
    progress()
    if arguments.json:
        print(json.dumps({"experiments": {r.name: r.summary for r in results},
                          "files": [REPORT_FILE]}))
    else:
        for r in results:
            volume = r.summary["volume_ratio"]
            print(f"{r.label}: volume mean {100 * volume['mean']:.2f} %, min "
                  f"{100 * volume['min']:.2f} %, final {100 * volume['final']:.2f} % (paper: mean "
                  f"{r.paper['mean_volume']:.1f} %), {len(r.summary['pieces'])} pieces")
        print(f"written to {out}: {REPORT_FILE}")
    return next((f"{r.name}: {r.summary['failures'][0]}" for r in results
                 if r.summary["failures"]), "")


def run(words):
    """Returns the exit code and the sentence that goes with it."""
    try:
        arguments = parse(words)
        if arguments.out.is_file():
            return INPUT, f"{arguments.out}: --out is a file; name a folder."
        kerf.Simulation("sphere20", undo_memory=0)  # without OpenGL nothing is begun
        failure = OWN.get(arguments.name, run_paper)(arguments)
        sys.stdout.flush()
        return (CHECK_FAILED, failure) if failure else (DONE, "")
    except UsageError as mistake:
        return USAGE, f"{mistake}; see kerf --help."
    except kerf.OpenGLError as error:
        return NO_OPENGL, str(error)
    except kerf.LimitError as error:
        return LIMIT, str(error)
    except kerf.Error as error:
        return INPUT, str(error)
    except OSError as error:
        return LIMIT, f"{error.filename or 'Standard output'}: {error.strerror}."
    except MemoryError:
        return LIMIT, "Memory is used up."


def main():
    logging.basicConfig(format="warning: %(message)s")
    code, sentence = run(sys.argv[1:])
    if sentence:
        progress()
        print(sentence if code == CHECK_FAILED else f"kerf: {sentence}", file=sys.stderr)
    return code
