// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/candidates_file.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/plane_curves_input.hpp>
#include <eliminant/io/results/json_fields.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>

namespace eliminant::io {

namespace {

using intersect::Candidate;

constexpr long largest_multiplicity = 1L << 40;

class JsonReader {
 public:
  JsonReader(const JsonDocument& document, const symbolic::Limits& limits) : fields_(document, limits) {}

  CandidatesFile read() const {
    const JsonValue& root = fields_.document().root();
    const bool list = root.kind == JsonValue::Kind::array;
    if (!list && root.kind != JsonValue::Kind::object)
      fields_.refuse(root, "the list of candidates", "an object with \"solutions\", or an array");
    CandidatesFile file;
    const JsonValue& solutions = list ? root : fields_.member(root, "solutions");
    for (const JsonValue& solution : fields_.array(solutions, "\"solutions\"")) {
      if (solution.kind != JsonValue::Kind::object) fields_.refuse(solution, "a solution", "an object with x and y");
      Candidate candidate;
      coordinate(solution, "x", candidate.x_real, candidate.x_imaginary);
      coordinate(solution, "y", candidate.y_real, candidate.y_imaginary);
      const JsonValue* multiplicity = solution.find("multiplicity");
      if (multiplicity != nullptr && multiplicity->kind != JsonValue::Kind::null)
        candidate.multiplicity =
            static_cast<unsigned long>(fields_.integer(*multiplicity, "\"multiplicity\"", 1, largest_multiplicity));
      file.candidates.push_back(std::move(candidate));
    }
    return file;
  }

 private:
  void coordinate(const JsonValue& solution, const std::string& name, symbolic::Rational& real,
                  symbolic::Rational& imaginary) const {
    const JsonValue& value = fields_.member(solution, name);
    const std::string what = "\"" + name + "\" of a solution";
    if (value.kind != JsonValue::Kind::array) {
      real = fields_.number(value, what);
      return;
    }
    if (value.elements.size() != 2)
      throw InvalidInput(what + " has " + std::to_string(value.elements.size()) + " parts", "[real, imaginary]",
                         fields_.document().place_of(value));
    real = fields_.number(value.elements[0], what);
    imaginary = fields_.number(value.elements[1], what);
  }

  JsonFields fields_;
};

/// One table; columns by name.
class CsvReader {
 public:
  CsvReader(const std::string& text, const symbolic::Limits& limits) : text_(text), limits_(limits) {}

  CandidatesFile read() {
    CandidatesFile file;
    std::istringstream lines(text_);
    std::string line;
    for (line_number_ = 1; std::getline(lines, line); ++line_number_) {
      if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
      const std::vector<std::string> cells = split_at_commas(line);
      if (columns_.empty() && read_header(cells)) continue;
      if (columns_.empty()) columns_without_header(cells.size());
      if (cells.size() != width_)
        throw InvalidInput("a row of " + std::to_string(cells.size()) + " cells", std::to_string(width_) + " cells",
                           {line_number_, 1});
      file.candidates.push_back(row(line, cells));
    }
    if (columns_.empty()) throw InvalidInput("the table of candidates is empty", "a header or a row", {1, 1});
    file.real_only = columns_.count("x") > 0;
    return file;
  }

 private:
  /// True when the line names columns.
  bool read_header(const std::vector<std::string>& cells) {
    const bool names =
        std::any_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell == "x" || cell == "x_re"; });
    if (!names) return false;
    width_ = cells.size();
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!columns_.emplace(cells[i], i).second)
        throw InvalidInput("the column " + cells[i].substr(0, 40) + " occurs twice", "different names",
                           {line_number_, 1});
    const bool real = columns_.count("x") > 0 && columns_.count("y") > 0;
    const bool complex = columns_.count("x_re") > 0 && columns_.count("x_im") > 0 && columns_.count("y_re") > 0 &&
                         columns_.count("y_im") > 0;
    if (real == complex)
      throw InvalidInput("the header names no two coordinates", "x,y or x_re,x_im,y_re,y_im", {line_number_, 1});
    return true;
  }

  void columns_without_header(std::size_t cells) {
    static const std::array<std::vector<std::string>, 4> layouts{{{"x", "y"},
                                                                  {"x", "y", "multiplicity"},
                                                                  {"x_re", "x_im", "y_re", "y_im"},
                                                                  {"x_re", "x_im", "y_re", "y_im", "multiplicity"}}};
    for (const auto& layout : layouts) {
      if (layout.size() != cells) continue;
      width_ = cells;
      for (std::size_t i = 0; i < cells; ++i) columns_[layout[i]] = i;
    }
    if (columns_.empty())
      throw InvalidInput("a row of " + std::to_string(cells) + " cells without a header", "2 to 5 cells: " + expected(),
                         {line_number_, 1});
  }

  static std::string expected() { return "x,y or x_re,x_im,y_re,y_im, and multiplicity"; }

  Candidate row(const std::string& line, const std::vector<std::string>& cells) const {
    const auto place_of = [&](std::size_t column) {
      std::size_t offset = 0;
      for (std::size_t i = 0; i < column; ++i) offset = line.find(',', offset) + 1;
      return SourcePlace{line_number_, line.find_first_not_of(" \t", offset) + 1};
    };
    const auto number = [&](const char* name) {
      const auto column = columns_.find(name);
      if (column == columns_.end()) return symbolic::Rational(0);
      const SourcePlace place = place_of(column->second);
      return symbolic::parse_number(cells[column->second], limits_, [place](std::size_t offset) {
        return SourcePlace{place.line, place.column + offset};
      });
    };
    Candidate candidate;
    const bool real = columns_.count("x") > 0;
    candidate.x_real = number(real ? "x" : "x_re");
    candidate.y_real = number(real ? "y" : "y_re");
    candidate.x_imaginary = number("x_im");
    candidate.y_imaginary = number("y_im");
    const auto column = columns_.find("multiplicity");
    if (column != columns_.end() && !cells[column->second].empty()) {
      const symbolic::Rational value = number("multiplicity");
      if (!value.is_integer() || value.sign() <= 0 || symbolic::Rational(largest_multiplicity) < value)
        throw InvalidInput("a multiplicity of " + cells[column->second].substr(0, 40), "a positive whole number",
                           place_of(column->second));
      candidate.multiplicity = static_cast<unsigned long>(fmpz_get_ui(value.numerator().get()));
    }
    return candidate;
  }

  const std::string& text_;
  const symbolic::Limits& limits_;
  std::size_t line_number_ = 0;
  std::size_t width_ = 0;
  std::map<std::string, std::size_t> columns_;
};

}  // namespace

CandidatesFile read_candidates(const std::string& text, const symbolic::Limits& limits) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && (text[first] == '{' || text[first] == '[')) {
    const JsonDocument document(text);
    return JsonReader(document, limits).read();
  }
  return CsvReader(text, limits).read();
}

}  // namespace eliminant::io
