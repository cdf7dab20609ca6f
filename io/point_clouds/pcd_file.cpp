// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/point_clouds/pcd_file.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/io/point_clouds/cloud_scalars.hpp>

namespace eliminant::io {

namespace {

struct Field {
  std::string name;
  ScalarType type = ScalarType::float32;
  std::size_t count = 1;
};

constexpr std::size_t most_values = 1000000;  // of one point

// The lines up to DATA; the lines of one file can have any order before it.
class Header {
 public:
  explicit Header(std::string_view bytes) : lines_(bytes) {
    std::string_view line;
    std::map<std::string, std::vector<std::string_view>, std::less<>> entries;
    while (data_.empty()) {
      if (!lines_.next(line)) refuse("the header does not end", "a line \"DATA ascii\" or \"DATA binary\"");
      const std::vector<std::string_view> words = words_of(line);
      if (words.empty() || words[0].starts_with('#')) continue;
      if (words[0] == "DATA")
        data_ = words.size() == 2 ? std::string(words[1]) : "nothing";
      else if (!entries.emplace(words[0], Words(words.begin() + 1, words.end())).second)
        refuse("there is a second line " + quoted_word(words[0]), "each entry of the header once");
    }
    if (data_ != "ascii" && data_ != "binary")
      refuse("the data are " + quoted_word(data_), "DATA ascii or DATA binary");
    read_fields(entries["FIELDS"], entries["SIZE"], entries["TYPE"], entries["COUNT"]);
    read_count(entries["POINTS"], entries["WIDTH"], entries["HEIGHT"]);
  }

  bool is_ascii() const { return data_ == "ascii"; }
  const std::vector<Field>& fields() const { return fields_; }
  std::size_t points() const { return points_; }
  const LineReader& lines() const { return lines_; }

 private:
  using Words = std::vector<std::string_view>;

  [[noreturn]] void refuse(const std::string& problem, const std::string& expected) const {
    refuse_cloud_line(std::max<std::size_t>(lines_.number(), 1), problem, expected);
  }

  void read_fields(const Words& names, const Words& sizes, const Words& types, const Words& counts) {
    if (names.empty() || sizes.size() != names.size() || types.size() != names.size() ||
        (!counts.empty() && counts.size() != names.size()))
      refuse("FIELDS, SIZE, TYPE and COUNT of the header do not have as many entries", "one of each for every field");
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto count = counts.empty() ? std::optional<std::size_t>(1) : count_in(counts[i]);
      if (!count || *count > most_values)
        refuse("COUNT holds no small whole numbers", "the number of values of each field");
      const bool axis = names[i] == "x" || names[i] == "y" || names[i] == "z";
      if (axis && std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
                      names.begin() + static_cast<std::ptrdiff_t>(i))
        refuse("there are two fields " + std::string(names[i]), "fields x, y and z, each once");
      fields_.push_back({std::string(names[i]), type(types[i], sizes[i]), *count});
    }
  }

  ScalarType type(std::string_view letter, std::string_view size) const {
    using Row = std::pair<std::string_view, ScalarType>;
    constexpr std::array<Row, 10> known{{{"I1", ScalarType::int8},
                                         {"U1", ScalarType::uint8},
                                         {"I2", ScalarType::int16},
                                         {"U2", ScalarType::uint16},
                                         {"I4", ScalarType::int32},
                                         {"U4", ScalarType::uint32},
                                         {"I8", ScalarType::int64},
                                         {"U8", ScalarType::uint64},
                                         {"F4", ScalarType::float32},
                                         {"F8", ScalarType::float64}}};
    const std::string word = std::string(letter) + std::string(size);
    for (const auto& [name, type] : known)
      if (word == name) return type;
    refuse("a field has TYPE and SIZE " + quoted_word(word), "I or U with 1, 2, 4 or 8, or F with 4 or 8");
  }

  // The whole number of an entry; nothing where there is no such entry.
  std::optional<std::size_t> number(const char* name, const Words& words) const {
    if (words.empty()) return std::nullopt;
    const auto count = words.size() == 1 ? count_in(words[0]) : std::nullopt;
    if (!count) refuse(std::string(name) + " is " + quoted_word(words[0]), "a whole number, not negative");
    return count;
  }

  void read_count(const Words& points, const Words& width, const Words& height) {
    const auto stated = number("POINTS", points);
    const auto columns = number("WIDTH", width);
    const auto rows = number("HEIGHT", height);
    if (!stated && (!columns || !rows))
      refuse("the header does not say how many points there are", "a line POINTS, or WIDTH and HEIGHT");
    if (columns && rows) {
      const std::string product = "WIDTH " + std::to_string(*columns) + " times HEIGHT " + std::to_string(*rows);
      if (*rows != 0 && *columns > SIZE_MAX / *rows) refuse(product + " is too large", "as many points as there are");
      if (stated && *stated != *columns * *rows)
        refuse(product + " is not POINTS " + std::to_string(*stated), "POINTS equal to WIDTH times HEIGHT");
    }
    points_ = stated ? *stated : *columns * *rows;
  }

  LineReader lines_;
  std::string data_;
  std::vector<Field> fields_;
  std::size_t points_ = 0;
};

// Where x, y and z stand in a point.
struct Place {
  std::size_t value = 0;  ///< number of values before it
  std::size_t byte = 0;   ///< their size
  ScalarType type = ScalarType::float32;
};

std::array<Place, 3> coordinates_of(const Header& header, std::size_t& values, std::size_t& bytes) {
  std::array<std::optional<Place>, 3> places;
  values = bytes = 0;
  for (const Field& field : header.fields()) {
    for (std::size_t k = 0; k < 3; ++k)
      if (field.name == std::array{"x", "y", "z"}[k] && field.count > 0) places[k] = Place{values, bytes, field.type};
    values += field.count;
    bytes += field.count * size_of(field.type);
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (!places[k])
      throw InvalidInput("there is no field " + std::string(std::array{"x", "y", "z"}[k]) + " in the header",
                         "fields x, y and z");
  return {*places[0], *places[1], *places[2]};
}

PointCloud read_ascii(const Header& header, const std::array<Place, 3>& places) {
  LineReader lines = header.lines();
  PointCloud cloud;
  for (std::size_t i = 0; i < header.points(); ++i) {
    std::string_view line;
    bool found = false;
    while (!found && lines.next(line)) found = line.find_first_not_of(" \t") != std::string_view::npos;
    if (!found)
      refuse_cloud_line(
          lines.number(),
          "the file ends after " + std::to_string(i) + " of " + std::to_string(header.points()) + " points",
          "as many lines as the header says");
    const std::vector<std::string_view> words = words_of(line);
    std::array<double, 3> point{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = places[k].value < words.size() ? double_in(words[places[k].value]) : std::nullopt;
      if (!number)
        refuse_cloud_line(
            lines.number(),
            std::string(std::array{"x", "y", "z"}[k]) +
                (places[k].value < words.size() ? " is " + quoted_word(words[places[k].value]) : " is missing"),
            "a line with one number for each field");
      point[k] = *number;
    }
    cloud.add(point);
  }
  return cloud;
}

PointCloud read_binary(const Header& header, std::string_view bytes, const std::array<Place, 3>& places,
                       std::size_t stride) {
  const std::size_t begin = std::min(header.lines().offset(), bytes.size());
  const std::size_t there = (bytes.size() - begin) / stride;
  if (there < header.points())
    refuse_cloud_byte(
        bytes.size(),
        "the file ends after " + std::to_string(there) + " of " + std::to_string(header.points()) + " points",
        "as much as the header says");
  PointCloud cloud;
  for (std::size_t i = 0; i < header.points(); ++i) {
    const char* const point = bytes.data() + begin + i * stride;
    cloud.add({scalar_at(point + places[0].byte, places[0].type, false),
               scalar_at(point + places[1].byte, places[1].type, false),
               scalar_at(point + places[2].byte, places[2].type, false)});
  }
  return cloud;
}

}  // namespace

PointCloud read_pcd(std::string_view bytes) {
  const Header header(bytes);
  std::size_t values = 0;
  std::size_t stride = 0;
  const auto places = coordinates_of(header, values, stride);
  return header.is_ascii() ? read_ascii(header, places) : read_binary(header, bytes, places, stride);
}

}  // namespace eliminant::io
