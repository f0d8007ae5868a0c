"""REXS files in, in all three forms: XML (.rexs), JSON (.rexsj) and ZIP (.rexsz)."""

from __future__ import annotations

import base64
import io
import json
import re
import shutil
import struct
import xml.etree.ElementTree as ElementTree
import xml.parsers.expat as expat
import zipfile
from pathlib import Path
from typing import Any, Iterable

from orbearing.errors import CaseError
from orbearing.rexs.model import Attribute, Component, LoadCase, Model, Relation

REQUIRED = "a REXS file is required: XML (.rexs), JSON (.rexsj) or ZIP (.rexsz), version 1.0 to 2.0"
NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
IDENTITY = re.compile(r"\s*[0-9]{1,18}\s*")
# Strings, brackets and nothing else of a JSON text.
JSON_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[\[\]{}]', re.S)
HALF_PAIR = re.compile("[\ud800-\udfff]")
LARGEST_BYTES = 512 * 1024 * 1024  # of a model in a ZIP file, and of all that stands beside it where that is packed again
DEEPEST = 100  # elements or brackets within each other; a model has ten
CODES = {"int32": "i", "float32": "f", "float64": "d"}
NEWEST_MAJOR = 2
LISTS = ("support_vector", "u_axis_vector", "w_axis_vector", "is_engaged")  # attributes with several values
MODEL_NAMES = (".rexs", ".rexs.xml", ".rexsj", ".rexs.json")


class _Fault(Exception):
    """What is wrong inside the file, with its line and column where they are known; `identity`: the id that is none."""

    def __init__(self, text: str, line: int = 1, column: int = 1, identity: Any = ...):
        super().__init__(text)
        self.line, self.column, self.identity = line, column, identity


def form_of(content: bytes) -> str:
    """zip, xml or json, by the first characters; xml where it is none of them."""
    if content.startswith(b"PK"):
        return "zip"
    return "json" if content.removeprefix(b"\xef\xbb\xbf").lstrip()[:1] == b"{" else "xml"


def model_name(archive: zipfile.ZipFile) -> str:
    """The model's file in a ZIP archive."""
    names = [name for name in archive.namelist() if name.lower().endswith(MODEL_NAMES)]
    if len(names) != 1:
        held = ", ".join(archive.namelist()[:5]) or "nothing"
        raise _Fault(f"found a ZIP file with {len(names)} REXS models ({held}); one is required")
    return names[0]


def unpacked(content: bytes) -> tuple[bytes, str]:
    """The model's own bytes and, of a ZIP file, the name of the model in it."""
    if form_of(content) != "zip":
        return content, ""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            name = model_name(archive)
            if archive.getinfo(name).file_size > LARGEST_BYTES:
                raise _Fault(f"found a model of more than {LARGEST_BYTES // 1024 ** 2} MB in a ZIP file; a smaller one is required")
            return archive.read(name), name
    except (_Fault, MemoryError):
        raise
    except Exception as error:  # each reader of a compression has errors of its own
        raise _Fault(f"found a ZIP file that cannot be read ({error}); {REQUIRED}") from error


def packed(file: Path, content: bytes, member: str, model: bytes) -> bytes:
    """The archive with another model; the others, as large as LARGEST_BYTES together, are copied piece by piece."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as new:
        others = [info for info in old.infolist() if info.filename != member]
        if sum(info.file_size for info in others) > LARGEST_BYTES:
            raise CaseError(f"{file}:1:1: found {sum(info.file_size for info in others) / 1024 ** 2:.0f} MB beside the model in a ZIP file; at most "
                            f"{LARGEST_BYTES // 1024 ** 2} MB are packed again: take the model '{member}' out of the archive and convert that")
        for info in old.infolist():
            kept = zipfile.ZipInfo(info.filename, info.date_time)
            kept.compress_type, kept.external_attr, kept.comment = zipfile.ZIP_DEFLATED, info.external_attr, info.comment
            with new.open(kept, "w") as target:
                if info.filename == member:
                    target.write(model)
                else:
                    _copy(file, old, info, target)
    return out.getvalue()


def _copy(file: Path, archive: zipfile.ZipFile, info: zipfile.ZipInfo, target: Any) -> None:
    try:
        with archive.open(info) as source:
            shutil.copyfileobj(source, target)
    except Exception as error:
        raise CaseError(f"{file}:1:1: found '{info.filename}' beside the model in a ZIP file, which cannot be read ({error}); take the model out of the "
                        "archive and convert that") from error


def read_bytes(file: Path) -> bytes:
    """The file's content. Raises CaseError where it cannot be read."""
    try:
        return file.read_bytes()
    except (OSError, ValueError) as error:
        raise CaseError(f"{file}:1:1: cannot be opened ({getattr(error, 'strerror', None) or error}); {REQUIRED}") from error


def read(file: Path, content: bytes | None = None) -> Model:
    """The model of a file. Raises CaseError with line and column."""
    content = read_bytes(file) if content is None else content
    try:
        inner, _ = unpacked(content)
        return _from_json(inner) if form_of(inner) == "json" else _from_xml(inner)
    except _Fault as fault:
        raise CaseError(f"{file}:{fault.line}:{fault.column}: {fault}") from fault


def decoded(text: str, code: str) -> list[float]:
    """Numbers of a base64 text, little-endian. Raises ValueError."""
    if code not in CODES:
        raise ValueError(f"code '{code}'; one of {', '.join(CODES)} is required")
    content = base64.b64decode("".join(text.split()), validate=True)
    count, rest = divmod(len(content), struct.calcsize(CODES[code]))
    if rest:
        raise ValueError(f"{len(content)} bytes of {code}; whole numbers of them are required")
    return list(struct.unpack(f"<{count}{CODES[code]}", content))


def _matrix(values: list, rows: int, columns: int) -> list[list]:
    """A matrix that is stored column by column."""
    if rows * columns != len(values):
        raise ValueError(f"{len(values)} numbers; {rows} x {columns} are required")
    return [[values[column * rows + row] for column in range(columns)] for row in range(rows)]


def scalar(text: str) -> Any:
    """The value of an XML text; a decimal comma makes it a text, not a number."""
    text = text.strip()
    if not text:
        return None
    if text in ("true", "false"):
        return text == "true"
    if NUMBER.fullmatch(text):
        return int(text) if re.fullmatch(r"[-+]?[0-9]+", text) else float(text)
    return text


def local(element: ElementTree.Element) -> str:
    """The element's name without its namespace."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def _xml_value(element: ElementTree.Element) -> Any:
    """Value of an attribute element: scalar, array or matrix, plain or coded."""
    inner = [child for child in element if local(child) in ("array", "matrix", "array_of_arrays")]
    if not inner:
        return scalar("".join(element.itertext()))
    return _xml_list(inner[0])


def _xml_list(element: ElementTree.Element) -> list:
    code = element.get("code")
    if code:
        values = decoded(element.text or "", code)
        return values if local(element) == "array" else _matrix(values, int(element.get("rows", "0")), int(element.get("columns", "0")))
    return [scalar("".join(child.itertext())) if local(child) == "c" else _xml_list(child) for child in element if local(child)]


def _xml_component(element: ElementTree.Element, model: Model) -> Component:
    component = Component(_identity(element.get("id")), element.get("type", ""), element.get("name", ""))
    for child in element:
        if local(child) != "attribute":
            continue
        name = child.get("id", "")
        try:
            value = _xml_value(child)
        except ValueError as error:
            model.notes.append(f"component {component.id}: {name}: found {error}; not read")
            value = None
        component.attributes[name] = Attribute(name, child.get("unit", ""), value)
    return component


def _identity(stated: Any) -> int:
    """The whole number that a component has as its id."""
    if isinstance(stated, str) and IDENTITY.fullmatch(stated):
        return int(stated)
    if isinstance(stated, (int, float)) and not isinstance(stated, bool) and 0 <= stated <= 1e18 and stated == int(stated):
        return int(stated)
    raise _Fault(f"found the id '{str(stated)[:40]}' of a component; a whole number is required", identity=stated)


class _Scan:
    """What a tree cannot say any more: refuses, with line and column, what has no place in a model or would fill the memory."""

    def __init__(self) -> None:
        self._parser = expat.ParserCreate()
        self._depth = 0
        self._parser.StartElementHandler, self._parser.EndElementHandler = self._begin, self._end
        self._parser.StartDoctypeDeclHandler = self._document_type

    def run(self, content: bytes) -> None:
        """Raises _Fault; what is no XML is left to the reader."""
        try:
            self._parser.Parse(content, True)
        except (expat.ExpatError, LookupError, ValueError):
            pass

    def _fault(self, text: str) -> _Fault:
        return _Fault(text, self._parser.CurrentLineNumber, self._parser.CurrentColumnNumber + 1)

    def _begin(self, name: str, attributes: dict[str, str]) -> None:
        self._depth += 1
        if self._depth > DEEPEST:
            raise self._fault(f"found more than {DEEPEST} elements within each other; {REQUIRED}")
        if name.rpartition(":")[2] in ("component", "ref"):
            try:
                _identity(attributes.get("id"))
            except _Fault as fault:
                raise self._fault(str(fault)) from fault

    def _end(self, _: str) -> None:
        self._depth -= 1

    def _document_type(self, *_: Any) -> None:
        raise self._fault("found a document type declaration; a REXS file has none")  # its entities can be made to fill the memory


def xml_root(content: bytes) -> ElementTree.Element:
    """The root with its comments. Raises _Fault."""
    _Scan().run(content)
    try:
        return ElementTree.fromstring(content, parser=ElementTree.XMLParser(target=ElementTree.TreeBuilder(insert_comments=True)))
    except ElementTree.ParseError as error:
        line, column = error.position
        reason = str(error).split(":")[0]
        raise _Fault(f"found what is no XML ({reason}); {REQUIRED}", line, column + 1) from error
    except (LookupError, ValueError) as error:
        raise _Fault(f"found an encoding that is not known ({error}); UTF-8 is required") from error


def _from_xml(content: bytes) -> Model:
    root = xml_root(content)
    if local(root) != "model":
        raise _Fault(f"found an XML file whose root is '{local(root)}'; {REQUIRED}")
    model = Model(_supported(root.get("version")), root.get("applicationId", ""))
    for block in root:
        if local(block) == "components":
            _add_all(model, (_xml_component(one, model) for one in block if local(one) == "component"))
        elif local(block) == "relations":
            model.relations += [_xml_relation(one) for one in block if local(one) == "relation"]
        elif local(block) == "load_spectrum":
            _xml_spectrum(block, model)
    return _sound(model)


def _xml_relation(element: ElementTree.Element) -> Relation:
    refs = tuple((ref.get("role", ""), _identity(ref.get("id"))) for ref in element if local(ref) == "ref")
    return Relation(element.get("id", ""), element.get("type", ""), refs)


def _xml_spectrum(block: ElementTree.Element, model: Model) -> None:
    for one in block:
        parts = [_xml_component(part, model) for part in one if local(part) == "component"]
        if local(one) == "load_case":
            model.load_cases.append(LoadCase(one.get("id", str(len(model.load_cases) + 1)), parts))
        elif local(one) == "accumulation":
            model.accumulation += parts


def _scan_json(text: str) -> None:
    """As _Scan, of a JSON text. Raises _Fault."""
    depth = 0
    for token in JSON_TOKEN.finditer(text):
        if token[0] in "[{":
            depth += 1
            if depth > DEEPEST:
                raise _Fault(f"found more than {DEEPEST} brackets within each other; {REQUIRED}", *_line_and_column(text, token.start()))
        elif token[0] in "]}":
            depth -= 1
        elif "\\u" in token[0] and _is_half(token[0]):
            raise _Fault("found half of a pair of UTF-16 in a text; a whole character is required", *_line_and_column(text, token.start()))


def _is_half(token: str) -> bool:
    try:
        return HALF_PAIR.search(json.loads(token)) is not None
    except ValueError:
        return False  # the reader says so


def _line_and_column(text: str, at: int) -> tuple[int, int]:
    return text.count("\n", 0, at) + 1, at - text.rfind("\n", 0, at)


def json_of(content: bytes) -> Any:
    """The content of a JSON text. Raises _Fault."""
    try:
        text = content.decode("utf-8-sig")
        _scan_json(text)
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise _Fault(f"found what is no JSON ({error.msg}); {REQUIRED}", error.lineno, error.colno) from error
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise _Fault("found a byte that is not UTF-8; a text file in UTF-8 is required", line,
                     error.start - content.rfind(b"\n", 0, error.start)) from error
    except ValueError as error:
        raise _Fault("found a number with more digits than can be read; a shorter one is required") from error


def _from_json(content: bytes) -> Model:
    data = json_of(content)
    try:
        return _json_model(data)
    except _Fault as fault:
        place = re.search(r'"id"\s*:\s*(' + re.escape(json.dumps(fault.identity)) + ")", content.decode("utf-8-sig")) if fault.identity is not ... else None
        if place:
            fault.line, fault.column = _line_and_column(content.decode("utf-8-sig"), place.start(1))
        raise


def _json_model(data: Any) -> Model:
    root = data.get("model") if isinstance(data, dict) else None
    if not isinstance(root, dict):
        raise _Fault(f"found a JSON file without 'model'; {REQUIRED}")
    model = Model(_supported(root.get("version")), str(root.get("applicationId", "")))
    _add_all(model, (_json_component(one, model) for one in _objects(root.get("components"))))
    model.relations += [_json_relation(one) for one in _objects(root.get("relations"))]
    spectrum = root.get("load_spectrum") if isinstance(root.get("load_spectrum"), dict) else {}
    for one in _objects(spectrum.get("load_cases")):
        model.load_cases.append(LoadCase(str(one.get("id")), [_json_component(part, model) for part in _objects(one.get("components"))]))
    for holder in (spectrum, root):
        accumulation = holder.get("accumulation")
        if isinstance(accumulation, dict):
            model.accumulation += [_json_component(part, model) for part in _objects(accumulation.get("components"))]
    return _sound(model)


def _objects(value: Any) -> list[dict]:
    return [one for one in value if isinstance(one, dict)] if isinstance(value, list) else []


def _json_component(data: dict, model: Model) -> Component:
    component = Component(_identity(data.get("id")), str(data.get("type") or ""), str(data.get("name") or ""))
    for attribute in _objects(data.get("attributes")):
        name = str(attribute.get("id", ""))
        kind = next((key for key in attribute if key not in ("id", "unit")), "")
        try:
            value = _json_value(kind, attribute.get(kind))
        except (ValueError, TypeError, AttributeError, KeyError) as error:
            model.notes.append(f"component {component.id}: {name}: found {error}; not read")
            value = None
        component.attributes[name] = Attribute(name, str(attribute.get("unit") or ""), value)
    return component


def _json_value(kind: str, value: Any) -> Any:
    if not kind.endswith("_coded"):
        return value
    values = decoded(value["value"], value["code"])
    return _matrix(values, value["rows"], value["columns"]) if "matrix" in kind else values


def _json_relation(data: dict) -> Relation:
    refs = tuple((str(ref.get("role", "")), _identity(ref.get("id"))) for ref in _objects(data.get("refs")))
    return Relation(str(data.get("id", "")), str(data.get("type", "")), refs)


def _supported(version: Any) -> str:
    match = re.fullmatch(r"([0-9]{1,3})\.([0-9]{1,3})(\.[0-9]{1,3})*", str(version or ""))
    if not match:
        raise _Fault(f"found a model without a version{f' (it states {str(version)[:20]!r})' if version else ''}; {REQUIRED}")
    if not 1 <= int(match[1]) <= NEWEST_MAJOR:
        raise _Fault(f"found REXS {version}; {REQUIRED}")
    return str(version)


def _add_all(model: Model, components: Iterable[Component]) -> None:
    for component in components:
        if component.id in model.components:
            raise _Fault(f"found two components with the id {component.id}; each id once is required")
        model.components[component.id] = component


def _sound(model: Model) -> Model:
    """Notes what points nowhere, and lists that are none."""
    for name in LISTS:
        wrong = [one.id for one in model.components.values()
                 if name in one.attributes and one.attributes[name].value is not None and not isinstance(one.attributes[name].value, list)]
        if wrong:
            model.notes.append(f"{name} of {len(wrong)} components ({', '.join(map(str, wrong[:5]))}{', ...' if len(wrong) > 5 else ''}): found a single "
                               "value; a list is required; not used")
    for relation in model.relations:
        for role, component in relation.refs:
            if component not in model.components:
                model.notes.append(f"relation {relation.id} ({relation.type}): {role}: component {component} is not in the file; not used")
    for load_case in model.load_cases:
        for part in load_case.components:
            if part.id not in model.components:
                model.notes.append(f"load case {load_case.id}: component {part.id} is not in the file; not used")
    return model
