# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause

# The CMake package: find_package(LineSets) from the build tree and from an installation.
include(CMakePackageConfigHelpers)
set(linesets_config_dir "${CMAKE_BINARY_DIR}/${linesets_cmake_destination}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/LineSetsConfig.cmake.in"
  "${linesets_config_dir}/LineSetsConfig.cmake"
  INSTALL_DESTINATION "${linesets_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${linesets_config_dir}/LineSetsConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES       "${linesets_config_dir}/LineSetsConfig.cmake"
              "${linesets_config_dir}/LineSetsConfigVersion.cmake"
  DESTINATION "${linesets_cmake_destination}"
  COMPONENT   development)
