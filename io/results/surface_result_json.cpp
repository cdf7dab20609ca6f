// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/surface_result_json.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/results/curve_topology_words.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/result_fields.hpp>
#include <eliminant/io/results/result_words.hpp>
#include <eliminant/io/results/univariate_text.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;
using intersect::BranchEnd;
using intersect::BranchEndKind;
using intersect::SurfaceComponent;
using intersect::SurfaceComponentKind;
using intersect::SurfaceSingularPoint;

Json known(const std::string& text) { return text.empty() ? Json() : Json(text); }

// u, v, s, t, x, y, z.
void add_point(Json& out, const intersect::SurfacePoint& point) {
  for (std::size_t i = 0; i < parameter_names.size(); ++i)
    out[parameter_names[i]] = known(parameter_text(point.parameters[i]));
  for (std::size_t i = 0; i < coordinate_names.size(); ++i)
    out[coordinate_names[i]] = known(coordinate_text(point.point[i]));
}

Json end_json(const BranchEnd& end) {
  Json out;
  out["on"] = word_for(end.kind);
  if (end.kind == BranchEndKind::border) {
    out["border"] = border_words(end);
    out["transition"] = word_for(end.transition);
  }
  if (end.kind == BranchEndKind::singular)
    out["singular_point"] = end.singular_point ? Json(*end.singular_point) : Json();
  return out;
}

Json spline_json(const intersect::BranchSpline& spline) {
  Json out;
  out["degree"] = spline.degree;
  out["coordinates"] = {"u", "v", "s", "t", "x", "y", "z"};
  out["error"] = double_text(spline.error);
  out["knots"] = Json::array();
  for (const double knot : spline.knots) out["knots"].push_back(coordinate_text(knot));
  out["control_points"] = Json::array();
  for (const auto& point : spline.control_points) {
    Json& values = out["control_points"].emplace_back(Json::array());
    for (const double value : point) values.push_back(known(coordinate_text(value)));
  }
  return out;
}

Json component_json(const SurfaceComponent& component, bool itself) {
  Json out;
  out["kind"] = word_for(component.kind);
  if (component.kind == SurfaceComponentKind::curve) {
    out["start"] = end_json(component.start);
    out["end"] = end_json(component.end);
  }
  out["tangential"] = component.tangential;
  if (itself) out["mirrored"] = component.mirrored;
  out["error"] = double_text(component.error);
  out["certified"] = component.certified;
  if (!component.certified && !component.reason.empty()) out["reason"] = component.reason;
  out["points"] = Json::array();
  for (const intersect::SurfacePoint& point : component.points) add_point(out["points"].emplace_back(), point);
  if (component.spline) out["spline"] = spline_json(*component.spline);
  return out;
}

Json singular_point_json(const SurfaceSingularPoint& point) {
  Json out;
  out["kind"] = word_for(point.kind);
  add_point(out, point.at);
  if (point.third_preimage)
    out["third_preimage"] = {known(coordinate_text((*point.third_preimage)[0])),
                             known(coordinate_text((*point.third_preimage)[1]))};
  out["radius"] = double_text(point.radius);
  out["half_branches"] = point.half_branches;
  out["certified"] = point.certified;
  if (!point.certified && !point.reason.empty()) out["reason"] = point.reason;
  return out;
}

// The size of a polynomial.
void add_size(Json& out, const symbolic::Polynomial& p) {
  out["degrees"] = {p.degree(0), p.degree(1)};
  out["total_degree"] = p.total_degree();
  out["terms"] = p.term_count();
}

Json roots_json(const std::vector<symbolic::UnivariatePolynomial>& factors, const std::string& variable) {
  Json out = Json::array();
  for (const symbolic::UnivariatePolynomial& factor : factors) out.push_back(univariate_text(factor, variable));
  return out;
}

Json projection_json(const intersect::SurfaceProjection& projection, bool equation) {
  const symbolic::BezoutianEliminant& eliminant = projection.eliminant;
  Json out;
  out["variables"] = projection.variables;
  add_size(out, eliminant.divisor);
  out["matrix_size"] = eliminant.size;
  out["rank"] = eliminant.rank;
  if (eliminant.vanishing != symbolic::DeterminantVanishing::no) {
    out["vanishing"] = word_for(eliminant.vanishing);
    out["vanishing_reason"] = explanation(eliminant.vanishing);
  }
  if (equation) out["equation"] = symbolic::to_string(eliminant.divisor, projection.variables);
  add_size(out["curve"], eliminant.curve);
  if (equation) out["curve"]["equation"] = symbolic::to_string(eliminant.curve, projection.variables);
  out["factors"] = Json::array();
  for (const symbolic::EliminantComponent& component : eliminant.components) {
    Json& factor = out["factors"].emplace_back();
    factor["kind"] = word_for(component.kind);
    factor["reason"] = explanation(component.kind);
    add_size(factor, component.factor);
    factor["multiplicity"] = component.multiplicity;
    factor["meetings"] = component.meetings;
    factor["infinite_parameters"] = component.infinite_parameters;
    factor["proven"] = component.proven;
    if (equation) factor["equation"] = symbolic::to_string(component.factor, projection.variables);
  }
  if (!eliminant.stationary.empty())
    out["stationary"] = {{"u", roots_json(eliminant.stationary.u, "u")},
                         {"t", roots_json(eliminant.stationary.t, "t")}};
  return out;
}

Json domains_json(const SurfaceDomains& domains) {
  Json out;
  for (std::size_t i = 0; i < domains.size(); ++i)
    out[parameter_names[i]] =
        domains[i] ? Json::array({domains[i]->lower.to_string(), domains[i]->upper.to_string()}) : Json();
  return out;
}

}  // namespace

std::string surface_result_json(const intersect::SurfaceResult& result, const SurfaceDomains& domains,
                                const std::optional<ProblemId>& id, bool equation) {
  const bool itself = result.problem == "self_intersection";
  Json out = result_heading(result.problem, id, result.status, result.rest_status, result.limit);
  out["counts"] = {{"curves", result.counts.curves},     {"loops", result.counts.loops},
                   {"points", result.counts.points},     {"overlaps", result.counts.overlaps},
                   {"singular", result.counts.singular}, {"excluded", result.counts.excluded}};
  out["domains"] = domains_json(domains);
  out["components"] = Json::array();
  for (const SurfaceComponent& component : result.components)
    out["components"].push_back(component_json(component, itself));
  out["singular_points"] = Json::array();
  for (const SurfaceSingularPoint& point : result.singular_points)
    out["singular_points"].push_back(singular_point_json(point));
  if (result.projection) out["projection"] = projection_json(*result.projection, equation);
  out["engine"] = engine_json(result.engine);
  if (!result.seconds.empty()) out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
