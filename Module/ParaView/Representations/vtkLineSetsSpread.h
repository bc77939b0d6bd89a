// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsSpread
 * @brief   how an array of points or cells is spread over parts of the lines
 *
 * Parts are blocks of a composite data set (vtkLineSetsBlocks) or what several ranks have
 * (vtkLineSetsCompletion). They can be joined only if all have the array with as many components
 * and of the same type. Where they do not, it is made so: doubles, with NaN where a part has no
 * array of that name and number of components. The first part that has it tells how many.
 */

#ifndef vtkLineSetsSpread_h
#define vtkLineSetsSpread_h

#include <cstddef>
#include <set>
#include <string>
#include <utility>

class vtkPolyData;

class vtkLineSetsSpread
{
public:
  /// Association: vtkDataObject::POINT or vtkDataObject::CELL.
  vtkLineSetsSpread(const std::string& name, int association);

  /// Name and association of an array.
  using Identity = std::pair<std::string, int>;

  /// All arrays of the part, of points and of cells.
  static std::set<Identity> FindArrays(vtkPolyData* part);

  /// Number of components of the part's array, 0 without one, and type of its values.
  static void Describe(
    vtkPolyData* part, const std::string& name, int association, int& components, int& type);

  ///@{
  /// Counts one more part, or what Describe() tells of it.
  void Add(vtkPolyData* part);
  void Add(int components, int type);
  ///@}

  const std::string& GetName() const { return this->Name; }
  int GetAssociation() const { return this->Association; }

  /// Whether parts need to be changed to have the array alike.
  bool IsPartial() const { return this->Components > 0 && (this->Missing > 0 || this->IsMixed); }

  /// How many parts lack the array.
  std::size_t GetMissing() const { return this->Missing; }

  /// What tells one way to change parts from another.
  std::string GetKey() const;

  /// A sentence that tells how many lack the array, and what follows; parts: "visible blocks".
  std::string GetWarning(const std::string& parts) const;

  /// Gives the part the array in double precision.
  void Apply(vtkPolyData* part) const;

private:
  std::string Name;
  int Association;
  int Components = 0;
  int Type = 0;
  std::size_t Parts = 0;
  std::size_t Missing = 0;
  bool IsMixed = false;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsSpread.h
