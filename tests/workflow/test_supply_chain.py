"""What is installed is pinned; the program runs nothing that it reads, and opens no connection. See SECURITY.md."""

import ast
import re
import tomllib
from itertools import chain
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SOURCES = sorted([*(ROOT / "src").rglob("*.py"), *(ROOT / "workflow").rglob("*.py")])
RULES = [ROOT / "Snakefile", ROOT / "workflow" / "Snakefile", *sorted((ROOT / "workflow").rglob("*.smk"))]
LOCKS = ("requirements.lock", "docs/requirements.lock", "profiles/slurm/requirements.lock", "examples/requirements.txt")
LOADS_CODE = {"pickle", "marshal", "shelve", "dill", "cloudpickle", "joblib", "runpy", "code", "ctypes", "cffi"}
STARTS_PROGRAMS = {"subprocess", "pty", "popen2"}
CONNECTS = {"urllib", "http", "ftplib", "smtplib", "telnetlib", "ssl", "requests", "httpx", "aiohttp", "xmlrpc"}
RUNS = {
    "eval",
    "exec",
    "compile",
    "__import__",
    "execfile",
    "system",
    "popen",
    "execv",
    "execvp",
    "spawnv",
    "import_module",
}
FUNCTIONS_OF_OTHERS = {"re.compile"}  # of patterns
# Modules of this package that are looked up in its own tables.
LOOKED_UP = ("__init__.py", "io/variables.py", "run/stage.py", "run/stages.py")
EXCEPTIONS = {f"src/gearwear/{name}": ["import_module"] for name in LOOKED_UP}
EXCEPTIONS["src/gearwear/integrate/compiled.py"] = ["pickle"]  # machine code, run anyhow, in the user's own folder
EXCEPTIONS["src/gearwear/run/orphans.py"] = ["ctypes"]  # asks the kernel to end a job with its workflow
LOADERS = {"load", "load_all", "unsafe_load", "full_load", "Loader", "UnsafeLoader", "FullLoader"}


def dotted(node):
    """Return a name such as os.system as it is written, "" for anything else."""
    if isinstance(node, ast.Attribute):
        return f"{dotted(node.value)}.{node.attr}".lstrip(".")
    return node.id if isinstance(node, ast.Name) else ""


def forbidden(source):
    """Return what a source does that could run what it reads, or reach out of the machine."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import | ast.ImportFrom):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else [node.module or ""]
            found += [name for name in names if name.split(".")[0] in LOADS_CODE | STARTS_PROGRAMS | CONNECTS]
            if names == ["socket"] and isinstance(node, ast.ImportFrom):
                found.append("from socket")
        elif isinstance(node, ast.Call):
            called = dotted(node.func)
            if called.split(".")[-1] in RUNS and called not in FUNCTIONS_OF_OTHERS:
                found.append(called)
            found += [keyword.arg for keyword in node.keywords if keyword.arg in ("allow_pickle", "shell")]
        elif isinstance(node, ast.Attribute):
            name = dotted(node)
            if name.startswith("yaml.") and node.attr in LOADERS:
                found.append(name)
            if name.startswith("socket.") and name != "socket.gethostname":
                found.append(name)
    return found


def test_no_source_runs_what_it_reads():
    found = {file.relative_to(ROOT).as_posix(): forbidden(file.read_text()) for file in SOURCES}
    assert {name: one for name, one in found.items() if one} == EXCEPTIONS


@pytest.mark.parametrize(
    "code",
    [
        "import pickle",
        "from subprocess import run",
        "eval(text)",
        "os.system(text)",
        "np.load(file, allow_pickle=True)",
        "yaml.load(text)",
        "run(text, shell=True)",
        "from urllib.request import urlopen",
        "socket.create_connection(host)",
        "importlib.import_module(name)",
    ],
)
def test_the_search_finds_what_it_is_for(code):
    assert forbidden(code)


def test_pages_escape_all_text():
    made = [
        {keyword.arg: ast.literal_eval(keyword.value) for keyword in node.keywords}
        for file in SOURCES
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and dotted(node.func).startswith("jinja2.")
    ]
    assert made and all(one["autoescape"] is True for one in made)
    templates = sorted((ROOT / "workflow" / "report").glob("*.j2"))
    unescaped = [found for file in templates for found in re.findall(r"{{[^}]*\bsafe\b[^}]*}}", file.read_text())]
    assert unescaped == ["{{ program | safe }}"]  # the JavaScript of the page
    assert not any("autoescape false" in file.read_text() for file in templates)


def test_no_rule_hands_anything_to_a_shell():
    for file in RULES:
        text = file.read_text(encoding="utf-8")
        assert not re.search(r"^\s*(shell|run|cwl|wrapper|notebook)\s*:", text, flags=re.MULTILINE), file
        assert not re.search(r"\b(shell|eval|exec|pickle|subprocess|os\.system)\s*\(", text), file


@pytest.mark.parametrize("name", LOCKS)
def test_everything_in_a_lock_is_pinned_by_hash_and_names_no_host(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    assert "://" not in text
    entries = [entry for entry in re.split(r"(?<!\\)\n", text) if entry and not entry.startswith("#")]
    assert len(entries) > 1
    for entry in entries:
        assert re.match(r"[\w.-]+(\[[\w,-]+\])?==[\w.!+]+ ", entry), entry
        assert re.search(r"--hash=sha256:[0-9a-f]{64}\b", entry), entry


def test_the_lock_holds_what_is_asked_for():
    asked = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    extras = asked["project"]["optional-dependencies"]
    for lock, lists in {
        "requirements.lock": [asked["project"]["dependencies"], asked["dependency-groups"]["build"]]
        + [extras[name] for name in ("workflow", "test", "lint")],
        "docs/requirements.lock": [asked["project"]["dependencies"], extras["docs"]],
    }.items():
        names = {re.split(r"[<>=!~ \[]", one)[0].lower() for one in chain(*lists)}
        locked = set(re.findall(r"^([\w.-]+)==", (ROOT / lock).read_text(encoding="utf-8"), flags=re.MULTILINE))
        assert names <= locked


@pytest.mark.parametrize("name", ["run", "Containerfile", "docs/how-to/cluster.md"])
def test_what_is_installed_is_checked_against_its_hash(name):
    """All but the package itself, built from the checkout without a connection, and the tool that writes the locks."""
    text = (ROOT / name).read_text(encoding="utf-8")
    installs = [line for line in text.splitlines() if re.match(r"\s*(RUN )?(\S*pip )?install ", line)]
    others = [line for line in installs if not re.search(r"install uv$|--no-deps --no-build-isolation", line)]
    assert others
    assert all("--require-hashes" in line for line in others)
