// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

// Notation. For coprime p, q of total degrees d and e, and a shear s, let
//     C(t; s) = Res_y( p(t - s y, y), q(t - s y, y) ),
// with formal degrees d and e in y. When the line direction (-s, 1) is no zero of both leading forms, C is not zero and
//     C(t; s) = c(s) * product over the affine solutions (x_i, y_i) of (t - x_i - s y_i)^(m_i),
// m_i the intersection multiplicity: the corollary of Proposition 5 of [BuseKhalilMourrain2005] for every s at once.
// Its degree in t is the number of affine solutions counted with multiplicity, whatever the admissible s.

/// The dense image of a bivariate integer polynomial modulo a prime, ready to be restricted to lines.
class ModularCurve {
 public:
  /// p has integer coefficients (p is primitive) and two variables.
  ModularCurve(const Polynomial& p, const PrimeField& field);
  /// Total degree of p over Q (the formal degree of every restriction).
  long degree() const { return degree_; }
  /// Value of the leading form of p at (-s, 1): the coefficient of y^degree in p(t - s y, y).
  mp_limb_t leading_form_at(mp_limb_t s) const;
  /// Sets `restriction` to p(t - s y, y), a polynomial in y.
  void restrict_to_line(mp_limb_t t, mp_limb_t s, ModularPolynomial& restriction) const;
  /// The same, and sets `derivative` to its derivative with respect to s, that is -y p_x(t - s y, y).
  void restrict_to_line(mp_limb_t t, mp_limb_t s, ModularPolynomial& restriction, ModularPolynomial& derivative) const;

 private:
  PrimeField field_;
  long degree_;
  std::vector<std::vector<mp_limb_t>> by_x_power_;  // [i][j]: coefficient of x^i y^j
};

/// C(t; s) and, where asked for, its derivative with respect to s, modulo one prime.
struct ModularChowForm {
  ModularPolynomial form;
  std::optional<ModularPolynomial> shear_derivative;
};

/// nullopt when the prime is unlucky for this s (the leading coefficient used vanishes modulo it).
/// By evaluation at d e + 1 values of t, Euclid's algorithm and interpolation.
std::optional<ModularChowForm> chow_form_modulo(const ModularCurve& p, const ModularCurve& q, mp_limb_t s,
                                                bool with_derivative, const PrimeField& field);

/// C(t; s) over Z up to sign, and its derivative with respect to s (same sign).
struct ChowForm {
  UnivariatePolynomial form;
  UnivariatePolynomial shear_derivative;  ///< zero unless it was asked for
  long shear = 0;
};

/// True when the direction (-s, 1) is no common zero of the leading forms of p and q.
bool is_admissible_shear(const Polynomial& p, const Polynomial& q, long shear);

/// Chinese remaindering with as many primes as a proven bound on the coefficients needs: Hadamard's bound on the
/// Sylvester determinant on |t| = |epsilon| = 1, with s + epsilon for s. p and q are primitive over Z and coprime.
/// Throws InvalidInput when the shear is not admissible.
ChowForm chow_form(const Polynomial& p, const Polynomial& q, long shear, bool with_derivative, std::uint64_t seed,
                   const Context& context);

}  // namespace eliminant::symbolic
