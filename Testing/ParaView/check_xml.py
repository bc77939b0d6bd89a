#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the panels of the ParaView plugin against the C++ headers.

    python3 Testing/ParaView/check_xml.py [--update] [SOURCE]

For each property of the server manager XML, the class of its proxy and its command name a setter in a
header. The first paragraph of the setter's comment is the property's documentation; what follows it
there is for programmers. In that paragraph the names of enumerators and of other settings become
those of the panel, and what is said of errors is left out, since panels do not let them happen.
Defaults are those of the members, ranges those that the paragraph tells ("0 to 1", "0 or above"),
entries of enumerations are the enumerators. Every setting of the classes must be in the XML, or be
listed here with the reason why it is not. With --update, the documentation is written into the XML.
"""
import argparse
import math
import os
import re
import sys
import textwrap
import xml.etree.ElementTree as ElementTree

HEADER_FOLDERS = ("Filters", "Rendering", "Module/ParaView/Filters",
                  "Module/ParaView/Representations")
XML_FOLDERS = ("Module/ParaView/Filters", "Module/ParaView/Representations")
PROXIES = ("Proxy", "LineMapperProxy", "RepresentationProxy", "SourceProxy")

# Settings that no panel has, and why.
LEFT_OUT = {
    "vtkFourierOpacityMapper::ImportanceArrayAssociation": "comes with the array",
    "vtkFourierOpacityMapper::ImportanceArrayName": "of the representation, which has the input",
    "vtkFourierOpacityMapper::ImportanceRange": "of the representation, which has the input",
    "vtkFourierOpacityMapper::Optimization": "a proxy of its own",
    "vtkFourierOpacityMapper::Region": "set where ranks agree",
    "vtkIlluminatedLineMapper::CustomBounds": "set where ranks agree",
    "vtkIlluminatedLineMapper::Illumination": "a proxy of its own",
    "vtkIlluminatedLineMapper::SpecularPowerArrayName": "of the representation",
    "vtkIlluminatedLineMapper::TangentArrayName": "of the representation",
    "vtkIlluminatedLineMapper::UseCustomBounds": "set where ranks agree",
    "vtkLineIllumination::SpecularPower": "ParaView has one, by which vtkProperty is set",
    "vtkLineModelFilter::Controller": "the global controller",
    "vtkLineSetsRepresentation::ArrayIdNames": "of ParaView's geometry representation",
    "vtkLineSetsRepresentation::LineMapper": "a proxy of its own",
    "vtkVoxelLineMapper::CustomAttributeRange": "set where ranks agree",
    "vtkVoxelLineMapper::CustomBounds": "set where ranks agree",
    "vtkVoxelLineMapper::CustomMaximumRadius": "set where ranks agree",
    "vtkVoxelLineMapper::GlobalIllumination": "a proxy of its own",
    "vtkVoxelLineMapper::Illumination": "a proxy of its own",
    "vtkVoxelLineMapper::InputData": "the pipeline's",
    "vtkVoxelLineMapper::RadiusArrayName": "of the representation, which has the input",
    "vtkVoxelLineMapper::Region": "set where ranks agree",
    "vtkVoxelLineMapper::UseCustomBounds": "set where ranks agree",
    "vtkVoxelLineMapper::UseCustomRanges": "set where ranks agree",
}

# Commands of VTK's own classes, whose documentation stands in the XML alone.
FOREIGN_COMMANDS = ("SetInputArrayToProcess", "SetInputConnection")

NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?(?:\^\d+(?:-\d+)?)?"


class Header:
    """A class as its header tells it."""

    def __init__(self, text):
        self.text = text
        match = re.search(r"^class (?:\w+_EXPORT )?(\w+)\s*:\s*public (\w+)", text, re.MULTILINE)
        self.name, self.superclass = match.groups() if match else (None, None)

    def find_comment(self, function):
        """The comment before a setter, getter or macro that makes it, or None."""
        member = re.sub(r"^(Set|Get)", "", function)
        pattern = (r"^  (?:virtual )?[\w:<>*& ]*\b%s\(|^  vtk%s\w*Macro\(%s," %
                   (function, function[:3], member))
        match = re.search(pattern, self.text, re.MULTILINE)
        if not match:
            return None
        lines = []
        for line in reversed(self.text[:match.start()].rstrip("\n").split("\n")):
            line = line.strip()
            is_comment = line.startswith(("/**", "*", "///")) and line not in ("///@{", "///@}")
            if is_comment:
                lines.insert(0, line)
                if line.startswith("/**"):
                    break
            elif lines or line in ("", "///@{", "///@}"):
                break
            # Else the setter or the getter that the comment is told for as well.
        lines = [re.sub(r"^(/\*\*|\*/|\*|///) ?", "", line) for line in lines]
        return "\n".join(re.sub(r"\*/$", "", line).rstrip() for line in lines).strip()

    def find_brief(self):
        """The brief description as a sentence."""
        match = re.search(r"@brief\s+(.*?)\n \*\s*\n", self.text, re.DOTALL)
        brief = normalize(match.group(1).replace("\n * ", "\n"))
        return brief[0].upper() + brief[1:].rstrip(".") + "."

    def find_first_paragraph(self):
        match = re.search(r"@brief.*?\n \*\s*\n(.*?)\n \*\s*\n", self.text, re.DOTALL)
        return normalize(match.group(1).replace("\n * ", "\n")[3:])

    def find_default(self, member):
        """The values that the member begins with, as words; None where it is no member."""
        match = re.search(r"^  [\w:]+ %s(?:\[\d+\])? = ([^;]+);" % member, self.text, re.MULTILINE)
        return re.sub(r"[{},]", " ", match.group(1)).split(" ") if match else None

    def is_boolean(self, member):
        return re.search(r"^  bool %s = " % member, self.text, re.MULTILINE) is not None

    def find_enumerators(self, name):
        """Value -> name of an enumeration."""
        match = re.search(r"enum %s\s*\{(.*?)\};" % name, self.text, re.DOTALL)
        if not match:
            return {}
        return {int(value): key for key, value in
                re.findall(r"\b(\w+) = (\d+)", match.group(1))}

    def list_settings(self):
        """Names of what can be set from outside."""
        public = self.text.split("\nprotected:")[0]
        names = re.findall(r"^  (?:virtual )?void Set(\w+)\(", public, re.MULTILINE)
        names += re.findall(r"vtkSet(?:Vector\d)?Macro\((\w+),", public)
        return {name for name in names if not re.match(r"\w+To[A-Z]", name)}


class Headers:
    """All classes by name."""

    def __init__(self, source):
        self.classes = {}
        for folder in HEADER_FOLDERS:
            for name in sorted(os.listdir(os.path.join(source, folder))):
                if name.endswith(".h"):
                    with open(os.path.join(source, folder, name), encoding="utf-8") as file:
                        header = Header(file.read())
                    self.classes[header.name] = header

    def lineage(self, name):
        """The class and those of the project that it derives from."""
        while name in self.classes:
            yield self.classes[name]
            name = self.classes[name].superclass


class Property:
    """A property of a proxy, and what the headers say of it."""

    def __init__(self, element, proxy_class):
        self.element = element
        self.proxy_class = proxy_class
        self.name = element.get("name")
        self.command = element.get("command")
        self.member = re.sub(r"^(Set|Get)", "", self.command)
        self.label = element.get("label") or split_words(self.name)
        self.entries = {int(entry.get("value")): entry.get("text")
                        for entry in element.iterfind("EnumerationDomain/Entry")}

    @property
    def place(self):
        return "%s (%s::%s)" % (self.name, self.proxy_class, self.command)

    @property
    def documentation(self):
        return normalize(self.element.findtext("Documentation") or "")


def normalize(text):
    """Doxygen's markup and line ends do not matter."""
    return re.sub(r"\s+", " ", re.sub(r"</?\w>|`|\\", "", text)).strip()


def split_words(name):
    """As ParaView makes labels of names."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def to_number(text):
    """A number as headers and comments write it: 1e-4, 2^24-1, 1.0 / 4096.0."""
    power = re.fullmatch(r"(\d+)\^(\d+)(-\d+)?", text)
    if power:
        return float(int(power.group(1)) ** int(power.group(2)) + int(power.group(3) or 0))
    numerator, *denominator = text.split("/")
    return float(numerator) / (float(denominator[0]) if denominator else 1.0)


def read_properties(source, errors):
    """Path -> properties, and the proxies of filters."""
    files = {}
    filters = []
    for folder in XML_FOLDERS:
        for name in sorted(os.listdir(os.path.join(source, folder))):
            if not name.endswith(".xml"):
                continue
            path = os.path.join(source, folder, name)
            files[path] = []
            for proxy in (e for e in ElementTree.parse(path).iter() if e.tag in PROXIES):
                proxy_class = proxy.get("class")
                if proxy.tag == "SourceProxy":
                    filters.append((path, proxy))
                for element in proxy if proxy_class else ():
                    is_property = element.tag.endswith("Property")
                    if not is_property or element.get("command") in FOREIGN_COMMANDS:
                        continue
                    if not element.get("command"):
                        errors.append("%s: %s has no command" % (path, element.get("name")))
                        continue
                    files[path].append(Property(element, proxy_class))
    return files, filters


def find_entries(prop, headers):
    """Name of enumerator -> text in the panel; empty where it is no enumeration of C++."""
    # Shadows is a ShadowType, EngineInUse an EngineType.
    name = re.sub(r"s?(InUse)?$", "Type", prop.member, count=1)
    for header in headers.lineage(prop.proxy_class):
        enumerators = header.find_enumerators(name)
        if enumerators:
            return {key: prop.entries.get(value) for value, key in enumerators.items()}
    return {}


def to_panel(comment, entries, labels):
    """The text that a panel shows for a comment."""
    text = normalize(re.split(r"\n\s*\n", comment)[0])
    text = re.sub(r" \(\w+Type\)", "", text)
    text = re.sub(r"\(\w+Type; ", "(", text)
    # Sentences about errors.
    text = re.sub(r"(?:(?<=\. )|^)[^.]*\b(?:is an error|are errors)\b[^.]*\.", "", text)
    for enumerator, entry in entries.items():
        if entry:
            text = re.sub(r"\b%s\b" % enumerator, lambda _, entry=entry: entry, text)
    for member, label in labels.items():
        if re.search(r"[a-z][A-Z]", member):
            text = re.sub(r"\b%s\b" % member, lambda _, label=label: label, text)
    return normalize(text)


def find_range(text):
    """Lowest and highest value that a text tells, each None where it does not."""
    match = re.search(r"(?<![\w.^-])(%s) to (%s)" % (NUMBER, NUMBER), text)
    if match:
        return to_number(match.group(1)), to_number(match.group(2))
    match = re.search(r"(?<![\w.^-])(%s) or above" % NUMBER, text)
    return (to_number(match.group(1)) if match else None), None


def check_default(prop, headers, entries, comment, errors):
    values = (prop.element.get("default_values") or "").split()
    defaults = next((found for found in (h.find_default(prop.member)
                                         for h in headers.lineage(prop.proxy_class)) if found), None)
    if defaults is None:
        # Names of arrays.
        if prop.element.tag != "StringVectorProperty":
            errors.append("%s: the header has no default" % prop.place)
        elif values and ('Default "%s"' % values[-1]) not in comment:
            errors.append("%s: the comment does not tell the default %s" % (prop.place, values[-1]))
        return
    if len(defaults) == 3 and defaults[1] == "/":
        defaults = ["".join(defaults)]
    defaults = [default for default in defaults if default]
    values_of_texts = {text: value for value, text in prop.entries.items()}
    enumerators = {key: values_of_texts[text] for key, text in entries.items() if text}
    numbers = [float(enumerators[word]) if word in enumerators
               else {"true": 1.0, "false": 0.0}.get(word) if word in ("true", "false")
               else to_number(word) for word in defaults]
    if len(numbers) != len(values) or any(
            not math.isclose(float(a), b, rel_tol=1e-9) for a, b in zip(values, numbers)):
        errors.append("%s: default %s, the header has %s" %
                      (prop.place, " ".join(values), " ".join(defaults)))


def check_domain(prop, headers, entries, text, errors):
    """Range, entries or switch, whatever the header has."""
    is_boolean = any(h.is_boolean(prop.member) for h in headers.lineage(prop.proxy_class))
    if is_boolean != (prop.element.find("BooleanDomain") is not None):
        errors.append("%s: only members of type bool have a BooleanDomain" % prop.place)
    if entries and len([t for t in entries.values() if t]) != max(len(entries), len(prop.entries)):
        errors.append("%s: the entries %s are not the enumerators %s" %
                      (prop.place, prop.entries, sorted(entries)))
    domain = prop.element.find("DoubleRangeDomain")
    domain = prop.element.find("IntRangeDomain") if domain is None else domain
    if domain is None:
        return
    wanted = find_range(text)
    found = tuple(None if domain.get(key) is None else float(domain.get(key))
                  for key in ("min", "max"))
    if wanted != found:
        errors.append("%s: range %s, the header tells %s" % (prop.place, found, wanted))


def check_property(prop, headers, labels, errors):
    """Returns the documentation that the property should have."""
    comment = next((found for found in (h.find_comment(prop.command)
                                        for h in headers.lineage(prop.proxy_class)) if found), None)
    if not comment:
        errors.append("%s: no header has a comment for this command" % prop.place)
        return None
    entries = find_entries(prop, headers)
    text = to_panel(comment, entries, labels)
    if prop.documentation != text:
        errors.append("%s: the documentation is\n    %s\n  but the header says\n    %s" %
                      (prop.place, prop.documentation, text))
    code = re.search(r"\bvtk[A-Z]\w+|\w+::\w+|\w+\(\)|\bnullptr\b", text)
    if code:
        errors.append("%s: a panel should not speak of %s; a second paragraph of the comment may" %
                      (prop.place, code.group()))
    # Commands and what is only told have neither default nor range.
    is_setting = prop.element.tag != "Property" and not prop.element.get("information_only")
    if is_setting and prop.element.find("ArrayListDomain") is None:
        check_default(prop, headers, entries, comment, errors)
        check_domain(prop, headers, entries, text, errors)
    elif is_setting and prop.element.get("number_of_elements") == "1":
        check_default(prop, headers, entries, comment, errors)
    return text


def check_completeness(files, headers, errors):
    """Every setting is in a panel, or has a reason not to be."""
    properties = [prop for props in files.values() for prop in props]
    known = {}
    for prop in properties:
        for header in headers.lineage(prop.proxy_class):
            known.setdefault(header.name, set()).add(prop.member)
    known.setdefault("vtkLineSetsRepresentation", set())
    for name, members in sorted(known.items()):
        for member in sorted(headers.classes[name].list_settings() - members):
            if "%s::%s" % (name, member) not in LEFT_OUT:
                errors.append("%s::Set%s is in no panel, and not left out for a reason" %
                              (name, member))
    for left in LEFT_OUT:
        name, member = left.split("::")
        if member not in headers.classes[name].list_settings() or member in known.get(name, ()):
            errors.append("%s is left out, but is no setting or is in a panel" % left)
    names = {}
    for prop in properties:
        other = names.setdefault(prop.name, prop)
        # Representations show their properties side by side.
        if other is not prop and "Filter" not in prop.proxy_class + other.proxy_class and \
                "vtkOpacitySegments" not in (prop.proxy_class, other.proxy_class) and \
                other.command != prop.command:
            errors.append("%s and %s have the same name" % (prop.place, other.place))


def set_documentation(text, start, documentation):
    """The XML with the first Documentation after start replaced."""
    match = re.compile(r"^( *)<Documentation[^>]*>.*?</Documentation>",
                       re.DOTALL | re.MULTILINE).search(text, start)
    indent = match.group(1)
    escaped = documentation.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    lines = textwrap.wrap(escaped, 98 - len(indent), break_long_words=False,
                          break_on_hyphens=False)
    body = "".join("\n%s  %s" % (indent, line) for line in lines)
    return (text[:match.start()] + "%s<Documentation>%s\n%s</Documentation>" %
            (indent, body, indent) + text[match.end():])


def update(path, texts, filter_texts):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for (proxy_class, command), documentation in texts.items():
        proxy = re.search(r'<\w+ [^>]*class="%s"' % proxy_class, text)
        start = re.compile(r'<\w*Property [^>]*command="%s"' % command).search(text, proxy.start())
        text = set_documentation(text, start.start(), documentation)
    for name, (brief, documentation) in filter_texts.items():
        start = re.search(r'<SourceProxy [^>]*name="%s"' % name, text).start()
        text = set_documentation(text, start, documentation)
        text = text[:start] + text[start:].replace(
            "<Documentation>", '<Documentation\n          short_help="%s">' % brief, 1)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("source", nargs="?", default=os.path.join(os.path.dirname(
        os.path.abspath(__file__)), "..", ".."), help="folder of the project")
    parser.add_argument("--update", action="store_true",
                        help="write the documentation into the XML")
    arguments = parser.parse_args()

    errors = []
    headers = Headers(arguments.source)
    files, filters = read_properties(arguments.source, errors)
    labels = {prop.member: prop.label for props in files.values() for prop in props}
    checked = 0
    for path, properties in files.items():
        texts = {}
        for prop in properties:
            text = check_property(prop, headers, labels, errors)
            checked += 1
            if text:
                texts[(prop.proxy_class, prop.command)] = text
        filter_texts = {}
        for filter_path, proxy in filters:
            if filter_path != path:
                continue
            header = headers.classes[proxy.get("class")]
            brief, first = header.find_brief(), header.find_first_paragraph()
            filter_texts[proxy.get("name")] = (brief, first)
            documentation = proxy.find("Documentation")
            if normalize(documentation.text or "") != first or \
                    documentation.get("short_help") != brief:
                errors.append("%s: the documentation is not that of %s.h" %
                              (proxy.get("name"), header.name))
        if arguments.update:
            update(path, texts, filter_texts)
    if arguments.update:
        return 0
    check_completeness(files, headers, errors)
    for error in errors:
        print("error: " + error)
    print("%d properties, %d errors" % (checked, len(errors)))
    return 1 if errors or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
