"""Settings of the documentation site: `python -m sphinx -W -b html docs docs/_build/html`.

Here the tables of the reference pages are made from the program, below docs/reference/generated (not committed).
"""

import importlib.util
import pkgutil
import re
import shutil
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
ROOT = DOCS.parent
sys.path.insert(0, str(ROOT / "src"))  # before the imports below: the pages describe this checkout

import yaml  # noqa: E402

import gearwear  # noqa: E402
from gearwear.config.check import check  # noqa: E402
from gearwear.config.documents import table_text  # noqa: E402
from gearwear.config.slices import STAGES  # noqa: E402
from gearwear.io import data_dictionary  # noqa: E402
from gearwear.run import help as targets  # noqa: E402

project = "gearwear"
author = "the gearwear authors"
project_copyright = author
release = version = gearwear.__version__

extensions = ["sphinx.ext.autodoc", "sphinx.ext.autosummary", "numpydoc", "myst_parser"]
exclude_patterns = [
    "_build",
    "_templates",
    *(f"reference/generated/{name}.md" for name in ("configuration", "data", "targets")),
]
templates_path = ["_templates"]
html_theme = "furo"
html_title = f"gearwear {release}"
html_show_copyright = False
highlight_language = "none"

nitpicky = True
# Types of other packages; the site is built without a network, so their own pages are not looked up.
nitpick_ignore_regex = [(r"py:.*", r"(?!gearwear\.).*")]

myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 3

autosummary_generate = True
autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_typehints = "none"
numpydoc_show_class_members = False

PUBLIC = ["gearwear", "gearwear.compare", "gearwear.errors"]
PUBLIC_PACKAGES = ["geometry", "contact", "heat", "mesh", "wear", "oscillator", "integrate", "motions", "orbits"]


def public_modules(package: str) -> list[str]:
    """Return the package, if it documents names of its own, and its modules; packages below it hold kernels."""
    root = importlib.import_module(package)
    own = [package] if getattr(root, "__all__", ()) else []
    return own + [f"{package}.{module.name}" for module in pkgutil.iter_modules(root.__path__) if not module.ispkg]


def exists(module: str) -> bool:
    return importlib.util.find_spec(module) is not None


def api_page() -> str:
    """Return the index of the public modules; autosummary makes a page of each."""
    sections = {"Main modules": [module for module in PUBLIC if exists(module)]}
    sections |= {name.capitalize(): public_modules(f"gearwear.{name}") for name in PUBLIC_PACKAGES}
    page = ["# Public API", ""]
    for title, modules in sections.items():
        package = importlib.import_module(f"gearwear.{title.lower()}") if title != "Main modules" else None
        page += [f"## {title}", "", *([package.__doc__, ""] if package else [])]
        page += ["```{eval-rst}", ".. autosummary::", "   :toctree: api", ""]
        page += [f"   {module}" for module in modules] + ["```", ""]
    return "\n".join(page)


def configuration_page() -> str:
    values = yaml.safe_load((ROOT / "config" / "config.yaml").read_text(encoding="utf-8"))
    return table_text(check(values), STAGES)


def targets_page() -> str:
    snakefile = ROOT / "workflow" / "Snakefile"
    return f"```text\n{targets.page(snakefile)}```\n"


def write_generated() -> None:
    folder = DOCS / "reference" / "generated"
    shutil.rmtree(folder, ignore_errors=True)  # with the pages of modules that are gone
    folder.mkdir(parents=True)
    pages = {
        "api": api_page(),
        "configuration": configuration_page(),
        "data": data_dictionary.text(),
        "targets": targets_page(),
    }
    for name, text in pages.items():
        (folder / f"{name}.md").write_text(text, encoding="utf-8")


def literal_signs(app, what, name, obj, options, lines: list[str]) -> None:
    """Show signs such as |x| and (*points, 2) of a docstring as they are, and the fields of a named tuple as a list."""
    if isinstance(obj, type) and issubclass(obj, tuple) and "Attributes" not in lines:
        fields = [number for number, line in enumerate(lines) if re.match(r"[a-z_0-9]+(, [a-z_0-9.]+)* : ", line)]
        if fields:
            lines[fields[0] : fields[0]] = ["Attributes", "----------"]
    lines[:] = [re.sub(r"(?<!\*)\*(?!\*)|\|", r"\\\g<0>", line) for line in lines]
    lines[:] = [re.sub(r"^( *)(\w\.)$", r"\1\\\2", line) for line in lines]  # "m." is a unit, no item of a list


def skip_aliases(app, what, name, obj, skip, options) -> bool | None:
    """Leave out the fields of named tuples, which the docstring of the class describes."""
    alias = (getattr(obj, "__doc__", None) or "").startswith("Alias for field number")
    return True if alias or name == "__version__" else None


def setup(app) -> None:
    app.connect("autodoc-process-docstring", literal_signs, priority=100)  # before numpydoc
    app.connect("autodoc-skip-member", skip_aliases)


write_generated()
