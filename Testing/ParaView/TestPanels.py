# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that every setting of the representations reaches the VTK objects: each one that the XML
has is set through the representation as users do, and read from what the objects print. Settings
that representations share reach the objects of all. What is only told tells what was drawn."""
import glob
import os
import re
import xml.etree.ElementTree as ElementTree

import linesets_testing as testing
from paraview import servermanager, simple

REPRESENTATIONS = ("Voxel Lines", "Illuminated Lines", "Fourier Opacity")
# Which of them have the objects of a class.
OWNERS = {"vtkVoxelLineMapper": REPRESENTATIONS[:1], "vtkLineGlobalIllumination": REPRESENTATIONS[:1],
          "vtkLineIllumination": REPRESENTATIONS, "vtkIlluminatedLineMapper": REPRESENTATIONS[1:],
          "vtkFourierOpacityMapper": REPRESENTATIONS[2:],
          "vtkOpacityOptimization": REPRESENTATIONS[2:]}
FOLDER = os.path.join(testing.SOURCE, "Module", "ParaView", "Representations")
# Of representations: values to set, and what the object that draws prints then.
ARRAYS = {"RadiusArray": ("Width", "RadiusArrayName", "Width"),
          "LineTangentArray": ("Flow", "TangentArrayName", "Flow"),
          "SpecularPowerArray": ("Height", "SpecularPowerArrayName", "Height"),
          "ImportanceArray": (["CELLS", "Helix"], "ImportanceArrayName", "Helix")}


def list_properties():
    """(class, element) of all properties of the line_sets proxies."""
    for path in sorted(glob.glob(os.path.join(FOLDER, "*.xml"))):
        for group in ElementTree.parse(path).iter("ProxyGroup"):
            if group.get("name") == "line_sets":
                for proxy in group:
                    for element in proxy:
                        if element.tag.endswith("VectorProperty"):
                            yield proxy.get("class"), element


def find_mappers(display):
    """What draws each representation, by the representation's name."""
    mappers = {}
    for name in REPRESENTATIONS:
        display.Representation = name
        simple.Render()  # until then the actor tells of another one
        representation = display.SMProxy.GetClientSideObject().GetActiveRepresentation()
        mappers[name] = representation.GetActor().GetMapper()
    return mappers


def find_printed(mappers, member):
    """All that the mappers and the objects in them print of a member, by the mapper's name."""
    found = {name: re.findall(r"^ *%s: *(.*?) *$" % member, str(mapper), re.MULTILINE)
             for name, mapper in mappers.items()}
    return {name: values for name, values in found.items() if values}


def choose_value(element):
    """A valid value that is not the default."""
    default = float(element.get("default_values"))
    if element.find("BooleanDomain") is not None:
        return 1 - int(default)
    entries = [int(e.get("value")) for e in element.iterfind("EnumerationDomain/Entry")]
    if entries:
        return entries[(entries.index(int(default)) + 1) % len(entries)]
    domain = element.find("DoubleRangeDomain")
    if domain is not None:
        low, high = float(domain.get("min")), float(domain.get("max") or 10.0)
        return 0.5 * (default + (high if default < high else low))
    domain = element.find("IntRangeDomain")
    return int(default) + 1 if int(default) < int(domain.get("max")) else int(domain.get("min"))


def is_same(printed, value, entries):
    """Whether text is a value, or else the name of the entry that has the value."""
    if printed in ("On", "Off", "true", "false"):
        return (printed in ("On", "true")) == bool(value)
    if re.fullmatch(r"-?[\d.]+(?:e[+-]?\d+)?", printed):
        return abs(float(printed) - value) <= 1e-5 * abs(value)
    # Enumerators say "NoShadows" where lists say "None".
    entry = re.sub("^None$", "No", entries.get(int(value), "?").replace(" ", ""))
    return entry.lower() in printed.replace(" ", "").lower()


testing.load_plugin()
data = testing.make_helices()
calculators = simple.XMLPolyDataReader(FileName=[testing.write_lines(data, "panels")])
for name, function in (("Width", "0.01+0.001*coordsZ"), ("Flow", "coordsX*iHat+jHat")):
    calculators = simple.Calculator(Input=calculators, ResultArrayName=name, Function=function)
view = testing.make_view()
display = simple.Show(calculators, view)
proxy = display.SMProxy

mappers = find_mappers(display)

count = 0
for vtk_class, element in list_properties():
    name = element.get("name")
    member = element.get("command")[3:]
    testing.check(proxy.GetProperty(name), "the representation does not show " + name)
    if element.get("information_only"):
        continue
    value = choose_value(element)
    entries = {int(e.get("value")): e.get("text")
               for e in element.iterfind("EnumerationDomain/Entry")}
    default = float(element.get("default_values"))

    def check_printed(expected):
        for owner in OWNERS[vtk_class]:
            printed = find_printed(mappers, member).get(owner, ())
            testing.check(any(is_same(text, expected, entries) for text in printed),
                          "%s should be %s in %s, which prints %s" %
                          (name, expected, owner, printed))

    check_printed(default)
    servermanager.vtkSMPropertyHelper(proxy, name).Set(value)
    proxy.UpdateVTKObjects()
    check_printed(value)
    servermanager.vtkSMPropertyHelper(proxy, name).Set(int(default) if default == int(default)
                                                       else default)
    proxy.UpdateVTKObjects()
    check_printed(default)
    count += 1
print("%d settings reach their objects" % count)
testing.check(count > 40, "only %d settings were tried" % count)


for name, (value, member, printed) in ARRAYS.items():
    owners = find_printed(mappers, member)
    testing.check(owners, "nothing prints " + member)
    if name != "ImportanceArray":
        testing.check(all(v == [""] for v in owners.values()), name + " begins with no array")
    setattr(display, name, value)
    testing.check(all(v == [printed] for v in find_printed(mappers, member).values()),
                  "%s is %s" % (name, find_printed(mappers, member)))
    if name != "ImportanceArray":
        setattr(display, name, "None")
        testing.check(all(v == [""] for v in find_printed(mappers, member).values()),
                      name + " can be taken back")


def check_fourier(member, value):
    printed = find_printed(mappers, member)["Fourier Opacity"]
    testing.check(printed == [value], "%s should be %s, not %s" % (member, value, printed))


check_fourier("ImportanceArrayAssociation", "1")
check_fourier("ImportanceRange", "1 0")
display.ImportanceArray = ["POINTS", "Height"]
check_fourier("ImportanceArrayAssociation", "0")
domain = proxy.GetProperty("ImportanceRange").GetDomain("range")
testing.check(abs(domain.GetMaximum(0) - 1.98) < 1e-6, "the domain has the range of the array")
display.UseImportanceRange = 1
display.ImportanceRange = [0.25, 0.75]
check_fourier("ImportanceRange", "0.25 0.75")
display.UseImportanceRange = 0
check_fourier("ImportanceRange", "1 0")

# By their names, as in a Python trace.
display.Shadows = "Soft"
display.AmbientOcclusion = "Spherical"
display.Reflection = "Blinn"
display.LineWidth = 2
for name in REPRESENTATIONS:
    display.Representation = name
    simple.Render(view)
    testing.check(display.Reflection == "Blinn", "the light stays with " + name)


def tell(name):
    proxy.UpdatePropertyInformation()
    return servermanager.vtkSMPropertyHelper(proxy, name).GetAsDouble()


for name, low, high in (
        ("RadiusInUse", 0.003, 0.005), ("EngineInUse", 1, 2), ("QualityInUse", 1, 2),
        ("ModelBuildTime", 1e-6, 10), ("LightBuildTime", 1e-6, 100),
        ("NumberOfAccumulatedPictures", 1, 1), ("GraphicsMemory", 1, 1e9),
        ("NumberOfDrawnSegments", 1, 4000), ("OpacityMemory", 1e5, 1e9),
        ("OpacitySumMemory", 1e5, 1e9), ("NumberOfAccumulatedOpacityPictures", 1, 1)):
    testing.check(low <= tell(name) <= high, "%s is %s" % (name, tell(name)))
display.Blending = "Fragment Lists"
simple.Render(view)
testing.check(tell("NumberOfFragments") > 1000 and tell("NumberOfDroppedFragments") == 0 and
              tell("MeanDepthComplexity") > 1, "fragment lists tell what they hold")
