// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <eliminant/intersect/curve_surface/implicitize.hpp>
#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/io/input/run_options.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>

namespace eliminant::io {

/// What the author of a problem calls it; repeated in the result.
using ProblemId = std::variant<std::string, long>;

/// The problems that files hold, by their kind: "plane_curves", "curve_surface", "curve_curve", "self_intersection" (of
/// a curve), "implicitize", "curve_topology", "surface_surface", "self_intersection" (of a surface),
/// "cylinders", "cylinder_extraction".
using Problem =
    std::variant<intersect::PlaneCurvesProblem, intersect::CurveSurfaceProblem, intersect::CurveCurveProblem,
                 intersect::SelfIntersectionProblem, intersect::ImplicitizeProblem, intersect::CurveTopologyProblem,
                 intersect::SurfaceSurfaceProblem, intersect::SurfaceSelfIntersectionProblem,
                 intersect::CylindersProblem, intersect::CylinderExtractionProblem>;

/// A problem and what its author chose for it.
struct ProblemFile {
  Problem problem;
  std::optional<ProblemId> id;
  std::vector<OptionSetting> options;
};

enum class ProblemSyntax { json, msolve };

/// What the caller decides about reading a problem.
struct ReadSettings {
  /// In place of the variables of the file.
  std::optional<std::vector<std::string>> variables;
  symbolic::Limits limits;
  /// A text without "problem" is one for implicitize: {"curve": ...}, {"surface": ...}, or a curve or surface itself.
  bool bare_geometry = false;
  /// Where the names of files in a problem begin; empty: the working directory.
  std::string folder;
};

/// msolve for the name `*.ms`; else by the first character: JSON begins with "{" or "[", and has quotes.
ProblemSyntax problem_syntax(const std::string& path, std::string_view text);

/// Reads one problem (docs/formats.md); msolve's format holds plane_curves. All numbers are exact. When `id` is given
/// it is set as soon as it is known, also if the rest is refused. Throws ParseError (syntax), InvalidInput (unknown or
/// missing fields, wrong types, problem kinds of later versions, `settings.variables` for another kind than
/// plane_curves and curve_topology) and LimitReached (too large), each with the place in `text`.
ProblemFile read_problem(const std::string& text, ProblemSyntax syntax, const ReadSettings& settings = {},
                         std::optional<ProblemId>* id = nullptr);

/// The problem of two polynomials and a box `[[a, b], [c, d]]` written apart, as on the command line.
ProblemFile problem_from_arguments(const std::string& p, const std::string& q, const std::optional<std::string>& box,
                                   const ReadSettings& settings = {});

}  // namespace eliminant::io
