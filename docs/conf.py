"""Sphinx settings for `make docs`, which builds a site from README.md and docs/.

We use Sphinx with MyST and Furo because they are maintained and read the same Markdown as GitHub. The
pages they build load nothing from the network.
"""

import shutil
from pathlib import Path

from sphinx.application import Sphinx

project = "placecat"
author = "The placecat authors"
root_doc = "README"
extensions = ["myst_parser"]
include_patterns = ["*.md", "data/README.md", "docs/*.md"]
exclude_patterns = [".*", "data/[!R]*", "outputs", "multirun", "reports", "site", "src", "tests"]
myst_heading_anchors = 3
html_theme = "furo"
html_title = "placecat"
html_show_sphinx = False
html_copy_source = False
# The pages in the sidebar.
PAGES = (
    "docs/method docs/usage docs/experiments docs/own-data docs/robots docs/cluster docs/benchmarks "
    "docs/adding docs/embedding docs/results docs/replication docs/security data/README CONTRIBUTING "
    "CHANGELOG"
)


def _add_sidebar(app: Sphinx, name: str, source: list[str]) -> None:
    if name == root_doc:
        source[0] += "\n```{toctree}\n:hidden:\n" + PAGES.replace(" ", "\n") + "\n```\n"


def _add_index(app: Sphinx, error: Exception | None) -> None:
    if error is None:
        shutil.copy(Path(app.outdir) / f"{root_doc}.html", Path(app.outdir) / "index.html")


def setup(app: Sphinx) -> None:
    """Register the functions that Sphinx calls."""
    app.connect("source-read", _add_sidebar)
    app.connect("build-finished", _add_index)
