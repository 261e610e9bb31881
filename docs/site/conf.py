# How Sphinx makes the site of the pages; scripts/docs gathers them beside this file first.
project = "Kerf"
author = "Kerf"
copyright = "Kerf"  # no licence is chosen yet
html_title = "Kerf"

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4  # the anchors of headings that links of the pages name
source_suffix = {".md": "markdown"}
exclude_patterns = ["site"]
highlight_language = "none"  # of a block without a language

html_theme = "furo"  # dark, light, or as the system has it
html_static_path = ["_static"]
html_css_files = ["katex/katex.min.css", "kerf.css"]
html_js_files = [(name, {"defer": "defer"})
                 for name in ("katex/contrib/auto-render.js", "math.js", "theme.js")]
html_show_sphinx = False
html_copy_source = False
# The extension marks what is a formula, and KaTeX draws it: it is in Debian and needs no network.
mathjax_path = "katex/katex.min.js"
mathjax_options = {"defer": "defer"}


def setup(app):
    """Leaves out furo's own script, which no browser runs as it is: theme.js says why."""
    def without_furo(app, name, template, context, doctree):
        context["script_files"] = [script for script in context["script_files"]
                                   if "furo.js" not in str(script)]
    app.connect("html-page-context", without_furo, priority=900)
