"""How Sphinx makes the site of the documentation: ``make docs`` (tools/site.py) gives it the pages."""

project = "Hoistway"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "index"
nitpicky = True
highlight_language = "text"
myst_heading_anchors = 4
"""Deepest headings that links may lead to, as on GitHub."""
html_theme = "furo"
html_title = "Hoistway"
html_copy_source = False
html_show_sphinx = False
html_show_search_summary = False
"""Summaries would be fetched, which a browser does not do from the disk."""
html_show_copyright = False
html_theme_options = {"navigation_with_keys": True}
"""Furo brings its own styles and scripts, and uses the system's fonts: nothing is asked of another host."""
