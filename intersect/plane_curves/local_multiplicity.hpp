// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>

namespace eliminant::intersect {

/// The multiplicity of common zeros of three polynomials in two variables: the length of the local ring modulo all.
///
/// Where two of them cross transversally it is 1. Where one of them, f, is smooth, it is the least order of vanishing
/// of the others along the branch of f, that is the least intersection multiplicity of f with one of them.
class LocalMultiplicity {
 public:
  /// All must outlive the object; no two polynomials need be coprime.
  LocalMultiplicity(std::array<symbolic::Polynomial, 3> equations, const Options& options, const Context& context)
      : equations_(std::move(equations)), options_(options), context_(context) {}

  /// At a common zero of all, one of the solutions of `problem`, which has finitely many. nullopt when the balls do not
  /// show that one of the three is smooth, or do not tell the solutions of a pair apart.
  std::optional<unsigned long> at(const PlaneCurvesProblem& problem, const Solution& solution) const;

 private:
  struct Pair {
    /// A common factor, 1 where there is none, and the common zeros of the cofactors.
    symbolic::Polynomial component{2};
    std::vector<Solution> solutions;
  };
  const Pair& pair(std::size_t i, std::size_t j) const;
  bool is_transversal(const Solution& solution, long precision_bits) const;
  bool is_smooth(std::size_t i, const Solution& solution, long precision_bits) const;

  std::array<symbolic::Polynomial, 3> equations_;
  const Options& options_;
  const Context& context_;
  mutable std::map<std::array<std::size_t, 2>, Pair> pairs_;
};

}  // namespace eliminant::intersect
