// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JsonObject.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace linesets
{
namespace
{
std::string Quote(const std::string& text)
{
  std::ostringstream out;
  out << '"';
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      out << '\\' << c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      out << "\\u" << std::hex << std::setw(4) << std::setfill('0') << static_cast<int>(c);
    }
    else
    {
      out << c;
    }
  }
  out << '"';
  return out.str();
}
}

//------------------------------------------------------------------------------
void JsonObject::AddRaw(const std::string& key, const std::string& value)
{
  this->Members += (this->Members.empty() ? "" : ", ") + Quote(key) + ": " + value;
}

//------------------------------------------------------------------------------
void JsonObject::Add(const std::string& key, const std::string& value)
{
  this->AddRaw(key, Quote(value));
}

//------------------------------------------------------------------------------
void JsonObject::Add(const std::string& key, double value)
{
  if (!std::isfinite(value))
  {
    this->AddRaw(key, "null");
    return;
  }
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(6) << value;
  this->AddRaw(key, out.str());
}

//------------------------------------------------------------------------------
void JsonObject::Add(const std::string& key, long long value)
{
  this->AddRaw(key, std::to_string(value));
}
}
