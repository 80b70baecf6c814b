# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The words of the public headers, by Doxygen. Whatever is public and has none is an error."""
import re
import subprocess
from dataclasses import dataclass, field
from xml.etree import ElementTree

OPTIONS = """
PROJECT_NAME = Setsquare
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
JAVADOC_AUTOBRIEF = YES
EXTRACT_ALL = NO
EXTRACT_PRIVATE = NO
EXTRACT_LOCAL_CLASSES = NO
MARKDOWN_SUPPORT = YES
WARN_IF_UNDOCUMENTED = YES
WARN_AS_ERROR = FAIL_ON_WARNINGS
QUIET = YES
"""


class Undocumented(Exception):
    """Something public has no words, or Doxygen does not understand them."""


@dataclass
class Field:
    name: str
    type: str
    default: str
    words: str


@dataclass
class Struct:
    name: str
    header: str
    words: str
    fields: list[Field] = field(default_factory=list)


def public_headers(source):
    """The headers that are installed, in the order of the layers: HEADERS in setsquare/CMakeLists.txt."""
    text = (source / "setsquare/CMakeLists.txt").read_text()
    headers = []
    for layer, rest in re.findall(r"setsquare_add_layer\(\s*(\w+)([^)]*)\)", text):
        match = re.search(r"\bHEADERS\s+((?:[\w/]+\.hpp\s*)+)", rest)
        headers += [f"setsquare/{layer}/{name}" for name in (match.group(1).split() if match else ())]
    return headers + ["setsquare/setsquare.hpp"]


def run(source, headers, output):
    """Makes OUTPUT/xml. Raises Undocumented with every complaint."""
    output.mkdir(parents=True, exist_ok=True)
    complaints = output / "complaints.txt"
    options = OPTIONS + "".join(f"{name} = {value}\n" for name, value in {
        "INPUT": " ".join(f'"{source / header}"' for header in headers),
        "STRIP_FROM_PATH": f'"{source}"',
        "OUTPUT_DIRECTORY": f'"{output}"',
        "WARN_LOGFILE": f'"{complaints}"'}.items())
    ended = subprocess.run(["doxygen", "-"], input=options, text=True, capture_output=True)
    found = complaints.read_text() if complaints.exists() else ""
    if ended.returncode != 0 or found:
        raise Undocumented(found + ended.stderr)


def text_of(element):
    """The words of a description, without its markup."""
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def words_of(element):
    return " ".join(filter(None, (text_of(element.find("briefdescription")),
                                  text_of(element.find("detaileddescription")))))


def _default_of(member):
    text = text_of(member.find("initializer")).removeprefix("=").strip()
    return re.sub(r"\s+", " ", text)


def structs(output):
    """The structs and their public fields by name, in the order of the headers."""
    found = {}
    for path in sorted((output / "xml").glob("struct*.xml")):
        for compound in ElementTree.parse(path).getroot().iter("compounddef"):
            name = compound.findtext("compoundname").removeprefix("setsquare::")
            struct = Struct(name, compound.find("location").get("file"), words_of(compound))
            for member in compound.iter("memberdef"):
                if member.get("kind") == "variable" and member.get("prot") == "public" \
                        and member.get("static") == "no":
                    struct.fields.append(Field(member.findtext("name"), text_of(member.find("type")),
                                               _default_of(member), words_of(member)))
            found[name] = struct
    return found


def simplify_for_sphinx(output):
    """Takes out of the XML what Sphinx cannot show: the namespace once more in each file, and
    designated initialisers, which it does not parse."""
    for path in (output / "xml").glob("*.xml"):
        tree = ElementTree.parse(path)
        changed = False
        for parent in list(tree.getroot().iter()):
            for child in list(parent):
                if child.tag == "innernamespace" or (child.tag == "initializer" and "{." in text_of(child)):
                    parent.remove(child)
                    changed = True
        if changed:
            tree.write(path, encoding="utf-8", xml_declaration=True)
