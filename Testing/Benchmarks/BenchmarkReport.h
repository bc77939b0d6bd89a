// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What linesets-bench tells about its methods.
 */

#ifndef BenchmarkReport_h
#define BenchmarkReport_h

#include "PictureJudge.h"

#include <string> // For the text
#include <vector> // For the methods

namespace linesets
{
/// One line of JSON about an entry; its times are compared with those of the other ones.
/// `renderer` is the name of OpenGL's renderer, or empty.
std::string DescribeEntry(const BenchmarkEntry& entry, const std::vector<BenchmarkEntry>& entries,
  const BenchmarkInput& input, const std::string& renderer);
}

#endif
