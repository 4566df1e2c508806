"""The documents: links lead somewhere, files that are named exist, words are spelled as in Britain."""

import re
import subprocess
import sys
from pathlib import Path

import codespell_lib
import pytest

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / name for name in ("README.md", "SECURITY.md", "config/README.md")] + sorted(
    path for path in (ROOT / "docs").rglob("*.md") if not {"generated", "_build"} & set(path.parts)
)
PROSE = ("README.md", "SECURITY.md", "docs", "config", "examples", "workflow/report", "run")
TERMS = "tests/workflow/field_terms.txt"  # of gears and oscillators, as they are misspelled
ALSO_BRITISH = "program,math,optimize"  # of a computer; of journals and libraries
FOLDERS = {"workflow", "config", "docs", "tests", "profiles", "examples", "benchmarks", ".ci"}


def prose(text):
    """Return a document without its blocks of code."""
    return re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)


def anchors(text):
    """Return the anchors of the headings of a document, as its readers make them."""
    found = []
    for heading in re.findall(r"^#{1,6} +(.+?) *$", prose(text), flags=re.MULTILINE):
        anchor = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found.append(anchor + (f"-{found.count(anchor)}" if anchor in found else ""))
    return found


def links(text):
    return re.findall(r"\]\(([^)\s]+)\)", prose(text))


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda file: file.relative_to(ROOT).as_posix())
def test_every_link_leads_somewhere(document):
    for link in links(document.read_text(encoding="utf-8")):
        if re.match(r"(https?|mailto|doi):", link):
            continue
        name, _, anchor = link.partition("#")
        file = (document.parent / name).resolve() if name else document
        assert file.exists(), link
        assert file.is_relative_to(ROOT), link
        assert not anchor or anchor in anchors(file.read_text(encoding="utf-8")), link


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda file: file.relative_to(ROOT).as_posix())
def test_every_file_of_the_program_that_is_named_exists(document):
    for name in re.findall(r"`([^`\s]+)`", prose(document.read_text(encoding="utf-8"))):
        path = name.partition("::")[0].rstrip("/")
        if path.split("/")[0] in FOLDERS and "/" in path and not re.search(r"[<>{}*…]", path):
            assert (ROOT / path).exists(), name


def test_anchors_are_those_of_headings():
    assert anchors("# A b\n## Two: (c), d\n```\n# not\n```\n## A b\n") == ["a-b", "two-c-d", "a-b-1"]


def misspelled(*arguments):
    run = subprocess.run([sys.executable, "-m", "codespell_lib", *arguments], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode in (0, 65) and not run.stderr, run.stderr
    return run.stdout


def test_words_and_terms_of_the_field_are_spelled():
    everything = (*PROSE, "workflow", "tests", "benchmarks", "Snakefile")
    assert not misspelled("-D", "-", "-D", TERMS, *everything)


def test_prose_is_british(tmp_path):
    """The dictionary of codespell leads from British to American words; here it is read backwards."""
    pairs = (Path(codespell_lib.__file__).parent / "data" / "dictionary_en-GB_to_en-US.txt").read_text().split()
    backwards = tmp_path / "british.txt"
    backwards.write_text(
        "".join(f"{american}->{british}\n" for british, american in (pair.split("->") for pair in pairs))
    )
    assert not misspelled("-D", str(backwards), "-L", ALSO_BRITISH, "-S", "*.j2,*.js", *PROSE)
    (tmp_path / "text.md").write_text("The color at the center.")
    assert misspelled("-D", str(backwards), str(tmp_path)).count("==>") == 2


def test_a_misspelled_term_is_found(tmp_path):
    (tmp_path / "text.md").write_text("The hertian pressure of an involut, recieved.")
    assert misspelled("-D", "-", "-D", TERMS, str(tmp_path)).count("==>") == 3
