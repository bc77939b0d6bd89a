// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Densities and occlusion of voxels in texture buffers, for fragment shaders, which define
// LineSetsHasDensities and LineSetsHasOcclusion where they have them.
//
// A sampler that no texture is set for names the first unit. Where a texture of another kind is
// there, OpenGL refuses to draw, and some drivers do so for samplers that no branch reads that is
// taken: what is not set must not be declared.

#ifdef LineSetsHasDensities
uniform int DensityStarts[32];
uniform samplerBuffer Densities;
#endif
#ifdef LineSetsHasOcclusion
uniform samplerBuffer OcclusionOfVoxels;
#endif

float fetchDensity(int level, int i)
{
#ifdef LineSetsHasDensities
  return texelFetch(Densities, DensityStarts[level] + i).r;
#else
  return 0.0;
#endif
}

float fetchOcclusion(int i)
{
#ifdef LineSetsHasOcclusion
  return texelFetch(OcclusionOfVoxels, i).r;
#else
  return 0.0;
#endif
}
