# SPDX-License-Identifier: Apache-2.0
"""Sphinx settings. `make docs` copies this folder to build/docs/source and adds what is generated."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from pitchpoint import __version__

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "extensions"))

project = "pitchpoint"
author = "The pitchpoint developers"
copyright = author
version = release = __version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx_design",
    "mathml",
    "numpydoc_text",
]
exclude_patterns = ["_extra", "_parts", "gallery/**/README.md"]
html_extra_path = ["_extra"]
html_static_path = ["_static"]
html_css_files = ["pitchpoint.css"]

# ------------------------------------------------------------------------------------------------ pages

myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "deflist", "attrs_block", "attrs_inline"]
myst_heading_anchors = 4
myst_links_external_new_tab = False
# a paragraph may begin with a path such as /contact, and prices do not occur here
myst_dmath_allow_digits = False
myst_dmath_double_inline = True

nb_execution_mode = "force"
nb_execution_timeout = 900
nb_execution_raise_on_error = True
nb_execution_show_tb = True
nb_merge_streams = True
nb_render_image_options = {"align": "center"}

# --------------------------------------------------------------------------------------------- reference

autosummary_generate = False  # docs/make_api.py writes these pages
autodoc_typehints = "none"  # numpydoc sections state what a parameter is, with its unit
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
# annotations and attributes name classes and values without their module, which several modules may have
suppress_warnings = ["ref.python"]
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True

# ------------------------------------------------------------------------------------------------- looks

highlight_language = "none"
html_theme = "pydata_sphinx_theme"
html_title = "pitchpoint"
html_show_sourcelink = False
html_copy_source = False
html_math_renderer = "mathml"
html_theme_options = {
    "navbar_align": "left",
    "navbar_end": ["theme-switcher"],
    "show_toc_level": 2,
    "header_links_before_dropdown": 7,
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "pygments_light_style": "tango",
    "pygments_dark_style": "monokai",
}
html_sidebars = {name: [] for name in ("index", "start", "gallery/index", "validation", "changelog")}
html_context = {"default_mode": "auto"}

# notebooks call the commands of this environment
os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
# and show their results, not their progress
os.environ["TTY_INTERACTIVE"] = "0"
