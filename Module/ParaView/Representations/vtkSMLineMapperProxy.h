// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMLineMapperProxy
 * @brief   proxy of a mapper of lines, which tells what the mapper that draws has in use
 *
 * A mapper exists in the client and on the server, but only where the frame was drawn it has lines,
 * and tells its radius, engine, memory and the like. ParaView asks the client for these wherever
 * there is an object in the client. This proxy asks the render server (its first rank) as long as
 * the mapper in the client has no lines, as with remote rendering.
 */

#ifndef vtkSMLineMapperProxy_h
#define vtkSMLineMapperProxy_h

#include "vtkParaViewLineSetsModule.h" // For export macro
#include "vtkSMProxy.h"

class VTKPARAVIEWLINESETS_EXPORT vtkSMLineMapperProxy : public vtkSMProxy
{
public:
  static vtkSMLineMapperProxy* New();
  vtkTypeMacro(vtkSMLineMapperProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Overridden to ask the process that draws.
  void UpdatePropertyInformation() override;
  void UpdatePropertyInformation(vtkSMProperty* property) override;
  ///@}

protected:
  vtkSMLineMapperProxy();
  ~vtkSMLineMapperProxy() override;

private:
  vtkSMLineMapperProxy(const vtkSMLineMapperProxy&) = delete;
  void operator=(const vtkSMLineMapperProxy&) = delete;

  /// Where the mapper that draws is.
  vtkTypeUInt32 FindDrawingLocation();
};

#endif
