// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinder_extraction_json.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/results/cylinder_extraction_words.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/result_fields.hpp>

namespace eliminant::io {

std::string cylinder_extraction_json(const intersect::CylinderExtractionResult& result,
                                     const std::optional<ProblemId>& id, long digits) {
  using Json = nlohmann::ordered_json;
  const auto number = [&](double value) { return measured_text(value, digits); };
  const auto vector = [&](const std::array<double, 3>& v) {
    return Json::array({number(v[0]), number(v[1]), number(v[2])});
  };
  Json out = result_heading(result.problem, id, result.status, {}, result.limit);
  out["cloud"] = result.cloud;
  out["counts"] = {{"points", result.counts.points},
                   {"cylinders", result.counts.cylinders},
                   {"on_cylinders", result.counts.on_cylinders}};
  out["cylinders"] = Json::array();
  for (const intersect::ExtractedCylinder& cylinder : result.cylinders) {
    Json entry;
    entry["direction"] = vector(cylinder.direction);
    entry["axis_point"] = vector(cylinder.axis_point);
    entry["radius"] = number(cylinder.radius);
    entry["length"] = number(cylinder.length);
    entry["inliers"] = cylinder.inliers;
    entry["residual"] = measured_text(cylinder.residual, std::min(digits, 6L));
    out["cylinders"].push_back(std::move(entry));
  }
  out["engine"] = {{"method", "five-point samples"},
                   {"distance", number(result.distance)},
                   {"min_radius", number(result.min_radius)},
                   {"max_radius", number(result.max_radius)},
                   {"min_inliers", result.min_inliers},
                   {"confidence", measured_text(result.confidence, 4)},
                   {"samples", result.counts.samples},
                   {"candidates", result.counts.candidates},
                   {"seed", result.seed}};
  out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
