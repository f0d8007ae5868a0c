"""Sphinx: the documentation site, built by tools/site from the sources that stage.py prepares. Nothing comes from the network."""

import sys
from pathlib import Path

import orbearing

sys.path.insert(0, str(Path(__file__).resolve().parent))  # extensions beside this file

project = "Orbearing"
author = "the authors of Orbearing"
copyright = author
version = release = orbearing.__version__

extensions = ["myst_parser", "sphinx.ext.autodoc", "links_to_documents", "plain_docstrings"]
root_doc = "docs/index"
source_suffix = {".md": "markdown"}
default_role = "code"
highlight_language = "none"  # indented blocks are equations, sketches and outputs
myst_heading_anchors = 3
suppress_warnings = ["myst.header"]  # READMEs have a title and sections of whatever level suits GitHub

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
python_use_unqualified_type_names = True
autodoc_default_options = {"members": True}
# Types of other libraries and of the standard one have no pages here, nor has the part that calls the program; ours are known by the shorter names.
nitpick_ignore_regex = [("py:.*", r"(?!orbearing\.).*"), ("py:.*", r"orbearing\.(_core|case|results|machine|studies|uncertainties|opened_page|table)\..*")]

html_theme = "alabaster"
html_title = "Orbearing"
html_short_title = "Orbearing"
html_static_path = ["static"]
html_css_files = ["orbearing.css"]
html_js_files = ["key_filter.js", "version_switcher.js"]
html_additional_pages = {"index": "to_first_page.html"}
templates_path = ["templates"]
html_sidebars = {"**": ["about.html", "versions.html", "searchbox.html", "navigation.html", "relations.html"]}
html_theme_options = {
    "description": "Planet bearings inside planetary drivetrains: loads, motion, life",
    "fixed_sidebar": True, "page_width": "min(98vw, 1500px)", "sidebar_width": "250px", "show_powered_by": False, "sidebar_collapse": True,
    "show_relbars": False,
}
html_show_sourcelink = False
html_copy_source = False
