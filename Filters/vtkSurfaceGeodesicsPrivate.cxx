// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicsPrivate.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkLineVoxelizerInputPrivate.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace vtkSurfaceGeodesics
{

namespace
{

using Vector = std::array<double, 3>;
/// An edge has its last two vertices equal, a lonely vertex all three.
using Triangle = std::array<int, 3>;

/// Values of VertexOfPoint below 0.
constexpr int NotUsed = -1;
constexpr int NotFinite = -2;

Vector operator-(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Distance(const Vector& a, const Vector& b)
{
  return std::sqrt(Dot(a - b, a - b));
}

/// How often polygons and strips use a point, or more.
vtkIdType GetNumberOfUses(vtkPolyData* data)
{
  vtkIdType number = 0;
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    number += cells ? cells->GetNumberOfConnectivityIds() : 0;
  }
  return number;
}

/// Finds the vertex at given coordinates, by hashing with linear probing.
class VertexTable
{
public:
  explicit VertexTable(vtkIdType largestSize)
  {
    std::size_t size = 64;
    while (size < 2 * static_cast<std::size_t>(largestSize))
    {
      size *= 2;
    }
    this->Slots.assign(size, -1);
  }

  /// Returns the vertex at these coordinates, which is a new one at the end where there is none.
  int Find(const Vector& point, std::vector<Vector>& vertices)
  {
    std::size_t slot = Hash(point);
    for (;; ++slot)
    {
      int& vertex = this->Slots[slot & (this->Slots.size() - 1)];
      if (vertex < 0)
      {
        vertex = static_cast<int>(vertices.size());
        vertices.push_back(point);
        return vertex;
      }
      if (vertices[static_cast<std::size_t>(vertex)] == point)
      {
        return vertex;
      }
    }
  }

private:
  static std::size_t Hash(const Vector& point)
  {
    std::uint64_t hash = 0;
    for (double coordinate : point)
    {
      // Both zeros are equal.
      const double value = coordinate + 0.0;
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }

  std::vector<int> Slots;
};

}

class MeshReader
{
public:
  MeshReader(Mesh& mesh, vtkPolyData* data)
    : Target(mesh)
    , Table(std::min(data->GetNumberOfPoints(), GetNumberOfUses(data)))
  {
    this->Points.SetPoints(data->GetPoints() ? data->GetPoints()->GetData() : nullptr);
    mesh.VertexOfPoint.assign(static_cast<std::size_t>(this->Points.GetNumberOfPoints()), NotUsed);
  }

  void AddPolygons(vtkCellArray* cells)
  {
    vtkNew<vtkIdList> ids;
    const vtkIdType numberOfCells = cells ? cells->GetNumberOfCells() : 0;
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      cells->GetCellAtId(cell, ids);
      if (this->ReadVertices(ids))
      {
        this->AddPolygon();
      }
    }
  }

  void AddStrips(vtkCellArray* cells)
  {
    vtkNew<vtkIdList> ids;
    const vtkIdType numberOfCells = cells ? cells->GetNumberOfCells() : 0;
    vtkNew<vtkIdList> triangle;
    triangle->SetNumberOfIds(3);
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      cells->GetCellAtId(cell, ids);
      if (ids->GetNumberOfIds() < 3 || !this->HasValidIds(ids))
      {
        this->Target.NumberOfIgnoredCells += ids->GetNumberOfIds() < 3 ? 1 : 0;
        continue;
      }
      for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
      {
        for (vtkIdType j = 0; j < 3; ++j)
        {
          triangle->SetId(j, ids->GetId(i - 2 + j));
        }
        this->ReadVertices(triangle);
        this->AddPolygon();
      }
    }
  }

  void Finish()
  {
    this->FindUnit();
    this->MakeCorners();
    this->FindPieces();
  }

private:
  bool HasValidIds(vtkIdList* ids)
  {
    vtkIdType invalid = 0;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      invalid += id < 0 || id >= this->Points.GetNumberOfPoints() ? 1 : 0;
    }
    this->Target.NumberOfInvalidIds += invalid;
    this->Target.NumberOfIgnoredCells += invalid > 0 ? 1 : 0;
    return invalid == 0;
  }

  /// The finite corners of a polygon, without repetitions in a row. False where it is ignored.
  bool ReadVertices(vtkIdList* ids)
  {
    if (!this->HasValidIds(ids))
    {
      return false;
    }
    this->Polygon.clear();
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const int vertex = this->GetVertex(ids->GetId(i));
      if (vertex >= 0 && (this->Polygon.empty() || this->Polygon.back() != vertex))
      {
        this->Polygon.push_back(vertex);
      }
    }
    while (this->Polygon.size() > 1 && this->Polygon.back() == this->Polygon.front())
    {
      this->Polygon.pop_back();
    }
    return true;
  }

  int GetVertex(vtkIdType id)
  {
    int& vertex = this->Target.VertexOfPoint[static_cast<std::size_t>(id)];
    if (vertex == NotUsed)
    {
      Vector point;
      this->Points.Get(id, point.data());
      const bool isFinite =
        std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
      vertex = isFinite ? this->Table.Find(point, this->Vertices) : NotFinite;
      this->Target.NumberOfNonFinitePoints += isFinite ? 0 : 1;
    }
    return vertex;
  }

  const Vector& At(std::size_t corner) const
  {
    return this->Vertices[static_cast<std::size_t>(this->Polygon[corner])];
  }

  void Add(std::size_t a, std::size_t b, std::size_t c)
  {
    this->Triangles.push_back({ this->Polygon[a], this->Polygon[b], this->Polygon[c] });
  }

  void AddPolygon()
  {
    switch (this->Polygon.size())
    {
      case 0:
        break;
      case 1:
        this->Add(0, 0, 0);
        break;
      case 2:
        this->Add(0, 1, 1);
        break;
      case 3:
        this->Add(0, 1, 2);
        break;
      case 4:
        this->AddQuad();
        break;
      default:
        this->AddLargePolygon();
        break;
    }
  }

  /// Part a quad at the diagonal that lies inside, or the shorter one where both do.
  void AddQuad()
  {
    // How far the two triangles beside the diagonal from corner i face the same way.
    const auto agreement = [this](std::size_t i)
    {
      const Vector diagonal = this->At(i + 2) - this->At(i);
      return Dot(Cross(this->At(i + 1) - this->At(i), diagonal),
        Cross(diagonal, this->At((i + 3) % 4) - this->At(i)));
    };
    const bool isInside[2] = { agreement(0) > 0.0, agreement(1) > 0.0 };
    const bool isShorter = Distance(this->At(0), this->At(2)) <= Distance(this->At(1), this->At(3));
    if (isInside[0] != isInside[1] ? isInside[0] : isShorter)
    {
      this->Add(0, 1, 2);
      this->Add(0, 2, 3);
    }
    else
    {
      this->Add(0, 1, 3);
      this->Add(1, 2, 3);
    }
  }

  void AddLargePolygon()
  {
    const vtkIdType size = static_cast<vtkIdType>(this->Polygon.size());
    this->Cell->Points->SetDataTypeToDouble();
    this->Cell->Points->SetNumberOfPoints(size);
    this->Cell->PointIds->SetNumberOfIds(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Cell->Points->SetPoint(i, this->At(static_cast<std::size_t>(i)).data());
      this->Cell->PointIds->SetId(i, i);
    }
    if (this->Cell->EarCutTriangulation(this->Parts) &&
      this->Parts->GetNumberOfIds() == 3 * (size - 2))
    {
      for (vtkIdType i = 0; i < this->Parts->GetNumberOfIds(); i += 3)
      {
        this->Add(static_cast<std::size_t>(this->Parts->GetId(i)),
          static_cast<std::size_t>(this->Parts->GetId(i + 1)),
          static_cast<std::size_t>(this->Parts->GetId(i + 2)));
      }
      return;
    }
    // A polygon that crosses itself or has no area: a fan keeps it connected.
    for (std::size_t i = 2; i < this->Polygon.size(); ++i)
    {
      this->Add(0, i - 1, i);
    }
  }

  void FindUnit()
  {
    double largest = 0.0;
    for (const Vector& vertex : this->Vertices)
    {
      for (double coordinate : vertex)
      {
        largest = std::max(largest, std::abs(coordinate));
      }
    }
    const int exponent = largest > 0.0 ? std::min(std::max(std::ilogb(largest), -1000), 1000) : 0;
    this->Target.Unit = std::ldexp(1.0, exponent);
    const double scale = std::ldexp(1.0, -exponent);
    for (Vector& vertex : this->Vertices)
    {
      for (double& coordinate : vertex)
      {
        coordinate *= scale;
      }
    }
  }

  void MakeCorners()
  {
    std::vector<vtkIdType>& offsets = this->Target.Offsets;
    offsets.assign(this->Vertices.size() + 1, 0);
    const auto numberOfCorners = [](const Triangle& triangle)
    { return triangle[1] != triangle[2] ? 3u : (triangle[0] != triangle[1] ? 2u : 0u); };
    for (const Triangle& triangle : this->Triangles)
    {
      for (std::size_t i = 0; i < numberOfCorners(triangle); ++i)
      {
        ++offsets[static_cast<std::size_t>(triangle[i]) + 1];
      }
    }
    for (std::size_t i = 1; i < offsets.size(); ++i)
    {
      offsets[i] += offsets[i - 1];
    }
    this->Target.Corners.resize(static_cast<std::size_t>(offsets.back()));
    std::vector<vtkIdType> next(offsets.begin(), offsets.end() - 1);
    for (const Triangle& triangle : this->Triangles)
    {
      for (std::size_t i = 0; i < numberOfCorners(triangle); ++i)
      {
        const std::size_t here = static_cast<std::size_t>(triangle[i]);
        Corner& corner = this->Target.Corners[static_cast<std::size_t>(next[here]++)];
        corner.Ends = { triangle[(i + 1) % 3], triangle[(i + 2) % 3] };
        // Of the second vertex of an edge, the next one is itself.
        corner.Ends[0] = corner.Ends[0] == triangle[i] ? corner.Ends[1] : corner.Ends[0];
      }
    }
    std::vector<Triangle>().swap(this->Triangles);
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Vertices.size()), 4096,
      [this](vtkIdType first, vtkIdType last) { this->Measure(first, last); });
  }

  /// The lengths of the corners of a range of vertices.
  void Measure(vtkIdType first, vtkIdType last)
  {
    for (std::size_t vertex = static_cast<std::size_t>(first);
         vertex < static_cast<std::size_t>(last); ++vertex)
    {
      const std::size_t end = static_cast<std::size_t>(this->Target.Offsets[vertex + 1]);
      for (std::size_t i = static_cast<std::size_t>(this->Target.Offsets[vertex]); i < end; ++i)
      {
        Corner& corner = this->Target.Corners[i];
        const Vector& a = this->Vertices[static_cast<std::size_t>(corner.Ends[0])];
        const Vector& b = this->Vertices[static_cast<std::size_t>(corner.Ends[1])];
        corner.Lengths = { Distance(this->Vertices[vertex], a),
          Distance(this->Vertices[vertex], b) };
        corner.Opposite = Distance(a, b);
      }
    }
  }

  void FindPieces()
  {
    Mesh& mesh = this->Target;
    mesh.Pieces.assign(this->Vertices.size(), -1);
    std::vector<int> stack;
    for (int seed = 0; seed < mesh.GetNumberOfVertices(); ++seed)
    {
      if (mesh.Pieces[static_cast<std::size_t>(seed)] >= 0)
      {
        continue;
      }
      const int piece = mesh.GetNumberOfPieces();
      mesh.FirstVertices.push_back(seed);
      mesh.Pieces[static_cast<std::size_t>(seed)] = piece;
      stack.assign(1, seed);
      while (!stack.empty())
      {
        const int vertex = stack.back();
        stack.pop_back();
        for (const Corner* corner = mesh.Begin(vertex); corner != mesh.End(vertex); ++corner)
        {
          for (int end : corner->Ends)
          {
            int& pieceOfEnd = mesh.Pieces[static_cast<std::size_t>(end)];
            if (pieceOfEnd < 0)
            {
              pieceOfEnd = piece;
              stack.push_back(end);
            }
          }
        }
      }
    }
  }

  Mesh& Target;
  vtkLineVoxelizerPrivate::PointReader Points;
  VertexTable Table;
  std::vector<Vector> Vertices;
  std::vector<Triangle> Triangles;
  std::vector<int> Polygon;
  vtkNew<vtkPolygon> Cell;
  vtkNew<vtkIdList> Parts;
};

//------------------------------------------------------------------------------
void Mesh::Read(vtkPolyData* data)
{
  MeshReader reader(*this, data);
  reader.AddPolygons(data->GetPolys());
  reader.AddStrips(data->GetStrips());
  reader.Finish();
}

}
