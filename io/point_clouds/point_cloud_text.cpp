// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/point_clouds/point_cloud_text.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/io/point_clouds/cloud_scalars.hpp>

namespace eliminant::io {

namespace {

constexpr std::array axis_names{"x", "y", "z"};
constexpr const char* three_numbers = "three numbers x, y and z";

std::string_view trimmed(std::string_view word) {
  const std::size_t first = word.find_first_not_of(" \t\"");
  if (first == std::string_view::npos) return {};
  return word.substr(first, word.find_last_not_of(" \t\"") - first + 1);
}

// Reads lines whose fields one character separates, or blanks.
class TextCloud {
 public:
  explicit TextCloud(std::string_view text) : lines_(text) {}

  PointCloud read() {
    PointCloud cloud;
    std::string_view line;
    while (lines_.next(line)) {
      line = trimmed(line);
      if (line.empty() || line.starts_with('#') || line.starts_with("//")) continue;
      if (line.find('\0') != std::string_view::npos) refuse("a zero byte", "text, or the formats PLY and PCD");
      if (first_) {
        first_ = false;
        choose_separator(line);
        if (is_heading(line)) continue;
      }
      cloud.add(point(line));
      ++rows_;
    }
    if (count_ && *count_ != rows_)
      throw InvalidInput("the first line says " + std::to_string(*count_) + " points, and " + std::to_string(rows_) +
                             (rows_ == 1 ? " follows" : " follow"),
                         "as many lines as points, or no first line with their number");
    if (first_) throw InvalidInput("there are no points in it", "a point cloud: XYZ, CSV, PLY or PCD");
    return cloud;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem, const std::string& expected) const {
    refuse_cloud_line(lines_.number(), problem, expected);
  }

  void choose_separator(std::string_view line) {
    for (const char separator : {';', ',', '\t'})
      if (separator_ == ' ' && line.find(separator) != std::string_view::npos) separator_ = separator;
    // Tabs are blanks where they separate numbers; only in CSV an empty field means something.
    if (separator_ == '\t') separator_ = ' ';
  }

  std::vector<std::string_view> fields(std::string_view line) const {
    if (separator_ == ' ') return words_of(line);
    std::vector<std::string_view> fields;
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find(separator_, at), line.size());
      fields.push_back(trimmed(line.substr(at, end - at)));
      at = end + 1;
    }
    return fields;
  }

  // Names of columns, or the number of points.
  bool is_heading(std::string_view line) {
    const std::vector<std::string_view> words = fields(line);
    if (words.size() == 1 && (count_ = count_in(words[0]))) return true;
    if (std::any_of(words.begin(), words.end(), [](std::string_view word) { return double_in(word).has_value(); }))
      return false;
    const auto begins_as_number = [](std::string_view word) {
      const std::size_t at = word.find_first_not_of("+-.");
      return at != std::string_view::npos && at < 3 && word[at] >= '0' && word[at] <= '9';
    };
    if (std::all_of(words.begin(), words.end(), begins_as_number))
      refuse("there is no number: " + quoted_word(words[0]), "a decimal number of the size of a double");
    for (std::size_t k = 0; k < 3; ++k) {
      const auto is_axis = [&](std::string_view word) {
        return word.size() == 1 && (word[0] | 0x20) == axis_names[k][0];
      };
      const auto found = std::find_if(words.begin(), words.end(), is_axis);
      if (found == words.end())
        refuse("there is no column " + std::string(axis_names[k]) + " among the names " + quoted_word(line),
               "columns x, y and z, or lines of three numbers without names");
      if (std::find_if(found + 1, words.end(), is_axis) != words.end())
        refuse("there are two columns " + std::string(axis_names[k]) + " among the names " + quoted_word(line),
               "one column of each name");
      columns_[k] = static_cast<std::size_t>(found - words.begin());
    }
    return true;
  }

  std::array<double, 3> point(std::string_view line) const {
    const std::vector<std::string_view> words = fields(line);
    std::array<double, 3> point{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string axis = axis_names[k];
      if (columns_[k] >= words.size())
        refuse("there are only " + std::to_string(words.size()) + " fields, " + axis + " is missing", three_numbers);
      const std::optional<double> number = double_in(words[columns_[k]]);
      if (!number) refuse(axis + " is " + quoted_word(words[columns_[k]]), "a decimal number of the size of a double");
      point[k] = *number;
    }
    return point;
  }

  LineReader lines_;
  bool first_ = true;
  /// As the first line says.
  std::optional<std::size_t> count_;
  std::size_t rows_ = 0;
  char separator_ = ' ';
  std::array<std::size_t, 3> columns_{0, 1, 2};
};

}  // namespace

PointCloud read_text_cloud(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return TextCloud(text).read();
}

}  // namespace eliminant::io
