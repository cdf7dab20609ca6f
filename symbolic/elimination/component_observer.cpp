// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/component_observer.hpp>

#include <algorithm>

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>

namespace eliminant::symbolic {

namespace {

std::optional<mp_limb_t> some_root(const ModularPolynomial& f) {
  if (f.degree() < 1) return std::nullopt;
  nmod_poly_factor_t roots;
  nmod_poly_factor_init(roots);
  nmod_poly_roots(roots, f.get(), 0);
  std::optional<mp_limb_t> root;
  if (roots->num > 0) root = nmod_neg(nmod_poly_get_coeff_ui(roots->p, 0), roots->p->mod);
  nmod_poly_factor_clear(roots);
  return root;
}

/// f with `value` in place of variable `index`.
ModularPolynomial restricted(const Polynomial& f, std::size_t index, mp_limb_t value, const PrimeField& field) {
  const HiddenVariablePolynomial hidden = hide_variable(f, index);
  ModularPolynomial result(field);
  ModularPolynomial coefficient(field);
  for (std::size_t k = 0; k < hidden.coefficients.size(); ++k) {
    fmpz_poly_get_nmod_poly(coefficient.get(), hidden.coefficients[k].get());
    nmod_poly_set_coeff_ui(result.get(), static_cast<slong>(k), nmod_poly_evaluate_nmod(coefficient.get(), value));
  }
  return result;
}

/// The curve of the surface where parameter `kept` has this value.
ModularSpaceCurve curve_at(const RationalSurface& surface, std::size_t kept, mp_limb_t value, const PrimeField& field) {
  ModularSpaceCurve curve(static_cast<std::size_t>(surface.bidegree()[1 - kept]) + 1, {0, 0, 0, 0});
  for (std::size_t k = 0; k < 4; ++k) {
    const ModularPolynomial coordinate = restricted(surface.coordinates()[(k + 3) % 4], kept, value, field);
    for (long e = 0; e <= coordinate.degree(); ++e)
      curve[static_cast<std::size_t>(e)][k] = nmod_poly_get_coeff_ui(coordinate.get(), e);
  }
  return curve;
}

bool have_common_root(const std::vector<mp_limb_t>& f, const std::vector<mp_limb_t>& g, const PrimeField& field) {
  const auto polynomial = [&](const std::vector<mp_limb_t>& coefficients) {
    ModularPolynomial result(field);
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      nmod_poly_set_coeff_ui(result.get(), static_cast<slong>(k), coefficients[k]);
    return result;
  };
  if (f.empty() || g.empty()) return false;
  ModularPolynomial common(field);
  nmod_poly_gcd(common.get(), polynomial(f).get(), polynomial(g).get());
  return common.degree() > 0;
}

}  // namespace

CurveMeetings ComponentObserver::anywhere(std::uint64_t round) const {
  const PrimeField field(PrimeSequence(mix(seed_, round)).next());
  return above({mix(seed_, round + 100) % field.prime(), mix(seed_, round + 200) % field.prime()}, field, round);
}

std::optional<Observation> ComponentObserver::on(const Polynomial& f, std::uint64_t round) const {
  PrimeSequence primes(mix(seed_, round + 300));
  constexpr std::uint64_t most_trials = 2000;
  for (std::uint64_t trial = 0; trial < most_trials; ++trial) {
    const PrimeField field(primes.next());
    const mp_limb_t free = mix(seed_ + round, trial) % field.prime();
    const std::size_t fixed = f.degree(1) > 0 ? 0 : 1;
    const std::optional<mp_limb_t> root = some_root(restricted(f, fixed, free, field));
    if (!root) continue;
    const auto point = [&](mp_limb_t other) {
      return fixed == 0 ? PlanePoint{other, *root} : PlanePoint{*root, other};
    };
    Observation result{above(point(free), field, round), false, false};
    if (f.degree(0) > 0 && f.degree(1) > 0) return result;
    // On a line of the plane the other coordinate moves.
    const mp_limb_t elsewhere = mix(seed_ + round, trial + most_trials) % field.prime();
    const CurveMeetings moved = above(point(elsewhere), field, round);
    result.one_image = !moved.images.empty() && moved.images == result.meetings.images;
    result.one_parameter = have_common_root(moved.parameters, result.meetings.parameters, field);
    return result;
  }
  return std::nullopt;
}

CurveMeetings ComponentObserver::above(const PlanePoint& point, const PrimeField& field, std::uint64_t round) const {
  const ModularSpaceCurve first = curve_at(first_, 0, point.u, field);
  const ModularSpaceCurve second = curve_at(second_, 1, point.t, field);
  std::optional<TrivialPair> trivial;
  std::optional<TrivialPair> exchanged;
  if (self_) {
    trivial = {point.t, point.u};
    exchanged = {point.u, point.t};
  }
  const std::uint64_t numbers = mix(seed_, round + 400);
  const std::uint64_t projection = mix(seed_, round + 500);
  CurveMeetings result = curve_meetings(first, second, trivial, field, numbers, projection);
  // One parameter of the first curve may belong to several of the second.
  const CurveMeetings other = curve_meetings(second, first, exchanged, field, numbers, projection);
  result.finite = std::max(result.finite, other.finite);
  result.at_infinity = std::max(result.at_infinity, other.at_infinity);
  result.infinite_parameters = result.infinite_parameters || other.infinite_parameters;
  return result;
}

}  // namespace eliminant::symbolic
