// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Times how fast line sets are drawn by vtkVoxelLineMapper and by what VTK has otherwise, and
// compares the pictures with exact ones. --help tells the options.
#include "Benchmark.h"
#include "BenchmarkOptions.h"

#include "vtkSMPTools.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{
constexpr int ExitFailure = 1;
constexpr int ExitUsage = 2;

void SetThreads(int threads)
{
  if (threads <= 0)
  {
    return;
  }
  vtkSMPTools::Initialize(threads);
#ifndef _WIN32
  // Mesa's software renderer reads this when the context is made.
  setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 0);
#endif
}

int RunBenchmark(const linesets::BenchmarkOptions& options)
{
  // Opened first, so that hours of measuring are not lost.
  std::ofstream file;
  if (!options.JsonFile.empty())
  {
    file.open(options.JsonFile);
    if (!file)
    {
      std::cerr << "linesets-bench: cannot write " << options.JsonFile << "\n";
      return ExitFailure;
    }
  }
  SetThreads(options.Threads);
  linesets::Benchmark benchmark(options);
  const bool good = benchmark.Run();
  std::ostream& out = options.JsonFile.empty() ? std::cout : file;
  for (const std::string& line : benchmark.GetResults())
  {
    out << line << "\n";
  }
  out.flush();
  return good && out ? EXIT_SUCCESS : ExitFailure;
}
}

int main(int argc, char* argv[])
{
  linesets::BenchmarkOptions options;
  try
  {
    options = linesets::ParseBenchmarkOptions(argc, argv);
  }
  catch (const std::invalid_argument& error)
  {
    std::cerr << "linesets-bench: " << error.what() << "\n";
    return ExitUsage;
  }
  if (options.Help)
  {
    linesets::PrintBenchmarkHelp(std::cout);
    return EXIT_SUCCESS;
  }
  if (options.DataFolder.empty())
  {
    options.DataFolder = LINESETS_DATA_FOLDER;
  }
  try
  {
    return RunBenchmark(options);
  }
  catch (const std::exception& error)
  {
    std::cerr << "linesets-bench: " << error.what() << "\n";
    return ExitFailure;
  }
}
