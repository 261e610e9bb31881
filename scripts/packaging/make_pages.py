#!/usr/bin/env python3
"""Makes the manual page and the completion for bash of what `kerf --help` says.

  make_pages.py PROGRAM FOLDER      writes FOLDER/kerf.1.gz and FOLDER/kerf.bash
"""
import dataclasses
import gzip
import pathlib
import re
import subprocess
import sys

HEADINGS = ("Positionals:", "Options:", "Subcommands:")
ELSEWHERE = "experiment"  # run by kerf-lab, which is not installed: what `kerf --help` says is all


@dataclasses.dataclass
class Help:
    """What --help says of the program, or of a verb."""
    about: str
    usage: str
    rows: dict  # by heading, of pairs: what is typed, and what it does
    rest: list  # lines behind


def said(program, *words):
    return subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout


def read_help(program, *verb):
    lines = said(program, *verb, "--help").splitlines()
    usage = next(i for i, line in enumerate(lines) if line.startswith("Usage: "))
    help_text = Help(" ".join(lines[:usage]).strip(), lines[usage][len("Usage: "):], {}, [])
    rows = None
    for line in lines[usage + 1:]:
        if line in HEADINGS:
            rows = help_text.rows.setdefault(line, [])
        elif line.startswith("   ") and rows:
            rows[-1] = (rows[-1][0], f"{rows[-1][1]} {line.strip()}".strip())
        elif line.startswith("  ") and rows is not None:
            # What does not fit before its column has its meaning on the next line.
            found = re.match(r"(.{1,27}?)\s{2,}(\S.*)$|(\S.{26}) (\S.*)$|(.*)$", line[2:])
            typed = found[1] or found[3] or found[5]
            rows.append((typed.strip(), (found[2] or found[4] or "").strip()))
        elif line.strip():
            rows = None
            help_text.rest.append(line)
    return help_text


def escaped(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def option_rows(help_text):
    for heading in ("Positionals:", "Options:"):
        for typed, meaning in help_text.rows.get(heading, []):
            if not typed.startswith("-h,"):
                # Conditions of the parser are told with the meaning, in words.
                name = re.sub(r"\{false\}| REQUIRED| TEXT|:INT| ?in \[.*?\]|:[A-Z]+", "", typed)
                name = re.sub(r" (Needs|Excludes): .*", "", name)
                yield f".TP\n.B {escaped(name)}\n{escaped(meaning)}\n"


def manual(top, verbs, version):
    about = top.about.split(". ")[0].removeprefix("Kerf ")
    parts = [
        f'.TH KERF 1 "" "{version}" "User Commands"\n',
        f".SH NAME\nkerf \\- {escaped(about)}\n",
        ".SH SYNOPSIS\n.B kerf\n.RI [ FILE ]\n",
    ]
    parts += [f".br\n.B {escaped(v.usage.replace('[OPTIONS]', '[options]'))}\n"
              for v in verbs.values()]
    parts.append(f".SH DESCRIPTION\n{escaped(top.about)}\n.PP\nFILE is a model or a session.\n")
    for name, verb in verbs.items():
        parts.append(f".SH {name.upper()}\n{escaped(verb.about)}\n")
        parts.extend(option_rows(verb))
    parts.append(".SH EXIT STATUS\n" + escaped(" ".join(top.rest)) + "\n")
    return "".join(parts)


def names_of(help_text):
    typed = [row[0] for row in help_text.rows.get("Options:", [])]
    return [name for text in typed for name in re.findall(r"--[a-z-]+", re.split(
        r" (?:Needs|Excludes)", text)[0])]


def completion(top, verbs, materials):
    cases = "".join(f"        {name}) words='{' '.join(names_of(verb))}' ;;\n"
                    for name, verb in verbs.items())
    formats = next(m for t, m in verbs["replay"].rows["Options:"] if t.startswith("--meshes"))
    formats = formats.split(": ")[-1].replace(",", "")
    return f"""# Completion of kerf in bash; made of what `kerf --help` says.
_kerf() {{
    local now=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} words=
    COMPREPLY=()
    case $before in
        --material | materials) words='{' '.join(materials)}' ;;
        --meshes) words='{formats}' ;;
        schema) words='session material' ;;
    esac
    if [[ -z $words && $COMP_CWORD == 1 ]]; then
        words='{' '.join(verbs)} {' '.join(names_of(top))}'
    elif [[ -z $words && $now == -* ]]; then
        case ${{COMP_WORDS[1]}} in
{cases.replace('        ', '            ')}        esac
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$now")
}}
complete -o default -o bashdefault -F _kerf kerf
"""


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    top = read_help(program)
    verbs = {name: read_help(program, name) if name != ELSEWHERE else
             Help(about, f"kerf {name} NAME --out DIR", {}, [])
             for name, about in top.rows["Subcommands:"]}
    materials = [line.split()[0] for line in said(program, "materials").splitlines() if line]
    page = manual(top, verbs, said(program, "--version").strip())
    (folder / "kerf.1.gz").write_bytes(gzip.compress(page.encode(), 9, mtime=0))
    (folder / "kerf.bash").write_text(completion(top, verbs, materials), encoding="utf-8")


main()
