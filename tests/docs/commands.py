#!/usr/bin/env python3
"""Runs the commands of the pages: each block of `sh` of README.md and of docs/.

  commands.py KERF [PAGE...]     KERF is the program, such as build/kerf

Each page has a scratch folder of its own, in which its blocks run one after the other. There are
`assets`, `docs`, `scripts` and `tests` of the source tree, and `kerf` is on the path. Replays end
after STEPS steps, so that all of it takes about a minute; `scripts/run` opens what is built.

A comment before a block says how it runs:

  <!-- run: window -->         it opens a window, which must appear (under Xvfb)
  <!-- run: exit 1 -->         it ends with that exit code instead of 0
  <!-- run: not here; WHY -->  it is not run. Its programs, verbs and options must exist all the same
  <!-- before: COMMAND -->     what the test does first, in the place of a person
  <!-- file: NAME -->          the block, of any language, is this file

`<!-- page: not here; WHY -->` holds for the blocks of a page that say nothing of themselves.
"""
import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
STEPS = 24  # of a replay; at least one blade of each tutorial has come near its body then
PATIENCE = 300  # seconds for a block, and for a window to appear
FENCE = re.compile(r"^( *)```(\S*)\s*$")
REMARK = re.compile(r"<!-- (run|before|file|page): (.*?) -->", re.S)
BLANKS = re.compile(r"\s+")


class Block:
    """A fenced block with what the comments before it say."""

    def __init__(self, page, line, language, text, remarks):
        self.place = f"{page.relative_to(ROOT)}:{line}"
        self.language = language
        self.text = text
        self.run = remarks.get("run", "")
        self.before = remarks.get("before", "")
        self.file = remarks.get("file", "")

    @property
    def reason(self):
        """Why it is not run; empty where it is."""
        return self.run.partition(";")[2].strip() if self.run.startswith("not here;") else ""


def blocks_of(page):
    lines = page.read_text().splitlines()
    whole, remarks, number = {}, {}, 0
    while number < len(lines):
        opened = FENCE.match(lines[number])
        if not opened:
            # A comment may go on over several lines.
            text = lines[number]
            while "<!--" in text and "-->" not in text:
                number += 1
                text += " " + lines[number].strip()
            for kind, words in REMARK.findall(text):
                words = BLANKS.sub(" ", words)
                if kind == "page":
                    whole["run"] = words
                else:
                    remarks[kind] = words
            if text.strip() and not REMARK.search(text):
                remarks = {}  # they belong to what comes right behind them
            number += 1
            continue
        start = number + 1
        number = next(i for i in range(start, len(lines)) if FENCE.match(lines[i]))
        text = "\n".join(line[len(opened[1]):] for line in lines[start:number]) + "\n"
        yield Block(page, start, opened[2], text, {**whole, **remarks})
        remarks = {}
        number += 1


# --- Where they run ---------------------------------------------------------------------------


def write_program(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/usr/bin/env bash\n" + text)
    path.chmod(0o755)


def furnish(folder, kerf):
    """What a reader has who works in the source tree, with replays that end early."""
    short = f"""
if [[ ${{1-}} == replay && " $* " != *" --until "* && " $* " != *" --help "* ]]; then
    set -- "$@" --until {STEPS}
fi
exec {shlex.quote(str(kerf))} "$@"
"""
    write_program(folder / "bin/kerf", short)
    write_program(folder / "build/kerf", short)
    (folder / "build/python").symlink_to(kerf.parent / "python")
    for name in ("assets", "docs"):
        (folder / name).symlink_to(ROOT / name)
    for name in ("scripts", "tests"):  # into which pages write
        (folder / name).mkdir()
        for entry in (ROOT / name).iterdir():
            (folder / name / entry.name).symlink_to(entry)
    (folder / "scripts/run").unlink()
    write_program(folder / "scripts/run", 'exec kerf "$@"\n')


class Display:
    """An X server without a screen, for all windows of a run."""

    def __init__(self):
        self.lock = threading.Lock()  # a window at a time, so that each is known for sure
        out, into = os.pipe()
        self.server = subprocess.Popen(
            # Without -noreset it starts anew when a window goes, and the next one can't open.
            ["Xvfb", "-displayfd", str(into), "-screen", "0", "1280x720x24", "-nolisten", "tcp",
             "-noreset"],
            pass_fds=[into], stderr=subprocess.DEVNULL)
        os.close(into)
        with os.fdopen(out) as said:
            self.name = ":" + said.readline().strip()

    def has_window(self, title="^Kerf"):
        found = subprocess.run(["xdotool", "search", "--name", title], capture_output=True,
                               env={**os.environ, "DISPLAY": self.name}, check=False)
        return found.returncode == 0 and found.stdout.strip() != b""

    def close(self):
        self.server.terminate()
        self.server.wait()


def shell(text, folder, environment, **more):
    return subprocess.Popen(["bash", "-euo", "pipefail", "-c", text], cwd=folder, env=environment,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, **more)


def end(process):
    """Ends a block with all that it has started."""
    try:
        os.killpg(process.pid, 15)
    except ProcessLookupError:
        pass
    return process.communicate()[0]


def complaint_of_window(text, folder, environment, display):
    """Each line opens a window of its own. Returns what is wrong, or nothing."""
    for line in [line for line in joined_lines(text) if not line.startswith("export ")]:
        # Of the file that it opens; without one the start page is shown.
        title = "^Kerf - " if len(shlex.split(line)) > 1 else "^Kerf$"
        with display.lock:
            process = shell(line, folder, {**environment, "DISPLAY": display.name},
                            start_new_session=True)
            until = time.monotonic() + PATIENCE
            while process.poll() is None and time.monotonic() < until and not display.has_window(title):
                time.sleep(0.2)
            opened = process.poll() is None and display.has_window(title)
            said = end(process)
            gone = time.monotonic() + 30
            while display.has_window() and time.monotonic() < gone:
                time.sleep(0.1)
        if not opened:
            return f"no window for: {line}\n{said}"
    return ""


def complaint_of_run(block, folder, environment):
    wanted = int(block.run.split()[1]) if block.run.startswith("exit ") else 0
    process = shell(block.text, folder, environment, start_new_session=True)
    try:
        said = process.communicate(timeout=PATIENCE)[0]
    except subprocess.TimeoutExpired:
        return f"not done after {PATIENCE} s\n{end(process)}"
    if process.returncode != wanted:
        return f"exit code {process.returncode} instead of {wanted}\n{said}"
    return ""


# --- What is not run --------------------------------------------------------------------------


def joined_lines(text):
    """The commands of a block: lines that a backslash joins are one, comments are left out."""
    text = re.sub(r"\s*\\\n\s*", " ", text)
    lines = [re.sub(r"(^|\s)#.*$", "", line).strip() for line in text.splitlines()]
    return [line for line in lines if line]


def targets():
    text = "".join(path.read_text() for folder in ("", "bench", "tests", "tests/fuzz")
                   for path in (ROOT / folder).glob("CMakeLists.txt"))
    names = set(re.findall(r"add_executable\(\s*(\w+)", text))
    names |= {f"kerf_{name}_tests" for name in re.findall(r"^kerf_tests\((\w+)", text, re.M)}
    return names | {f"kerf_{path.stem}" for path in (ROOT / "bench").glob("*.cpp")}


def complaint_of_words(text, kerf):
    """Whether programs of Kerf, their verbs and options exist; nothing is run but --help."""
    for line in joined_lines(text):
        for words in re.split(r"[|;]|&&|\$\(|<\(", line):
            words = words.split()
            while words and re.match(r"[A-Z_]+=|exec$", words[0]):
                words.pop(0)
            if not words:
                continue
            program = words[0].strip('"')
            if program.startswith("scripts/") and not os.access(ROOT / program, os.X_OK):
                return f"there is no {program}"
            if program.startswith("build/kerf_") and program[len("build/"):] not in targets():
                return f"nothing builds {program}"
            if program in ("kerf", "build/kerf", "${KERF:-kerf}") and len(words) > 1:
                told = subprocess.run([kerf, words[1], "--help"], capture_output=True, text=True,
                                      check=False)
                if told.returncode != 0:
                    return f"kerf {words[1]} --help: {told.stderr}"
                for option in re.findall(r"(?<!\S)--[a-z-]+", " ".join(words[2:])):
                    if option not in told.stdout:
                        return f"kerf {words[1]} has no {option}"
    return ""


# --- All of it --------------------------------------------------------------------------------


def check_page(page, kerf, display):
    """Lines about the blocks of a page, and how many failed."""
    told, failed = [], 0
    blocks = [block for block in blocks_of(page) if block.language == "sh" or block.file]
    if not blocks:
        return told, failed
    folder = pathlib.Path(tempfile.mkdtemp(prefix="kerf-page-"))
    furnish(folder, kerf)
    environment = {**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}", "LC_ALL": "C",
                   "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / ".config"),
                   "XDG_STATE_HOME": str(folder / ".state"), "LIBGL_ALWAYS_SOFTWARE": "1",
                   "KERF_EXAMINES_DRIVER": "no"}
    environment.pop("DISPLAY", None)
    environment.pop("WAYLAND_DISPLAY", None)
    for block in blocks:
        start = time.monotonic()
        if block.file:
            path = folder / block.file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text)
            continue
        wrong = ""
        if block.before:
            first = shell(block.before, folder, environment)
            said = first.communicate()[0]
            wrong = f"before it: {said}" if first.returncode != 0 else ""
        if block.reason:
            wrong = wrong or complaint_of_words(block.text, kerf)
        elif block.run == "window":
            wrong = wrong or complaint_of_window(block.text, folder, environment, display)
        else:
            wrong = wrong or complaint_of_run(block, folder, environment)
        failed += bool(wrong)
        what = "FAILED" if wrong else "not run" if block.reason else "ran"
        more = wrong or block.reason or f"{time.monotonic() - start:.1f} s"
        told.append(f"{what:8} {block.place}: {more}")
    shutil.rmtree(folder)
    return told, failed


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    kerf = pathlib.Path(sys.argv[1]).resolve()
    pages = [pathlib.Path(name).resolve() for name in sys.argv[2:]] or [
        ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    display = Display()
    failed = 0
    try:
        with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
            for told, wrong in pool.map(lambda page: check_page(page, kerf, display), pages):
                print("\n".join(told), flush=True) if told else None
                failed += wrong
    finally:
        display.close()
    print(f"{failed} failed" if failed else "all hold")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
