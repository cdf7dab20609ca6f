// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/surface_result_text.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <eliminant/io/results/surface_result_words.hpp>
#include <eliminant/io/results/text_sections.hpp>
#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::BranchEnd;
using intersect::BranchEndKind;
using intersect::SurfaceComponent;
using intersect::SurfaceComponentKind;
using intersect::SurfaceResult;
using intersect::SurfaceSingularPoint;
using Rows = std::vector<std::vector<std::string>>;

std::string status_line(const SurfaceResult& result) {
  if (result.limit) return "Status: incomplete: " + *result.limit + "\n";
  switch (result.status) {
    case intersect::Status::certified:
      return "Status: certified: every component found, of the kind said, none missing\n";
    case intersect::Status::infinite:
      return std::string("Status: infinite: the surfaces have a part in common\n") +
             (result.rest_status == intersect::Status::certified
                  ? "Rest:   certified: every component found, of the kind said, none missing\n"
                  : "Rest:   numeric: not proven complete\n");
    case intersect::Status::incomplete:
      return "Status: incomplete: what was found so far\n";
    case intersect::Status::numeric:
      break;
  }
  return "Status: numeric: computed, not proven complete\n";
}

std::string summary(const SurfaceResult& result) {
  const intersect::SurfaceCounts& counts = result.counts;
  Rows rows;
  const auto add = [&](unsigned long count, const char* one, const char* many) {
    rows.push_back({std::to_string(count), count == 1 ? one : many});
  };
  add(counts.curves, "curve from end to end", "curves from end to end");
  add(counts.loops, "closed curve", "closed curves");
  add(counts.points, "point on its own", "points on their own");
  if (counts.overlaps > 0) add(counts.overlaps, "common part of both surfaces", "common parts of both surfaces");
  add(counts.singular, "singular point", "singular points");
  if (counts.excluded > 0)
    add(counts.excluded, "real part of the projection excluded: its other parameters are complex or infinite",
        "real parts of the projection excluded: their other parameters are complex or infinite");
  return (result.problem == "self_intersection" ? "\nThe surface meets itself in\n" : "\nThe surfaces meet in\n") +
         text_table(rows, {true, false});
}

std::string size_text(const symbolic::Polynomial& p) {
  return "bidegree (" + std::to_string(p.degree(0)) + ", " + std::to_string(p.degree(1)) + "), total degree " +
         std::to_string(p.total_degree()) + ", " + counted(p.term_count(), "term");
}

std::string projection_text(const SurfaceResult& result, bool equation) {
  if (!result.projection) return "";
  const auto& [variables, eliminant] = *result.projection;
  std::string text =
      "\nEliminant D(" + variables[0] + ", " + variables[1] + "): " + size_text(eliminant.divisor) + "\n";
  if (eliminant.vanishing != symbolic::DeterminantVanishing::no)
    text += "The determinant vanishes: " + std::string(explanation(eliminant.vanishing)) + "\n";
  Rows rows{{"multiplicity", "factor, and what is above it"}};
  for (const symbolic::EliminantComponent& component : eliminant.components)
    rows.push_back({std::to_string(component.multiplicity),
                    (equation ? symbolic::to_string(component.factor, variables) : size_text(component.factor)) + ": " +
                        std::string(explanation(component.kind)) + (component.proven ? "" : " (not proven)")});
  if (rows.size() > 1) text += text_table(rows, {true, false});
  if (equation) text += "\nD = " + symbolic::to_string(eliminant.divisor, variables) + "\n";
  return text;
}

std::string end_text(const SurfaceComponent& component, const BranchEnd& end) {
  if (component.kind != SurfaceComponentKind::curve) return "-";
  if (end.kind == BranchEndKind::singular && end.singular_point)
    return "singular point " + std::to_string(*end.singular_point);
  if (end.kind != BranchEndKind::border) return end.kind == BranchEndKind::infinity ? "infinity" : "unknown";
  std::string text;
  for (const std::string& word : border_words(end)) text += (text.empty() ? "" : " ") + word;
  return text + ", " + word_for(end.transition);
}

// Eight digits are enough to look at; the other formats have all.
std::string short_number(double value) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.8g", value == 0 ? 0.0 : value);
  return text.data();
}

std::string bound_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", value);
  return text.data();
}

std::string component_table(const SurfaceResult& result) {
  if (result.components.empty()) return "";
  const auto any = [&](auto holds) { return std::any_of(result.components.begin(), result.components.end(), holds); };
  const bool tangential = any([](const SurfaceComponent& c) { return c.tangential; });
  const bool mirrored = any([](const SurfaceComponent& c) { return c.mirrored; });
  const bool splines = any([](const SurfaceComponent& c) { return c.spline.has_value(); });
  Rows rows{{"#", "kind", "points", "from", "to", "error"}};
  if (tangential) rows[0].emplace_back("tangential");
  if (mirrored) rows[0].emplace_back("mirrored");
  if (splines) rows[0].emplace_back("spline");
  rows[0].emplace_back("certified");
  for (std::size_t i = 0; i < result.components.size(); ++i) {
    const SurfaceComponent& component = result.components[i];
    std::vector<std::string> row{std::to_string(i),
                                 word_for(component.kind),
                                 std::to_string(component.points.size()),
                                 end_text(component, component.start),
                                 end_text(component, component.end),
                                 bound_text(component.error)};
    if (tangential) row.emplace_back(component.tangential ? "yes" : "no");
    if (mirrored) row.emplace_back(component.mirrored ? "yes" : "no");
    if (splines)
      row.push_back(component.spline ? std::to_string(component.spline->control_points.size()) + " points, error " +
                                           bound_text(component.spline->error)
                                     : "-");
    row.emplace_back(component.certified ? "yes" : "no");
    rows.push_back(std::move(row));
  }
  return "\nComponents\n" + text_table(rows, {true, false, true});
}

// What stands in each row, then the columns of parameters and coordinates of points.
template <class Points, class At>
void add_columns(Rows& rows, const Points& points, At at) {
  const auto add = [&](const std::string& name, std::size_t index) {
    std::vector<std::string> numbers;
    for (const auto& point : points) numbers.push_back(short_number(values_of(at(point))[index]));
    const std::vector<std::string> column = number_column(name, std::move(numbers));
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(column[i]);
  };
  for (std::size_t i = 0; i < parameter_names.size(); ++i) add(parameter_names[i], i);
  for (std::size_t i = 0; i < coordinate_names.size(); ++i) add(coordinate_names[i], parameter_names.size() + i);
}

std::string singular_table(const SurfaceResult& result) {
  if (result.singular_points.empty()) return "";
  Rows rows{{"#", "kind"}};
  for (std::size_t i = 0; i < result.singular_points.size(); ++i)
    rows.push_back({std::to_string(i), word_for(result.singular_points[i].kind)});
  add_columns(rows, result.singular_points, [](const SurfaceSingularPoint& point) { return point.at; });
  rows[0].insert(rows[0].end(), {"half-branches", "radius", "certified"});
  for (std::size_t i = 0; i < result.singular_points.size(); ++i) {
    const SurfaceSingularPoint& point = result.singular_points[i];
    rows[i + 1].insert(rows[i + 1].end(),
                       {std::to_string(point.half_branches), bound_text(point.radius), point.certified ? "yes" : "no"});
  }
  return "\nSingular points\n" + text_table(rows, {true});
}

std::string contact_table(const SurfaceResult& result) {
  std::vector<intersect::SurfacePoint> points;
  Rows rows{{"#"}};
  for (std::size_t i = 0; i < result.components.size(); ++i) {
    const SurfaceComponent& component = result.components[i];
    if (component.kind != SurfaceComponentKind::point || component.points.empty()) continue;
    points.push_back(component.points.front());
    rows.push_back({std::to_string(i)});
  }
  if (points.empty()) return "";
  add_columns(rows, points, [](const intersect::SurfacePoint& point) { return point; });
  return "\nPoints on their own\n" + text_table(rows, {true});
}

template <class Items>
std::string reasons(const Items& items, const std::string& of) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!items[i].certified && !items[i].reason.empty())
      text += "Not certified: " + of + " " + std::to_string(i) + ": " + items[i].reason + "\n";
  return text;
}

}  // namespace

std::string surface_result_text(const SurfaceResult& result, const RunOptions& options) {
  std::string text = status_line(result) + summary(result) + given_and_used(result.engine, options);
  text += projection_text(result, options.solve.equation) + component_table(result) + contact_table(result);
  text += singular_table(result);
  text += reasons(result.components, "component") + reasons(result.singular_points, "singular point");
  return text + "\n" + seconds_line(result.seconds);
}

}  // namespace eliminant::io
