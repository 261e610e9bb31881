"""Gathers the pages for the site, makes their films, and lets Sphinx build it: see scripts/docs.

  make_site.py KERF OUT [--draft]    the program, and the folder for all that is made

A page asks for a film by a comment, which becomes a video with a line below it:

  <!-- film: SESSION OPTIONS; WHAT IS SEEN -->

OPTIONS are those of `kerf replay --movie`. A film is made again where its session, its options or
the program have changed.
"""
import hashlib
import html
import html.parser
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KATEX = pathlib.Path("/usr/share/javascript/katex")
FILM = re.compile(r"^<!-- film: (.*?); (.*?) -->$", re.M)
SIZE = "480x360"
DRAFT = ["--until", "8"] if "--draft" in sys.argv else []  # films that are soon made


def say(words):
    print(f"kerf: {words}", file=sys.stderr, flush=True)


# --- Films ------------------------------------------------------------------------------------


def film_name(kerf, arguments):
    """Of a film and its options: another one where what it shows may have changed."""
    session = ROOT / arguments[0]
    digest = hashlib.sha256(session.read_bytes() + "\0".join(arguments).encode())
    digest.update(kerf.read_bytes())
    return f"{session.name.partition('.')[0]}-{digest.hexdigest()[:12]}"


def make_film(kerf, arguments, cache):
    """The film and a picture of its middle in the cache; returns their common name."""
    name = film_name(kerf, arguments)
    film, still = cache / f"{name}.webm", cache / f"{name}.jpg"
    if not film.exists():
        say(f"filming {' '.join(arguments)}")
        subprocess.run([kerf, "replay", ROOT / arguments[0], "--out", cache / "run", "--movie",
                        film, "--size", SIZE, "--fine", *arguments[1:]],
                       check=True, stdout=subprocess.DEVNULL)
        shutil.rmtree(cache / "run")
    if not still.exists():
        length = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of",
                                 "csv=p=0", film], check=True, capture_output=True, text=True).stdout
        middle = max(float(length) / 2 - 0.1, 0)  # a film may be one picture
        subprocess.run(["ffmpeg", "-v", "error", "-ss", str(middle), "-i", film,
                        "-frames:v", "1", still], check=True)
    return name


def with_films(text, page, kerf, cache, static):
    """The text of a page, with videos where it asks for films."""
    up = "../" * (len(page.parts) - 1)

    def video(match):
        arguments = shlex.split(match[1]) + DRAFT
        name = make_film(kerf, arguments, cache)
        for ending in ("webm", "jpg"):
            shutil.copy(cache / f"{name}.{ending}", static / "films")
        source = f"{up}_static/films/{name}"
        command = f"kerf replay {match[1]} --fine --size {SIZE} --out out --movie film.webm"
        command = re.sub(r"\s+", " ", command)
        return (f'<figure class="film"><video controls loop muted playsinline preload="none" '
                f'poster="{source}.jpg" src="{source}.webm"></video>'
                f"<figcaption>{html.escape(match[2])}: <code>{html.escape(command)}</code>"
                "</figcaption></figure>")

    return FILM.sub(video, text)


# --- The site ---------------------------------------------------------------------------------


def what_it_has():
    """That section of README.md, up to its pictures, for the first page."""
    readme = (ROOT / "README.md").read_text()
    section = re.search(r"^## What it has\n.*?(?=^!\[)", readme, re.M | re.S)
    return section[0].replace("](docs/", "](")


def gather(kerf, source, cache):
    """All pages below one folder, with what the site needs besides."""
    shutil.rmtree(source, ignore_errors=True)
    shutil.copytree(ROOT / "docs", source, ignore=shutil.ignore_patterns("figures", "__pycache__"))
    static = source / "_static"
    (static / "films").mkdir(parents=True)
    shutil.copytree(KATEX, static / "katex")
    for name in ("kerf.css", "math.js", "theme.js"):
        shutil.copy(source / "site" / name, static)
    shutil.copy(source / "site/conf.py", source)
    changes = (ROOT / "CHANGELOG.md").read_text()
    (source / "CHANGELOG.md").write_text(changes.replace("](docs/", "]("))
    index = source / "index.md"
    text = index.read_text().replace("](../CHANGELOG.md)", "](CHANGELOG.md)")
    index.write_text(text.replace("<!-- What it has: of README.md -->", what_it_has()))
    for page in sorted(source.rglob("*.md")):
        text = page.read_text()
        made = with_films(text, page.relative_to(source), kerf, cache, static)
        if made != text:
            page.write_text(made)


def build(kerf, out):
    cache = out / "films"
    cache.mkdir(parents=True, exist_ok=True)
    gather(kerf, out / "source", cache)
    notes = [f"notes/{page.stem}" for page in sorted((out / "source/notes").glob("*.md"))
             if page.stem != "README"]
    listed = "\n```{toctree}\n:hidden:\n\n" + "\n".join(note[6:] for note in notes) + "\n```\n"
    with (out / "source/notes/README.md").open("a") as page:
        page.write(listed)
    sphinx = ["sphinx-build", "-q", "-W", "--keep-going", "-b", "html"]
    if subprocess.run([*sphinx, "-d", out / "doctrees", out / "source", out / "html"],
                      check=False).returncode != 0:
        sys.exit("kerf: Sphinx found what must be mended in the pages (see above)")
    return out / "html"


# --- Links ------------------------------------------------------------------------------------


class Page(html.parser.HTMLParser):
    """The anchors of a page, and what it refers to."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src", "poster") and value:
                self.links.append(value)


def dead_links(site):
    """Links of the pages to files or anchors that are not there; other sites are not looked at."""
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    count = 0
    for path, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            count += 1
            name = urllib.parse.unquote(parts.path)
            target = pathlib.Path(os.path.normpath(path.parent / name)) if name else path
            anchor = urllib.parse.unquote(parts.fragment)
            if not target.is_file():
                yield f"{path.relative_to(site)}: {link} leads nowhere"
            elif anchor and target in pages and anchor not in pages[target].anchors:
                yield f"{path.relative_to(site)}: {link}: there is no such place"
    say(f"{count} links between {len(pages)} pages of the site")


def main():
    kerf, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    site = build(kerf, out)
    dead = list(dead_links(site))
    if dead:
        sys.exit("\n".join(dead))
    print(site / "index.html")


if __name__ == "__main__":
    main()
