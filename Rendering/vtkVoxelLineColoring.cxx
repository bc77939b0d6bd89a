// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineColoring.h"

#include "vtkAbstractMapper.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <sstream>

namespace
{
// Part of the scalars' range below which a lookup table's range has too few of their 255 steps, and
// the ratio of values above which the smallest ones of a logarithmic table have too few.
constexpr double FewSteps = 1.0 / 16.0;
constexpr double WideRatio = 100.0;

bool SelectsByName(vtkMapper* mapper)
{
  const int mode = mapper->GetScalarMode();
  return mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME && mapper->GetArrayName() &&
    std::strlen(mapper->GetArrayName()) > 0 &&
    (mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA || mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA ||
      mode == VTK_SCALAR_MODE_USE_FIELD_DATA);
}

// The lookup table that VTK's mappers would use for this array.
vtkScalarsToColors* GetLookupTable(vtkMapper* mapper, vtkDataArray* array)
{
  if (array && array->GetLookupTable())
  {
    mapper->SetLookupTable(array->GetLookupTable());
  }
  vtkScalarsToColors* table = mapper->GetLookupTable();
  table->Build();
  return table;
}

// The table over the range that VTK's mappers would map with.
vtkScalarsToColors* GetLookupTableInRange(vtkMapper* mapper, vtkDataArray* array)
{
  vtkScalarsToColors* table = GetLookupTable(mapper, array);
  if (!mapper->GetUseLookupTableScalarRange())
  {
    table->SetRange(mapper->GetScalarRange());
  }
  return table;
}

// As in vtkMapper, the table's own factor of opacity does not count.
vtkSmartPointer<vtkUnsignedCharArray> MapWithoutAlpha(
  vtkScalarsToColors* table, vtkDataArray* values, int colorMode, int component)
{
  const double alpha = table->GetAlpha();
  table->SetAlpha(1.0);
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(static_cast<vtkAbstractArray*>(values), colorMode, component));
  table->SetAlpha(alpha);
  return colors;
}

// The part of a vector whose length a lookup table in magnitude mode maps.
void GetVectorPart(vtkScalarsToColors* table, int components, int& first, int& size)
{
  first = 0;
  size = table->GetVectorSize();
  if (size <= 0)
  {
    size = components;
    return;
  }
  first = std::clamp(table->GetVectorComponent(), 0, components - 1);
  size = std::min(size, components - first);
}

// Component of a vector that is mapped (-1: its length), as vtkScalarsToColors::MapScalars decides.
int GetComponent(vtkMapper* mapper, vtkScalarsToColors* table, int components)
{
  if (components <= 1)
  {
    return 0;
  }
  // A component set in the mapper comes first; one beyond the array means the first.
  const int asked = mapper->GetArrayComponent();
  if (asked >= 0)
  {
    return asked < components ? asked : 0;
  }
  if (table->GetVectorMode() == vtkScalarsToColors::COMPONENT)
  {
    return std::clamp(table->GetVectorComponent(), 0, components - 1);
  }
  int first;
  int size;
  GetVectorPart(table, components, first, size);
  return size == 1 ? first : -1;
}

// Values that an attribute's bytes stand for, NaN included.
void GetAttributeValues(vtkVoxelLineModel* model, vtkDoubleArray* values)
{
  double range[2];
  model->GetAttributeRange(range);
  const int last = model->GetHasNaNAttribute() ? 254 : 255;
  values->SetNumberOfValues(256);
  for (int i = 0; i < 256; ++i)
  {
    const double t = static_cast<double>(i) / last;
    values->SetValue(i, i > last ? vtkMath::Nan() : range[0] + t * (range[1] - range[0]));
  }
}

// An indexed table knows certain values only: a byte means the one that it was rounded from.
void SnapToAnnotations(vtkScalarsToColors* table, vtkDoubleArray* values)
{
  const double step = std::abs(values->GetValue(1) - values->GetValue(0));
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    const double value = values->GetValue(i);
    double nearest = value;
    double distance = 0.5 * step * (1.0 + 1e-9);
    for (vtkIdType k = 0; k < table->GetNumberOfAnnotatedValues(); ++k)
    {
      bool valid = false;
      const double annotated = table->GetAnnotatedValue(k).ToDouble(&valid);
      if (valid && std::abs(annotated - value) <= distance)
      {
        nearest = annotated;
        distance = std::abs(annotated - value);
      }
    }
    values->SetValue(i, nearest);
  }
}
}

//------------------------------------------------------------------------------
vtkVoxelLineColoring::Source vtkVoxelLineColoring::Select(vtkMapper* mapper, vtkPolyData* input)
{
  Source source;
  int place = 0;
  vtkAbstractArray* abstractArray =
    vtkAbstractMapper::GetAbstractScalars(input, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), place);
  if (!abstractArray)
  {
    if (SelectsByName(mapper) && input->GetNumberOfCells() > 0)
    {
      source.Warning = std::string("the input has no array named \"") + mapper->GetArrayName() +
        "\" where ScalarMode (" + mapper->GetScalarModeAsString() + ") looks for it";
    }
    return source;
  }

  const char* name = abstractArray->GetName() ? abstractArray->GetName() : "(unnamed)";
  vtkDataArray* array = vtkArrayDownCast<vtkDataArray>(abstractArray);
  if (!array)
  {
    source.Warning = std::string("the array \"") + name + "\" does not hold numbers";
    return source;
  }
  // Field data may belong to the cells; nothing else of it can be told apart along a line.
  source.PerCell = place != 0;
  const vtkIdType expected =
    source.PerCell ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  if (array->GetNumberOfTuples() != expected || array->GetNumberOfComponents() < 1)
  {
    std::ostringstream text;
    text << "the array \"" << name << "\" has " << array->GetNumberOfTuples()
         << " tuples, but the input has " << expected << (source.PerCell ? " cells" : " points");
    source.Warning = text.str();
    return source;
  }

  vtkScalarsToColors* table = GetLookupTable(mapper, array);
  const int components = array->GetNumberOfComponents();
  const int mode = mapper->GetColorMode();
  source.Array = array;
  source.Direct = mode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mode == VTK_COLOR_MODE_DEFAULT && array->GetDataType() == VTK_UNSIGNED_CHAR);
  if (!source.Direct && components > 1 && mapper->GetArrayComponent() < 0 &&
    table->GetVectorMode() == vtkScalarsToColors::RGBCOLORS)
  {
    source.Direct = true;
    const double* range = GetLookupTableInRange(mapper, array)->GetRange();
    source.ColorMapping = { range[0], range[1], static_cast<double>(table->GetVectorComponent()),
      static_cast<double>(table->GetVectorSize()) };
  }
  if (!source.Direct)
  {
    source.Component = GetComponent(mapper, table, components);
    if (source.Component < 0)
    {
      GetVectorPart(table, components, source.FirstComponent, source.NumberOfComponents);
    }
  }
  return source;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkVoxelLineColoring::Convert(vtkMapper* mapper, const Source& source)
{
  if (!source.Array)
  {
    return nullptr;
  }
  if (source.Direct)
  {
    return MapWithoutAlpha(GetLookupTableInRange(mapper, source.Array), source.Array,
      mapper->GetColorMode(), mapper->GetArrayComponent());
  }
  if (source.Component >= 0 || source.NumberOfComponents == source.Array->GetNumberOfComponents())
  {
    return source.Array;
  }
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetNumberOfValues(source.Array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < source.Array->GetNumberOfTuples(); ++i)
  {
    double sum = 0.0;
    for (int k = source.FirstComponent; k < source.FirstComponent + source.NumberOfComponents; ++k)
    {
      const double value = source.Array->GetComponent(i, k);
      sum += value * value;
    }
    lengths->SetValue(i, std::sqrt(sum));
  }
  return lengths;
}

//------------------------------------------------------------------------------
void vtkVoxelLineColoring::SetColors(
  vtkVoxelLineFrame& frame, vtkMapper* mapper, vtkVoxelLineModel* model)
{
  frame.Coloring = vtkVoxelLineFrame::Uniform;
  frame.HasNaN = false;
  if (!mapper->GetScalarVisibility() || !model->GetAttributes())
  {
    return;
  }
  if (model->GetAttributeKind() == vtkVoxelLineModel::Color)
  {
    frame.Coloring = vtkVoxelLineFrame::Direct;
    return;
  }
  frame.Coloring = vtkVoxelLineFrame::Table;
  frame.HasNaN = model->GetHasNaNAttribute();

  vtkScalarsToColors* table = GetLookupTableInRange(mapper, nullptr);
  vtkNew<vtkDoubleArray> values;
  GetAttributeValues(model, values);
  if (table->GetIndexedLookup())
  {
    SnapToAnnotations(table, values);
  }
  const auto colors = MapWithoutAlpha(table, values, VTK_COLOR_MODE_MAP_SCALARS, 0);
  for (int i = 0; i < 256; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      frame.ColorTable[i][k] = static_cast<float>(colors->GetTypedComponent(i, k)) / 255.0f;
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineColoring::DescribeSteps(vtkMapper* mapper, vtkVoxelLineModel* model)
{
  if (!mapper->GetScalarVisibility() || !model->GetAttributes() ||
    model->GetAttributeKind() != vtkVoxelLineModel::Scalar)
  {
    return std::string();
  }
  vtkScalarsToColors* table = GetLookupTableInRange(mapper, nullptr);
  const double* shown = table->GetRange();
  const double* stored = model->GetAttributeRange();
  // Half of each, which does not overflow.
  const double part = 0.5 * shown[1] - 0.5 * shown[0];
  const double whole = 0.5 * stored[1] - 0.5 * stored[0];
  if (!(whole > 0.0) || table->GetIndexedLookup())
  {
    return std::string();
  }
  const double low = std::max(shown[0], stored[0]);
  const double high = std::min(shown[1], stored[1]);
  const bool isWide = table->UsingLogScale() && low > 0.0 && high / low > WideRatio;
  if (part >= FewSteps * whole && !isWide)
  {
    return std::string();
  }
  std::ostringstream text;
  text << "Colours show steps: the model holds scalars in 8 bits over their range, " << stored[0]
       << " to " << stored[1] << ", and the lookup table spreads "
       << (isWide ? "the small ones of them logarithmically over " : "a small part of it, ")
       << shown[0] << " to " << shown[1] << ". "
       << (isWide ? "Colour by an array of the logarithms instead."
                  : "Clamp the array to the range of the table, or widen that range.");
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkVoxelLineColoring::HasTranslucentColors(vtkVoxelLineModel* model)
{
  vtkUnsignedCharArray* attributes = model->GetAttributes();
  if (!attributes || model->GetAttributeKind() != vtkVoxelLineModel::Color)
  {
    return false;
  }
  const unsigned char* colors = attributes->GetPointer(0);
  std::atomic<bool> translucent(false);
  vtkSMPTools::For(0, attributes->GetNumberOfValues() / 4, 1 << 16,
    [colors, &translucent](vtkIdType begin, vtkIdType end)
    {
      const unsigned char* color = colors + 4 * begin;
      for (vtkIdType i = begin; i < end && !translucent.load(std::memory_order_relaxed);
           ++i, color += 4)
      {
        if (color[3] < 255)
        {
          translucent.store(true, std::memory_order_relaxed);
        }
      }
    });
  return translucent;
}
