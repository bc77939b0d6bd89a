// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A flat JSON object on one line.
 */

#ifndef JsonObject_h
#define JsonObject_h

#include <string> // For the text

namespace linesets
{
class JsonObject
{
public:
  /// Add a key in front of its value. Numbers that are not finite become null.
  void Add(const std::string& key, const std::string& value);
  void Add(const std::string& key, double value);
  void Add(const std::string& key, long long value);
  void Add(const std::string& key, int value) { this->Add(key, static_cast<long long>(value)); }

  /// The object, without a line end.
  std::string GetText() const { return "{" + this->Members + "}"; }

private:
  void AddRaw(const std::string& key, const std::string& value);
  std::string Members;
};
}

#endif
