// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinder_extraction_text.hpp>

#include <vector>

#include <eliminant/io/results/cylinder_extraction_words.hpp>
#include <eliminant/io/results/text_sections.hpp>
#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::CylinderExtractionResult;
using intersect::ExtractedCylinder;

std::string short_text(double value) { return measured_text(value, 5); }

std::string summary(const CylinderExtractionResult& result) {
  const auto number = [](std::size_t value) { return std::to_string(value); };
  const std::size_t elsewhere = result.counts.points - result.counts.on_cylinders;
  return "\nCloud " + result.cloud + "\n" +
         text_table({{number(result.counts.points), "points"},
                     {"= " + number(result.counts.on_cylinders), "on " + counted(result.counts.cylinders, "cylinder")},
                     {"+ " + number(elsewhere), "elsewhere"}},
                    {true, false}) +
         "\nLooked for: radius " + short_text(result.min_radius) + " to " + short_text(result.max_radius) + ", " +
         number(result.min_inliers) + " points or more within " + short_text(result.distance) + "\n";
}

std::string cylinder_table(const CylinderExtractionResult& result) {
  if (result.cylinders.empty()) return "\nNo cylinder was found.\n";
  std::vector<std::vector<std::string>> rows(result.cylinders.size() + 1);
  const auto add = [&](std::vector<std::string> column) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(column[i]);
  };
  const auto add_numbers = [&](const std::string& name, auto value_of) {
    std::vector<std::string> numbers;
    for (const ExtractedCylinder& cylinder : result.cylinders) numbers.push_back(value_of(cylinder));
    add(number_column(name, std::move(numbers)));
  };
  std::vector<std::string> index{"#"};
  for (std::size_t i = 1; i < rows.size(); ++i) index.push_back(std::to_string(i));
  add(std::move(index));
  const auto vector_text = [](const std::array<double, 3>& v) {
    return "(" + short_text(v[0]) + ", " + short_text(v[1]) + ", " + short_text(v[2]) + ")";
  };
  add_numbers("direction", [&](const ExtractedCylinder& c) { return vector_text(c.direction); });
  add_numbers("middle of the axis", [&](const ExtractedCylinder& c) { return vector_text(c.axis_point); });
  add_numbers("radius", [](const ExtractedCylinder& c) { return short_text(c.radius); });
  add_numbers("length", [](const ExtractedCylinder& c) { return short_text(c.length); });
  add_numbers("points", [](const ExtractedCylinder& c) { return std::to_string(c.inliers); });
  add_numbers("residual", [](const ExtractedCylinder& c) { return measured_text(c.residual, 3); });
  return "\n" + text_table(rows, {true, false, false, false, false, true, false});
}

}  // namespace

std::string cylinder_extraction_text(const CylinderExtractionResult& result) {
  return status_lines(result.status, {}, result.limit, "") + summary(result) + seconds_line(result.seconds) +
         cylinder_table(result);
}

}  // namespace eliminant::io
