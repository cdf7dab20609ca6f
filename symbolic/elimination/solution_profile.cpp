// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include <eliminant/symbolic/elimination/solution_profile.hpp>

namespace eliminant::symbolic {

namespace {

unsigned long sum(const std::vector<unsigned long>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0UL);
}

/// 0, 1, -1, 2, -2, ...
long next_shear(long shear) { return shear > 0 ? -shear : 1 - shear; }

/// Coprime modulo a prime that keeps a degree implies coprime: the resultant of the leading forms is not zero.
bool leading_forms_coprime(const ModularCurve& p, const ModularCurve& q, const PrimeField& field) {
  // Both forms are restricted to (-s, 1) with s as the variable; the point (1, 0) is checked by the degrees.
  const auto dehomogenised = [&](const ModularCurve& curve) {
    std::vector<mp_limb_t> points;
    std::vector<mp_limb_t> values;
    for (long k = 0; k <= curve.degree(); ++k) {
      points.push_back(field.reduce(k));
      values.push_back(curve.leading_form_at(points.back()));
    }
    return interpolate(field, std::move(points), std::move(values));
  };
  const ModularPolynomial f = dehomogenised(p);
  const ModularPolynomial g = dehomogenised(q);
  if (f.is_zero() || g.is_zero()) return false;
  if (f.degree() < p.degree() && g.degree() < q.degree()) return false;
  return nmod_poly_resultant(f.get(), g.get()) != 0;
}

}  // namespace

unsigned long SolutionProfile::distinct() const { return sum(distinct_by_multiplicity); }

bool do_not_meet_at_infinity(const Polynomial& p, const Polynomial& q, std::uint64_t seed) {
  const PrimeField field(PrimeSequence(mix(seed, 1)).next());
  return leading_forms_coprime(ModularCurve(p, field), ModularCurve(q, field), field);
}

SolutionProfile solution_profile(const Polynomial& p, const Polynomial& q, std::uint64_t seed, const Context& context) {
  context.checkpoint("counting solutions");
  // Another prime than those of the reconstruction, so that both agreeing means something.
  PrimeSequence primes(mix(seed, 1));
  for (;;) {
    const PrimeField field(primes.next());
    const ModularCurve modular_p(p, field);
    const ModularCurve modular_q(q, field);
    SolutionProfile profile;
    profile.bezout_holds = leading_forms_coprime(modular_p, modular_q, field);

    // The number of distinct values of x + s y is largest for a random s, and then equals the number of solutions.
    std::optional<unsigned long> generic_distinct;
    bool unlucky = false;
    for (long s = 0;; s = next_shear(s)) {
      if (!is_admissible_shear(p, q, s)) continue;
      context.checkpoint("counting solutions");
      const auto image = chow_form_modulo(modular_p, modular_q, field.reduce(s), false, field);
      if (!image || image->form.is_zero()) {
        unlucky = true;
        break;
      }
      profile.with_multiplicity = static_cast<unsigned long>(image->form.degree());
      profile.distinct_by_multiplicity = multiplicity_profile(image->form);
      profile.shear = s;
      if (profile.all_simple()) return profile;
      if (!generic_distinct) {
        const mp_limb_t random = mix(seed, 2) % field.prime();
        const auto generic = chow_form_modulo(modular_p, modular_q, random, false, field);
        if (!generic || generic->form.is_zero()) {
          unlucky = true;
          break;
        }
        generic_distinct = sum(multiplicity_profile(generic->form));
      }
      if (profile.distinct() >= *generic_distinct) return profile;
    }
    if (unlucky) continue;
  }
}

}  // namespace eliminant::symbolic
