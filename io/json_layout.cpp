// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/json_layout.hpp>

#include <nlohmann/json.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

std::string quoted(const std::string& text) { return Json(text).dump(); }

void write_line(const Json& value, std::string& out) {
  if (!value.is_structured()) {
    out += value.dump();
    return;
  }
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, element] : value.items()) {
    if (!first) out += ", ";
    first = false;
    if (value.is_object()) out += quoted(key) + ": ";
    write_line(element, out);
  }
  out += value.is_object() ? '}' : ']';
}

void write(const Json& value, std::size_t width, std::size_t indent, std::string& out) {
  std::string line;
  write_line(value, line);
  // The outermost value is always broken: its fields are what people look for.
  if (!value.is_structured() || value.empty() || (indent > 0 && indent + line.size() <= width)) {
    out += line;
    return;
  }
  out += value.is_object() ? "{\n" : "[\n";
  bool first = true;
  for (const auto& [key, element] : value.items()) {
    if (!first) out += ",\n";
    first = false;
    out.append(indent + 1, ' ');
    if (value.is_object()) out += quoted(key) + ": ";
    write(element, width, indent + 1, out);
  }
  out += '\n';
  out.append(indent, ' ');
  out += value.is_object() ? '}' : ']';
}

}  // namespace

std::string json_layout(const nlohmann::ordered_json& value, std::size_t width) {
  std::string out;
  write(value, width, 0, out);
  return out + "\n";
}

std::string json_line(const nlohmann::ordered_json& value) {
  std::string out;
  write_line(value, out);
  return out;
}

}  // namespace eliminant::io
