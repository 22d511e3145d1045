"""Public names are documented and typed."""

from __future__ import annotations

import dataclasses
import inspect
import subprocess
import sys
from collections.abc import Iterator
from typing import is_typeddict

import pytest

import bouncelab as bl

NAMES = [name for name in bl.__all__ if name != "__version__"]
CLASSES = [name for name in NAMES if isinstance(getattr(bl, name), type)]

#: Codes of numpydoc: no docstring, sections out of order, and arguments and results that are not described.
FAULTS = {"GL07", "GL08", "PR01", "PR02", "PR03", "PR04", "PR06", "PR07", "PR10", "RT01", "SS01", "YD01"}
#: How their objects come about is described where they come from; their fields are attributes.
OF_CLASSES = FAULTS - {"PR01"}
NO_EXAMPLE = "EX01"


def own(name: str) -> Iterator[tuple[str, object]]:
    """Yield the public methods and properties of a class, but for fields and those that others define."""
    for member, found in vars(getattr(bl, name)).items():
        if not member.startswith("_") and (inspect.isfunction(found) or isinstance(found, property)):
            yield member, found


def faults(name: str, codes: set[str]) -> list[str]:
    validate = pytest.importorskip("numpydoc.validate").validate
    errors = validate(f"bouncelab.{name}")["errors"]
    return [f"{name}: {code} {message}" for code, message in errors if code in codes]


@pytest.mark.parametrize("name", NAMES)
def test_every_public_name_is_documented_with_an_example(name: str) -> None:
    assert faults(name, (OF_CLASSES if name in CLASSES else FAULTS) | {NO_EXAMPLE}) == []


@pytest.mark.parametrize("name", CLASSES)
def test_every_method_and_every_field_is_documented(name: str) -> None:
    assert [fault for member, _ in own(name) for fault in faults(f"{name}.{member}", FAULTS)] == []
    found = getattr(bl, name)
    if dataclasses.is_dataclass(found):
        docscrape = pytest.importorskip("numpydoc.docscrape")
        entries = docscrape.NumpyDocString(inspect.getdoc(found))["Attributes"]
        described = {field for entry in entries for field in entry.name.split(", ")}
        fields = {field.name for field in dataclasses.fields(found) if not field.name.startswith("_")}
        assert fields - described == set()
    if is_typeddict(found):
        about = inspect.getdoc(bl.analyze) or ""
        assert [field for field in found.__annotations__ if field not in about] == []


@pytest.mark.parametrize("name", NAMES)
def test_every_public_name_is_typed_without_any(name: str) -> None:
    """The types themselves are for mypy and pyright; they would let `Any` pass."""
    found = getattr(bl, name)
    members = dict(own(name)) if name in CLASSES else {name: found}
    functions = [it.fget if isinstance(it, property) else it for it in members.values()]
    types = [str(type) for type in inspect.get_annotations(found).values()]
    for function in filter(inspect.isfunction, functions):
        annotations = inspect.get_annotations(function)
        takes = set(inspect.signature(function).parameters) - {"self"}
        assert takes | {"return"} == set(annotations), function
        types += [str(type) for type in annotations.values()]
    assert [type for type in types if "Any" in type] == []


def test_importing_it_imports_nothing_but_the_standard_library() -> None:
    code = (
        "import sys; before = set(sys.modules); import bouncelab; "
        "new = {name.split('.')[0] for name in set(sys.modules) - before}; "
        "print(new - set(sys.stdlib_module_names) - {'bouncelab'})"
    )
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert shown.stdout.strip() == "set()"
