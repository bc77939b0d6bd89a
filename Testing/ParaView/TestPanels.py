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

REPRESENTATIONS = {"Voxel Lines": "VoxelLinesRepresentation",
                   "Illuminated Lines": "IlluminatedLinesRepresentation",
                   "Fourier Opacity": "FourierOpacityRepresentation"}
FOLDER = os.path.join(testing.SOURCE, "Module", "ParaView", "Representations")
# Of representations: values to set, and what the object that draws prints then.
ARRAYS = {"RadiusArray": (["Width"], "RadiusArrayName", "Width"),
          "TangentArray": (["Flow"], "TangentArrayName", "Flow"),
          "SpecularPowerArray": (["Height"], "SpecularPowerArrayName", "Height"),
          "ImportanceArray": (["0", "", "", "1", "Helix"], "ImportanceArrayName", "Helix")}


def list_properties():
    """(class, element) of all properties of the line_sets proxies."""
    for path in sorted(glob.glob(os.path.join(FOLDER, "*.xml"))):
        for group in ElementTree.parse(path).iter("ProxyGroup"):
            if group.get("name") == "line_sets":
                for proxy in group.iter("Proxy"):
                    for element in proxy:
                        if element.tag.endswith("VectorProperty"):
                            yield proxy.get("class"), element


def find_objects(proxy, vtk_class):
    """The client's objects of a class, or of one that derives from it, in the tree of proxies."""
    found = []
    for i in range(proxy.GetNumberOfSubProxies()):
        found += find_objects(proxy.GetSubProxy(i), vtk_class)
    if proxy.GetVTKClassName() and proxy.GetClientSideObject() and \
            proxy.GetClientSideObject().IsA(vtk_class):
        found.append(proxy.GetClientSideObject())
    return found


def get_printed(vtk_object, member):
    match = re.search(r"^ *%s: *(.*?) *$" % member, str(vtk_object), re.MULTILINE)
    testing.check(match, "%s is not printed by\n%s" % (member, vtk_object))
    return match.group(1)


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


def is_same(printed, value):
    if printed in ("On", "Off"):
        return printed == ("On" if value else "Off")
    # Some values are followed by what they mean.
    number = re.match(r"-?[\d.]+(?:e[+-]?\d+)?", printed)
    return number and abs(float(number.group()) - value) <= 1e-5 * abs(value)


testing.load_plugin()
data = testing.make_helices()
calculators = simple.XMLPolyDataReader(FileName=[testing.write_lines(data, "panels")])
for name, function in (("Width", "0.01+0.001*coordsZ"), ("Flow", "coordsX*iHat+jHat")):
    calculators = simple.Calculator(Input=calculators, ResultArrayName=name, Function=function)
view = testing.make_view()
display = simple.Show(calculators, view)
proxy = display.SMProxy

count = 0
for vtk_class, element in list_properties():
    name = element.get("name")
    member = element.get("command")[3:]
    testing.check(proxy.GetProperty(name), "the representation does not show " + name)
    if element.get("information_only"):
        continue
    value = choose_value(element)
    objects = find_objects(proxy, vtk_class)
    expected = 3 if vtk_class == "vtkLineIllumination" else \
        2 if vtk_class == "vtkIlluminatedLineMapper" else 1
    testing.check(len(objects) == expected, "%d objects are a %s" % (len(objects), vtk_class))
    default = float(element.get("default_values"))
    for vtk_object in objects:
        testing.check(is_same(get_printed(vtk_object, member), default),
                      "%s begins with %s, not with %s" %
                      (name, get_printed(vtk_object, member), default))
    servermanager.vtkSMPropertyHelper(proxy, name).Set(value)
    proxy.UpdateVTKObjects()
    for vtk_object in objects:
        testing.check(is_same(get_printed(vtk_object, member), value),
                      "%s was set to %s, but %s has %s" %
                      (name, value, vtk_object.GetClassName(), get_printed(vtk_object, member)))
    servermanager.vtkSMPropertyHelper(proxy, name).Set(element.get("default_values"))
    proxy.UpdateVTKObjects()
    count += 1
print("%d settings reach their objects" % count)
testing.check(count > 40, "only %d settings were tried" % count)

mappers = {text: proxy.GetSubProxy(name).GetSubProxy("LineMapper").GetClientSideObject()
           for text, name in REPRESENTATIONS.items()}
for name, (value, member, printed) in ARRAYS.items():
    targets = [m for m in mappers.values() if (member + ":") in str(m)]
    testing.check(targets, "nothing prints " + member)
    if name != "ImportanceArray":
        for mapper in targets:
            testing.check(get_printed(mapper, member) == "", name + " begins with no array")
    servermanager.vtkSMPropertyHelper(proxy, name).Set(value[0] if len(value) == 1 else value)
    proxy.UpdateVTKObjects()
    for mapper in targets:
        testing.check(get_printed(mapper, member) == printed, "%s is %s for %s" % (
            name, get_printed(mapper, member), mapper.GetClassName()))
    if name == "ImportanceArray":
        testing.check(get_printed(targets[0], "ImportanceArrayAssociation") == "1",
                      "the importance array is one of cells")
        continue
    servermanager.vtkSMPropertyHelper(proxy, name).Set("None")
    proxy.UpdateVTKObjects()
    for mapper in targets:
        testing.check(get_printed(mapper, member) == "", name + " can be taken back")

fourier = mappers["Fourier Opacity"]
testing.check(get_printed(fourier, "ImportanceRange") == "1 0", "the array's range counts at first")
display.ImportanceArray = ["POINTS", "Height"]
domain = proxy.GetProperty("ImportanceRange").GetDomain("range")
testing.check(abs(domain.GetMaximum(0) - 1.98) < 1e-6, "the domain has the range of the array")
display.UseImportanceRange = 1
display.ImportanceRange = [0.25, 0.75]
testing.check(get_printed(fourier, "ImportanceRange") == "0.25 0.75", "the importance range counts")
display.UseImportanceRange = 0
testing.check(get_printed(fourier, "ImportanceRange") == "1 0", "the array's range counts again")

# By their names, as in a Python trace.
display.Shadows = "Soft"
display.AmbientOcclusion = "Spherical"
display.Reflection = "Blinn"
display.LineWidth = 2
for name in REPRESENTATIONS:
    display.Representation = name
    simple.Render(view)
    testing.check(display.Reflection == "Blinn", "the light stays with " + name)
    testing.check("LineWidth: 2" not in str(mappers[name]), "line width is the property's")


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

with open(os.path.join(testing.OUTPUT, "panels_properties.txt"), "w", encoding="utf-8") as file:
    file.write("\n".join(sorted(display.ListProperties())))
