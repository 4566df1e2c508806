"""Kinds of configuration values, and how YAML and the command line may write them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Annotated, Any, Generic, TypeGuard, TypeVar, get_args, get_origin

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, Strict, TypeAdapter, WithJsonSchema, field_validator
from pydantic.fields import FieldInfo
from pydantic_core import PydanticCustomError

from gearwear.config import units
from gearwear.config.parameters import CASE_NAME

UNUSABLE = object()  # in place of a missing or bad value where only the others are wanted
_NUMERAL = re.compile(units.NUMERAL, re.ASCII)

Value = TypeVar("Value")


class Section(BaseModel):
    """A group of keys: all of them are required, no other is allowed."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)

    @field_validator("*", mode="wrap")
    @classmethod
    def _in_unit_of_key(cls, value: Any, validate: Any, info: Any) -> Any:
        if value is UNUSABLE:
            return value
        unit = unit_of(cls.model_fields[info.field_name]) if isinstance(value, str | list) else None
        return validate(_in_unit(value, unit) if unit else value)


class Both(Section, Generic[Value]):
    """Values of pinion and gear."""

    pinion: Value
    gear: Value


class Range(Section, Generic[Value]):
    """Range of a parameter."""

    low: Value
    high: Value


class Interval(Section, Generic[Value]):
    """First and last value."""

    first: Value
    last: Value


def _in_unit(value: Any, unit: str) -> Any:
    """Convert text with a unit, alone or in a list; a unit that does not fit becomes a UnitError."""
    if isinstance(value, str):
        try:
            return units.plain(value, unit)
        except units.UnitError as error:
            return error
    if isinstance(value, list):
        return [_in_unit(item, unit) if isinstance(item, str) else item for item in value]
    return value


def _read_number(value: Any) -> float:
    # YAML 1.1 takes 1e-8 for text, and --config hands every nested value over as text.
    if isinstance(value, units.UnitError):
        raise PydanticCustomError("unit", str(value))
    if isinstance(value, str) and _NUMERAL.fullmatch(value.strip()):
        value = value.strip()
    elif isinstance(value, bool) or not isinstance(value, int | float):
        raise PydanticCustomError("not_a_number", "not a number")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise PydanticCustomError("not_finite", "not finite")
    return number


def _read_whole(value: Any) -> int:
    try:
        number = _read_number(value)
    except PydanticCustomError as error:
        if error.type == "not_a_number":
            raise PydanticCustomError("not_whole", "not a whole number") from None
        raise
    if not number.is_integer():
        raise PydanticCustomError("not_whole", "not a whole number")
    return int(number)


def _read_flag(value: Any) -> Any:
    return {"true": True, "false": False}.get(value.lower(), value) if isinstance(value, str) else value


def _read_nullable(value: Any) -> Any:
    return None if isinstance(value, str) and value in ("null", "~") else value


def _read_off(value: Any) -> Any:
    # A bare `off` is the truth value false in YAML 1.1.
    return "off" if value is False else value


ReadNumber = BeforeValidator(_read_number)
ReadWhole = BeforeValidator(_read_whole)
Number = Annotated[float, ReadNumber]
Whole = Annotated[int, ReadWhole]
Flag = Annotated[bool, Strict(), BeforeValidator(_read_flag)]
Name = Annotated[str, Strict()]
CaseName = Annotated[str, Strict(), WithJsonSchema({"type": "string", "pattern": f"^{CASE_NAME}$"})]  # see rules.py
Names = Annotated[list[Name], Strict()]
Numbers = Annotated[list[Number], Strict()]
Nullable = Annotated[Value | None, BeforeValidator(_read_nullable)]
OrOff = BeforeValidator(_read_off)


def quantity(unit: str, meaning: str, **limits: Any) -> Any:
    """Declare a number with its unit ("1" if it has none), meaning and limits (`ge`, `gt`, `le`, `lt`)."""
    return Field(description=meaning, json_schema_extra={"unit": unit}, **limits)


def choice(meaning: str, **options: str) -> Any:
    """Declare a choice with the meaning of every option, in the order of the options in the type."""
    described = "; ".join(f"{option} = {what}" for option, what in options.items())
    return Field(description=f"{meaning}: {described}.")


def plain(meaning: str) -> Any:
    """Declare a key without unit, limits or options."""
    return Field(description=meaning)


def target(meaning: str, unit: str | None = None, **limits: Any) -> Any:
    """Declare a key that decides which files are made and never what they contain."""
    unit_or_none: dict[str, Any] = {"unit": unit} if unit else {}
    return Field(description=meaning, json_schema_extra={"decides_targets": True, **unit_or_none}, **limits)


def jobs(meaning: str, unit: str, **limits: Any) -> Any:
    """Declare a number that decides which jobs make the files and never what they contain."""
    return Field(description=meaning, json_schema_extra={"decides_jobs": True, "unit": unit}, **limits)


def table(meaning: str, entries: str, **default: Any) -> Any:
    """Declare a table whose free names are not those of cases; it decides which files are made."""
    return Field(description=meaning, json_schema_extra={"decides_targets": True, "entries": entries}, **default)


def is_section(annotation: Any) -> TypeGuard[type[Section]]:
    """Return whether a key of this type holds the keys of a model."""
    return isinstance(annotation, type) and issubclass(annotation, Section)


def entry_type(annotation: Any) -> Any:
    """Return the type of the entries of a table with free names (such as cases), else None."""
    return get_args(annotation)[1] if get_origin(annotation) is dict else None


def declared(field: FieldInfo, name: str) -> Any:
    """Return what the declaration of a key says beyond its type and meaning, None if it does not."""
    extra = field.json_schema_extra
    return extra.get(name) if isinstance(extra, dict) else None


def free_names(field: FieldInfo) -> str:
    """Return what the free names of a table denote, in the plural."""
    return declared(field, "entries") or "cases"


def unit_of(field: FieldInfo) -> str | None:
    """Return the unit of a key, None for keys that are no numbers."""
    return declared(field, "unit")


def schema_of(field: FieldInfo) -> dict[str, Any]:
    """Return the JSON schema of the value of a key, limits included; for a table, that of an entry."""
    kind: Any = entry_type(field.annotation) or Annotated[(field.annotation, *field.metadata, None)]
    return TypeAdapter(kind).json_schema()


def placeholder(field: FieldInfo) -> str:
    """Return the placeholder for any free name of a table in dotted keys."""
    return "<case>" if free_names(field) == "cases" else "<name>"


def keys(model: type[Section], path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], FieldInfo]]:
    """Yield path and declaration of every section and key of `model`; free names appear as placeholders."""
    for name, field in model.model_fields.items():
        here = (*path, name)
        yield here, field
        entry = entry_type(field.annotation)
        if is_section(field.annotation):
            yield from keys(field.annotation, here)
        elif is_section(entry):
            yield from keys(entry, (*here, placeholder(field)))
