//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// A quad over the whole viewport; see vtkLineSetsLayer.

in vec4 ndCoordIn;

void main()
{
  gl_Position = ndCoordIn;
}
