// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/point_clouds/ply_file.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/io/point_clouds/cloud_scalars.hpp>

namespace eliminant::io {

namespace {

enum class Encoding { ascii, little_endian, big_endian };

struct Property {
  std::string name;
  ScalarType type = ScalarType::float32;
  /// Of a list: the type of its length.
  std::optional<ScalarType> length_type;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

constexpr std::array<std::pair<const char*, ScalarType>, 16> type_names{{{"char", ScalarType::int8},
                                                                         {"int8", ScalarType::int8},
                                                                         {"uchar", ScalarType::uint8},
                                                                         {"uint8", ScalarType::uint8},
                                                                         {"short", ScalarType::int16},
                                                                         {"int16", ScalarType::int16},
                                                                         {"ushort", ScalarType::uint16},
                                                                         {"uint16", ScalarType::uint16},
                                                                         {"int", ScalarType::int32},
                                                                         {"int32", ScalarType::int32},
                                                                         {"uint", ScalarType::uint32},
                                                                         {"uint32", ScalarType::uint32},
                                                                         {"float", ScalarType::float32},
                                                                         {"float32", ScalarType::float32},
                                                                         {"double", ScalarType::float64},
                                                                         {"float64", ScalarType::float64}}};

// The lines up to end_header.
class Header {
 public:
  explicit Header(std::string_view bytes) : lines_(bytes) {
    std::string_view line;
    lines_.next(line);
    while (true) {
      if (!lines_.next(line)) refuse("the header does not end", "a line end_header");
      const std::vector<std::string_view> words = words_of(line);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      read_line(words);
    }
    if (!encoding_) refuse("the header names no format", "a line \"format ascii 1.0\" or with binary_little_endian");
  }

  Encoding encoding() const { return *encoding_; }
  const std::vector<Element>& elements() const { return elements_; }
  std::size_t size() const { return lines_.offset(); }
  std::size_t lines() const { return lines_.number(); }

 private:
  [[noreturn]] void refuse(const std::string& problem, const std::string& expected) const {
    refuse_cloud_line(std::max<std::size_t>(lines_.number(), 1), problem, expected);
  }

  void read_line(const std::vector<std::string_view>& words) {
    if (words[0] == "format")
      read_format(words);
    else if (words[0] == "element")
      read_element(words);
    else if (words[0] == "property")
      read_property(words);
    else
      refuse("unknown word " + quoted_word(words[0]) + " in the header",
             "format, comment, element, property or end_header");
  }

  void read_format(const std::vector<std::string_view>& words) {
    constexpr std::array names{"ascii", "binary_little_endian", "binary_big_endian"};
    const auto found = words.size() == 3 ? std::find(names.begin(), names.end(), words[1]) : names.end();
    if (found == names.end() || words[2] != "1.0")
      refuse("unknown format", "ascii, binary_little_endian or binary_big_endian, and 1.0");
    encoding_ = static_cast<Encoding>(found - names.begin());
  }

  void read_element(const std::vector<std::string_view>& words) {
    if (words.size() != 3) refuse("an element without its name and number", "a line such as \"element vertex 1000\"");
    const auto count = count_in(words[2]);
    if (!count)
      refuse("the number of elements " + quoted_word(words[1]) + " is " + quoted_word(words[2]),
             "a whole number, not negative");
    const bool known = std::any_of(elements_.begin(), elements_.end(),
                                   [&](const Element& element) { return element.name == words[1]; });
    if (known) refuse("there is a second element " + quoted_word(words[1]), "each element once");
    elements_.push_back({std::string(words[1]), *count, {}});
  }

  ScalarType type(std::string_view word) const {
    for (const auto& [name, type] : type_names)
      if (word == name) return type;
    refuse("unknown type " + quoted_word(word), "a type of PLY, such as float or double");
  }

  void read_property(const std::vector<std::string_view>& words) {
    const bool list = words.size() == 5 && words[1] == "list";
    if (elements_.empty() || (words.size() != 3 && !list))
      refuse("a property that belongs to nothing or has no name", "a line such as \"property float x\"");
    Property property{std::string(words.back()), type(words[words.size() - 2]), std::nullopt};
    if (list) {
      property.length_type = type(words[2]);
      if (*property.length_type == ScalarType::float32 || *property.length_type == ScalarType::float64)
        refuse("the length of a list is no whole number", "a type such as uchar");
    }
    std::vector<Property>& properties = elements_.back().properties;
    const bool axis = property.name == "x" || property.name == "y" || property.name == "z";
    const bool known = std::any_of(properties.begin(), properties.end(),
                                   [&](const Property& other) { return other.name == property.name; });
    if (axis && known)
      refuse("there is a second property " + property.name + " of " + quoted_word(elements_.back().name),
             "properties x, y and z, each once");
    properties.push_back(std::move(property));
  }

  LineReader lines_;
  std::optional<Encoding> encoding_;
  std::vector<Element> elements_;
};

// Which properties of the vertices are x, y and z.
std::array<std::size_t, 3> coordinates_of(const Element& vertex) {
  std::array<std::size_t, 3> places{};
  for (std::size_t k = 0; k < 3; ++k) {
    const char* const name = std::array{"x", "y", "z"}[k];
    const auto found = std::find_if(vertex.properties.begin(), vertex.properties.end(),
                                    [&](const Property& p) { return p.name == name && !p.length_type; });
    if (found == vertex.properties.end())
      throw InvalidInput("the vertices have no property " + std::string(name), "properties x, y and z");
    places[k] = static_cast<std::size_t>(found - vertex.properties.begin());
  }
  return places;
}

const Element& vertices_of(const Header& header) {
  for (const Element& element : header.elements())
    if (element.name == "vertex") return element;
  throw InvalidInput("there is no element vertex in the header", "a line such as \"element vertex 1000\"");
}

class AsciiBody {
 public:
  AsciiBody(std::string_view bytes, const Header& header)
      : lines_(bytes.substr(std::min(header.size(), bytes.size()))), lines_before_(header.lines()) {}

  PointCloud read(const Header& header) {
    for (const Element& element : header.elements()) {
      if (element.name == "vertex") return read_vertices(element);
      for (std::size_t i = 0; i < element.count; ++i) next_line(element, i);
    }
    return {};
  }

 private:
  std::string_view next_line(const Element& element, std::size_t i) {
    std::string_view line;
    while (lines_.next(line))
      if (line.find_first_not_of(" \t") != std::string_view::npos) return line;
    refuse_cloud_line(lines_before_ + lines_.number(),
                      "the file ends after " + std::to_string(i) + " of " + std::to_string(element.count) +
                          " lines of " + element.name,
                      "as many lines as the header says");
  }

  PointCloud read_vertices(const Element& vertex) {
    const auto places = coordinates_of(vertex);
    PointCloud cloud;
    for (std::size_t i = 0; i < vertex.count; ++i) {
      const std::vector<std::string_view> words = words_of(next_line(vertex, i));
      cloud.add(point(vertex, words, places));
    }
    return cloud;
  }

  std::array<double, 3> point(const Element& vertex, const std::vector<std::string_view>& words,
                              const std::array<std::size_t, 3>& places) const {
    std::array<double, 3> point{};
    std::size_t at = 0;
    for (std::size_t p = 0; p < vertex.properties.size(); ++p) {
      if (at >= words.size()) refuse("the property " + vertex.properties[p].name + " is missing");
      const auto axis = std::find(places.begin(), places.end(), p);
      if (axis != places.end()) {
        const auto number = double_in(words[at]);
        if (!number) refuse(vertex.properties[p].name + " is " + quoted_word(words[at]));
        point[static_cast<std::size_t>(axis - places.begin())] = *number;
      }
      const auto length = vertex.properties[p].length_type ? count_in(words[at]) : std::optional<std::size_t>(0);
      if (!length || *length > words.size()) refuse("the list " + vertex.properties[p].name + " has no right length");
      at += 1 + *length;
    }
    return point;
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    refuse_cloud_line(lines_before_ + lines_.number(), problem, "a line with one number for each property");
  }

  LineReader lines_;
  std::size_t lines_before_;
};

class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, const Header& header)
      : bytes_(bytes), at_(header.size()), big_endian_(header.encoding() == Encoding::big_endian) {}

  PointCloud read(const Header& header) {
    for (const Element& element : header.elements()) {
      const bool vertices = element.name == "vertex";
      PointCloud cloud;
      const auto places = vertices ? coordinates_of(element) : std::array<std::size_t, 3>{};
      // Elements without properties take no bytes.
      const std::size_t count = element.properties.empty() ? 0 : element.count;
      for (std::size_t i = 0; i < count; ++i) {
        const std::array<double, 3> point = read_one(element, i, places);
        if (vertices) cloud.add(point);
      }
      if (vertices) return cloud;
    }
    return {};
  }

 private:
  std::array<double, 3> read_one(const Element& element, std::size_t i, const std::array<std::size_t, 3>& places) {
    std::array<double, 3> point{};
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Property& property = element.properties[p];
      if (property.length_type) {
        const double length = take(*property.length_type, element, i);
        const double most = static_cast<double>(bytes_.size() - at_) / static_cast<double>(size_of(property.type));
        if (length < 0 || length > most) refuse_end(element, i);
        at_ += static_cast<std::size_t>(length) * size_of(property.type);
        continue;
      }
      const double value = take(property.type, element, i);
      for (std::size_t k = 0; k < 3; ++k)
        if (places[k] == p) point[k] = value;
    }
    return point;
  }

  double take(ScalarType type, const Element& element, std::size_t i) {
    const std::size_t size = size_of(type);
    if (bytes_.size() < at_ || bytes_.size() - at_ < size) refuse_end(element, i);
    const double value = scalar_at(bytes_.data() + at_, type, big_endian_);
    at_ += size;
    return value;
  }

  [[noreturn]] void refuse_end(const Element& element, std::size_t i) const {
    refuse_cloud_byte(
        bytes_.size(),
        "the file ends inside " + element.name + " " + std::to_string(i + 1) + " of " + std::to_string(element.count),
        "as much as the header says");
  }

  std::string_view bytes_;
  std::size_t at_;
  bool big_endian_;
};

void append(std::string& out, std::uint64_t bits, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out += static_cast<char>((bits >> (8 * i)) & 0xFFU);
}

// Colors far from each other: steps of the golden angle around the circle of hues.
std::array<unsigned, 3> color_of(std::int32_t label) {
  if (label < 0) return {128, 128, 128};
  std::array<unsigned, 3> color{};
  const double hue = std::fmod(0.618033988749895 * label, 1.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = std::fmod(6 * hue + 4 * static_cast<double>(k), 6.0);
    const double level = std::clamp(std::abs(at - 3) - 1, 0.0, 1.0);
    color[k] = static_cast<unsigned>(40 + 200 * level);
  }
  return color;
}

}  // namespace

PointCloud read_ply(std::string_view bytes) {
  const Header header(bytes);
  coordinates_of(vertices_of(header));
  if (header.encoding() == Encoding::ascii) return AsciiBody(bytes, header).read(header);
  return BinaryBody(bytes, header).read(header);
}

std::string labelled_ply(std::span<const std::array<double, 3>> points, std::span<const std::int32_t> labels) {
  std::string out =
      "ply\nformat binary_little_endian 1.0\ncomment label: index of the cylinder, -1 for none\nelement vertex " +
      std::to_string(points.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty int label\nend_header\n";
  out.reserve(out.size() + 31 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double x : points[i]) append(out, std::bit_cast<std::uint64_t>(x), 8);
    for (const unsigned level : color_of(labels[i])) append(out, level, 1);
    append(out, static_cast<std::uint32_t>(labels[i]), 4);
  }
  return out;
}

}  // namespace eliminant::io
