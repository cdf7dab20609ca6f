// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/cylinder_extraction_input.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/io/point_clouds/point_cloud_file.hpp>

namespace eliminant::io {

namespace {

constexpr const char* a_length = "a positive number in the unit of the points";

double nearest(const symbolic::Rational& value) {
  bridge::RealBall ball;
  arb_set_fmpq(ball.get(), value.get(), 64);
  return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
}

std::optional<double> number(const JsonFields& fields, const JsonValue& problem, const char* name,
                             const char* expected) {
  const JsonValue* const value = problem.find(name);
  if (value == nullptr) return std::nullopt;
  const std::string what = "\"" + std::string(name) + "\"";
  const symbolic::Rational exact = named(what, [&] { return fields.number(*value, what); });
  const double rounded = nearest(exact);
  if (!(rounded > 0) || !std::isfinite(rounded))
    throw InvalidInput(what + " is " + value->text.substr(0, 40), expected, fields.document().place_of(*value));
  return rounded;
}

PointCloud read_cloud(const JsonFields& fields, const JsonValue& value, const std::string& folder) {
  const std::string& name = fields.text(value, "\"cloud\"");
  // A name with a zero byte would be cut there.
  if (name.empty() || name.find('\0') != std::string::npos)
    throw InvalidInput("\"cloud\" is no name of a file", "the path of a point cloud",
                       fields.document().place_of(value));
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  const SourcePlace place = fields.document().place_of(value);
  try {
    return read_point_cloud_file(path.string());
  } catch (const InvalidInput& error) {
    throw InvalidInput(error.what(), error.expected(), place);
  } catch (const LimitReached& limit) {
    throw LimitReached(limit.what(), place);
  }
}

}  // namespace

intersect::CylinderExtractionProblem read_cylinder_extraction(const JsonFields& fields, const JsonValue& problem,
                                                              const std::string& folder) {
  intersect::CylinderExtractionProblem result;
  const JsonValue& cloud = fields.member(problem, "cloud", "the path of a point cloud");
  fields.member(problem, "distance", a_length);
  result.distance = *number(fields, problem, "distance", a_length);
  result.min_radius = number(fields, problem, "min_radius", a_length);
  result.max_radius = number(fields, problem, "max_radius", a_length);
  if (result.min_radius && result.max_radius && *result.min_radius > *result.max_radius)
    throw InvalidInput("\"min_radius\" is larger than \"max_radius\"", "min_radius <= max_radius",
                       fields.document().place_of(*problem.find("min_radius")));
  if (const JsonValue* const value = problem.find("min_inliers"))
    result.min_inliers =
        static_cast<std::size_t>(fields.integer(*value, "\"min_inliers\"", 5, std::numeric_limits<long>::max()));
  if (const JsonValue* const value = problem.find("confidence")) {
    constexpr const char* between = "a number between 0 and 1, such as 0.99";
    result.confidence = *number(fields, problem, "confidence", between);
    if (result.confidence >= 1)
      throw InvalidInput("\"confidence\" is not below 1", between, fields.document().place_of(*value));
  }
  PointCloud points = read_cloud(fields, cloud, folder);
  result.cloud = cloud.text;
  result.points = std::move(points.points);
  if (points.dropped > 0)
    result.warnings.push_back(std::to_string(points.dropped) + " of " +
                              std::to_string(points.dropped + result.points.size()) +
                              " points of the cloud are not finite and were left out");
  return result;
}

}  // namespace eliminant::io
