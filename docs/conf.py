"""The documentation as a site: these pages, and the docstrings of every public name."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))

import hfield

project = "hfield"
author = "The hfield authors"
copyright = "The hfield authors, MIT licence"
version = release = hfield.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "reference_pages",
    "checker_page",
]
sys.path.insert(0, str(Path(__file__).parent / "extensions"))
myst_enable_extensions = ["attrs_inline", "dollarmath", "deflist"]
myst_heading_anchors = 4
exclude_patterns = ["extensions", "_build"]

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_preserve_defaults = True
python_use_unqualified_type_names = True
suppress_warnings = ["ref.python"]  # "shape" in a docstring is a word, not one of the attributes

html_theme = "furo"
html_title = f"hfield {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = ["site.js", "check.js"]
html_copy_source = False
html_show_sourcelink = False
html_theme_options = {"footer_icons": [], "top_of_page_buttons": []}
pygments_style = "a11y-high-contrast-light"
