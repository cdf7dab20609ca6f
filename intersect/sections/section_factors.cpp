// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/section_factors.hpp>

#include <utility>

#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/symbolic/elimination/bivariate_factors.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;

/// Of an irreducible p.
bool divides(const Polynomial& p, const Polynomial& q) {
  return q.is_zero() || !symbolic::split_common_component(p, q).component.is_constant();
}

/// Along h = 0 the derivative of the homogeneous coordinates is parallel to them.
bool is_mapped_to_points(const symbolic::RationalSurface& map, const Polynomial& h) {
  const auto along = [&](const Polynomial& p) {
    return h.derivative(1) * p.derivative(0) - h.derivative(0) * p.derivative(1);
  };
  const std::vector<Polynomial>& x = map.coordinates();
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j)
      if (!divides(h, x[i] * along(x[j]) - x[j] * along(x[i]))) return false;
  return true;
}

}  // namespace

Polynomial section_polynomial(const symbolic::RationalSurface& map, const Polynomial& equation) {
  return homogenized(equation).compose(map.coordinates());
}

std::vector<SectionFactor> section_factors(const symbolic::RationalSurface& map, const Polynomial& section,
                                           std::uint64_t seed) {
  std::vector<SectionFactor> factors;
  if (section.is_constant()) return factors;
  for (symbolic::BivariateFactor& found : symbolic::bivariate_factors(section, seed)) {
    SectionFactor factor{std::move(found.factor), found.multiplicity, SectionFactorKind::curve};
    if (divides(factor.factor, map.coordinates()[3]))
      factor.kind = SectionFactorKind::at_infinity;
    else if (is_mapped_to_points(map, factor.factor))
      factor.kind = SectionFactorKind::point;
    factors.push_back(std::move(factor));
  }
  return factors;
}

}  // namespace eliminant::intersect
