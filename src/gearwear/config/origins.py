"""Every value of a configuration with its origin: the comment in a file, the command line, a derived value."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import yaml

from gearwear.config.derived import RULES
from gearwear.config.study import leaves
from gearwear.config.types import unit_of

COLUMNS = ("key", "value", "unit", "origin", "meaning")
COMMAND_LINE = "command line"
DEFAULT = "default"
_COMMENT = re.compile(r"\s#\s*(.*?)\s*$")
_SOURCE = re.compile(r"(?:^|;\s*)((?:text|field|fit|choice)\b.*)")
_NULLS = ("null", "~", "")

Path = tuple[str, ...]


class Layer(NamedTuple):
    """A file of the configuration, or the command line: for every key it sets, whether to null, and the source."""

    name: str
    set_to_null: dict[Path, bool]
    source: dict[Path, str]


def file_layer(name: str, text: str) -> Layer:
    """Return what the YAML `text` of a file sets, with the sources in its comments.

    The comment at the end of a line belongs to all keys of the line; that of a section to the keys below it without a
    source of their own. A source begins with `text`, `field`, `fit` or `choice`, first or after a semicolon.
    """
    layer, lines = Layer(name, {}, {}), text.splitlines()
    for path, key, value in _nodes(yaml.compose(text, yaml.SafeLoader), ()):
        comment = _COMMENT.search(lines[key.start_mark.line])
        source = _SOURCE.search(comment[1]) if comment else None
        layer.source[path] = source[1] if source else layer.source.get(path[:-1], "")
        layer.set_to_null[path] = value.tag.endswith(":null")
    return layer


def command_line_layer(values: Mapping[str, Any]) -> Layer:
    """Return what `--config` sets: nested dicts, the values as text."""
    layer = Layer(COMMAND_LINE, {}, {})

    def read(section: Any, path: Any) -> Any:
        for name, value in section.items():
            layer.set_to_null[(*path, name)] = value is None or value in _NULLS
            if isinstance(value, Mapping):
                read(value, (*path, name))

    read(values, ())
    return layer


def origin(path: Path, layers: Sequence[Layer]) -> str:
    """Return where the value at `path` comes from.

    Parameters
    ----------
    layers : the default file, then the overlays, each over the ones before.

    Returns
    -------
    `derived: ` and the rule; or the name of the overlay that sets the value and its source; or the source in the
    default file, `default` where that names none.
    """
    setting = [layer for layer in layers if path in layer.set_to_null]
    rule = RULES.get(".".join(path))
    if not setting:
        return DEFAULT
    last = setting[-1]
    if rule and last.set_to_null[path]:
        return f"derived: {rule.text}"
    source = last.source.get(path, "")
    if last is layers[0]:
        return source or DEFAULT
    return f"{last.name}: {source}" if source else last.name


def rows(config: dict[str, Any], layers: Sequence[Layer]) -> Iterator[tuple[str, ...]]:
    """Yield key, value, unit ("-" for what is no number), origin and meaning, in the order of the declarations.

    Parameters
    ----------
    config : the checked configuration; layers : the files and the command line it was merged from.
    """
    for path, field in leaves():
        for names, value in _values(config, path):
            text = value if isinstance(value, str) else json.dumps(value)
            yield ".".join(names), text, unit_of(field) or "-", origin(names, layers), field.description or ""


def _nodes(node: yaml.Node | None, path: Path) -> Iterator[tuple[Path, yaml.Node, yaml.Node]]:
    """Yield path, node of the key and node of the value of every key, sections before the keys below them."""
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if key.tag.endswith(":merge"):
                for merged in value.value if isinstance(value, yaml.SequenceNode) else [value]:
                    yield from _nodes(merged, path)
                continue
            here = (*path, str(key.value))
            yield here, key, value
            yield from _nodes(value, here)


def _values(values: Any, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Yield the names and the value of every entry at `path`; a placeholder stands for all names there."""
    if not path:
        yield (), values
        return
    for name in values if path[0].startswith("<") else path[:1]:
        for rest, value in _values(values[name], path[1:]):
            yield (name, *rest), value
