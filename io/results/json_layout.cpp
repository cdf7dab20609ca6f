// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/json_layout.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

std::string quoted(const std::string& text) { return Json(text).dump(); }

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

// Gives up, and returns false, when `out` is longer than `limit`.
bool write_line(const Json& value, std::size_t limit, std::string& out) {
  if (!value.is_structured()) {
    out += value.dump();
    return out.size() <= limit;
  }
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, element] : value.items()) {
    if (!first) out += ", ";
    first = false;
    if (value.is_object()) out += quoted(key) + ": ";
    if (!write_line(element, limit, out)) return false;
  }
  out += value.is_object() ? '}' : ']';
  return out.size() <= limit;
}

void write(const Json& value, std::size_t width, std::size_t indent, std::string& out) {
  // The outermost value is always broken: its fields are what people look for.
  const bool breakable = value.is_structured() && !value.empty();
  const std::size_t limit = !breakable ? unlimited : indent > 0 && indent < width ? width - indent : 0;
  std::string line;
  if (limit > 0 && write_line(value, limit, line)) {
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
  write_line(value, unlimited, out);
  return out;
}

std::string json_on_one_line(const std::string& layout) {
  std::string out;
  out.reserve(layout.size());
  // A line break inside a text is escaped: each one is of the layout, and follows a comma where json_line has a blank.
  for (std::size_t begin = 0; begin < layout.size();) {
    const std::size_t end = std::min(layout.find('\n', begin), layout.size());
    const std::size_t indented = std::min(layout.find_first_not_of(' ', begin), end);
    if (!out.empty() && out.back() == ',') out += ' ';
    out.append(layout, indented, end - indented);
    begin = end + 1;
  }
  return out;
}

}  // namespace eliminant::io
