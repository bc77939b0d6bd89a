# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that a state saved as .pvsm or .py, and a trace, give the same picture and the same values
of all properties again, for each representation with all of its properties changed that can be."""
import os

import linesets_testing as testing
from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.vtkCommonCore import vtkDoubleArray

REPRESENTATIONS = {"Voxel Lines": "VoxelLinesRepresentation",
                   "Illuminated Lines": "IlluminatedLinesRepresentation",
                   "Fourier Opacity": "FourierOpacityRepresentation"}


def list_names(proxy_name):
    """Names of the properties of a representation's prototype."""
    proxy = servermanager.ProxyManager().GetPrototypeProxy("representations", proxy_name)
    iterator = proxy.NewPropertyIterator()
    names = set()
    iterator.Begin()
    while not iterator.IsAtEnd():
        names.add(iterator.GetKey())
        iterator.Next()
    return names


def find_properties(display, representation):
    """Names of those that ParaView's own surface does not have."""
    names = list_names(REPRESENTATIONS[representation]) - list_names("SurfaceRepresentation")
    # What only tells of the last picture is no state.
    return sorted(name for name in names & set(display.ListProperties())
                  if not display.SMProxy.GetProperty(name).GetInformationOnly())


def get_domain(prop, kind):
    iterator = prop.NewDomainIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        if iterator.GetDomain().IsA(kind):
            return iterator.GetDomain()
        iterator.Next()
    return None


def find_other_value(prop):
    """Another valid value of a property of numbers or of an array; None for others."""
    if prop.IsA("vtkSMStringVectorProperty") and prop.GetNumberOfElements() == 1:
        arrays = get_domain(prop, "vtkSMArrayListDomain")
        names = [arrays.GetString(i) for i in range(arrays.GetNumberOfStrings())]
        return next((name for name in names if name != prop.GetElement(0)), None)
    if prop.IsA("vtkSMDoubleVectorProperty") and prop.GetNumberOfElements() > 1:
        return [0.75 * prop.GetElement(i) + 0.1 for i in range(prop.GetNumberOfElements())]
    if not prop.IsA("vtkSMVectorProperty") or prop.GetNumberOfElements() != 1:
        return None
    if not prop.IsA("vtkSMIntVectorProperty") and not prop.IsA("vtkSMDoubleVectorProperty"):
        return None
    old = prop.GetElement(0)
    if get_domain(prop, "vtkSMBooleanDomain"):
        return 1 - old
    entries = get_domain(prop, "vtkSMEnumerationDomain")
    if entries:
        values = [entries.GetEntryValue(i) for i in range(entries.GetNumberOfEntries())]
        return next((value for value in values if value != old), None)
    if prop.IsA("vtkSMIntVectorProperty"):
        return old // 2 if old > 1 else old + 1
    return 0.75 * old if old > 0.0 else 0.01


def change_properties(display, representation):
    """Changes what can be changed; returns the values of all."""
    left = []
    for name in find_properties(display, representation):
        prop = display.SMProxy.GetProperty(name)
        value = find_other_value(prop)
        if value is None:
            left.append(name)
        else:
            setattr(display, name, value)
    print(representation, "left", left, flush=True)
    # The first is chosen before, the second does something and has no value.
    testing.check(set(left) <= {"ImportanceArray", "ForgetOpacities"},
                  "%s: all is changed but %s" % (representation, left))


def get_values(display, representation):
    values = {}
    for name in find_properties(display, representation):
        prop = display.SMProxy.GetProperty(name)
        if prop.IsA("vtkSMVectorProperty"):
            values[name] = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
    return values


def make_lines():
    """Helices with arrays for all that arrays can be chosen for."""
    data = testing.make_helices(10)
    for name, components in (("Size", 1), ("Direction", 3)):
        array = vtkDoubleArray()
        array.SetName(name)
        array.SetNumberOfComponents(components)
        array.SetNumberOfTuples(data.GetNumberOfPoints())
        for i in range(components):
            array.FillComponent(i, 0.05)
        data.GetPointData().AddArray(array)
    return data


def make_scene(representation):
    """All that a user would do, which a trace records."""
    source = simple.XMLPolyDataReader(registrationName="Lines", FileName=[path])
    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(source, view)
    display.SetRepresentationType(representation)
    simple.ColorBy(display, ("POINTS", "Height"))
    table = simple.GetColorTransferFunction("Height")
    # As the panels do it, so that it is traced.
    items = [smtrace.PropertiesModified(proxy.SMProxy) for proxy in (display, view, table)]
    table.RGBPoints = [0.0, 0.0, 0.8, 0.0, 2.0, 0.9, 0.8, 0.0]
    display.ImportanceArray = "Height"
    display.Opacity = 0.8
    display.LineWidth = 4
    change_properties(display, representation)
    view.ViewSize = [200, 200]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.1, 0.1, 0.2]
    view.CameraPosition = [4.0, 3.0, 5.0]
    view.CameraFocalPoint = [0.0, 0.0, 1.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 1.5
    for item in items:
        item.finalize()
    simple.Render(view)
    return display


def draw(name):
    view = simple.GetActiveViewOrCreate("RenderView")
    for _ in range(3):
        simple.Render(view)
    return testing.take_picture(view, "TestState" + name)


def clear():
    """Deletes all that was made."""
    for source in list(simple.GetSources().values()):
        simple.Delete(source)
    for view in simple.GetViews():
        simple.Delete(view)
    for layout in list(simple.GetLayouts().values()):
        simple.Delete(layout)


def run(text):
    exec(compile(text, "state", "exec"), {"__name__": "state"})


testing.load_plugin()
messages = testing.Messages()
path = testing.write_lines(make_lines(), "TestState")
for representation in REPRESENTATIONS:
    smtrace.start_trace()
    display = make_scene(representation)
    trace = smtrace.stop_trace()
    expected = draw("Before")
    testing.check((abs(expected - expected[0, 0]).max(axis=2) > 10.0).sum() > 1000,
                  "%s draws something" % representation)
    values = get_values(display, representation)
    xml = os.path.join(testing.OUTPUT, "TestState.pvsm")
    simple.SaveState(xml)
    state = smstate.get_state()
    for kind, load in (("pvsm", lambda: simple.LoadState(xml)), ("py", lambda: run(state)),
                       ("trace", lambda: run(trace))):
        clear()
        load()
        source = next(iter(simple.GetSources().values()))
        again = simple.GetRepresentation(source, simple.GetActiveViewOrCreate("RenderView"))
        what = "%s by %s" % (representation, kind)
        testing.check(again.Representation == representation, what)
        now = get_values(again, representation)
        different = {name: (values[name], now[name]) for name in values
                     if values[name] != now[name]}
        testing.check(not different, "%s: other values %s" % (what, different))
        picture = draw(kind)
        difference = testing.rmse(expected, picture)
        print(what, difference, flush=True)
        testing.check(difference <= 1.0, "%s: the picture differs by %.2f" % (what, difference))
    clear()
errors = [text for text in messages.take() if text.startswith("Error")]
testing.check(not errors, "no errors: %s" % errors)
