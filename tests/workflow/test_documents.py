"""The documents: links lead somewhere, files that are named exist."""

import re
from pathlib import Path

import pytest

import gearwear

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [
    *sorted(ROOT.glob("*.md")),
    ROOT / "config" / "README.md",
    *sorted(path for path in (ROOT / "docs").rglob("*.md") if not {"generated", "_build"} & set(path.parts)),
]
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


@pytest.mark.parametrize("name", ["CHANGELOG.md", "CITATION.cff", "codemeta.json"])
def test_the_version_is_that_of_the_package(name):
    versions = re.findall(r"^(?:## \[|version: |  \"version\": \")([\d.]+)", (ROOT / name).read_text(), re.MULTILINE)
    assert versions[0] == gearwear.__version__
