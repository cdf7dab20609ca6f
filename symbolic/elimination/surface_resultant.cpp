// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/surface_resultant.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>

#include <eliminant/symbolic/elimination/modular_matrix.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>

namespace eliminant::symbolic {

namespace {

Integer norm_of(const UnivariatePolynomial& f) {
  Integer sum;
  Integer magnitude;
  for (long i = 0; i <= f.degree(); ++i) {
    fmpz_abs(magnitude.get(), f.coefficient(i).get());
    sum = sum + magnitude;
  }
  return sum;
}

Integer norm_of(const Polynomial& f) {
  Integer sum;
  Integer magnitude;
  for (const Polynomial::Term& term : f.terms()) {
    fmpz_abs(magnitude.get(), term.coefficient.numerator().get());
    sum = sum + magnitude;
  }
  return sum;
}

/// log2 of a bound of the coefficients of the primitive S^k(Psi(t)). The three forms f_j psi_3 - f_3 psi_j have the
/// resultant S^k(Psi) psi_3^(2 N) up to a constant, N = 2 m n; by [Sombra2004] it is at most the product of
/// ((m + 1)(n + 1) norm)^N on |t| = 1, and so is the Mahler measure of its divisor.
unsigned long coefficient_bits(const RationalSurface& surface, const RationalCurve& curve) {
  const auto [m, n] = surface.bidegree();
  const auto count = static_cast<unsigned long>(2 * m * n);
  std::array<Integer, 4> on_surface;
  std::array<Integer, 4> on_curve;
  for (std::size_t k = 0; k < 4; ++k) {
    on_surface[k] = norm_of(surface.coordinates()[k]);
    on_curve[k] = norm_of(curve.coordinates()[k]);
  }
  unsigned long best = 0;
  for (std::size_t pivot = 0; pivot < 4; ++pivot) {
    if (on_curve[pivot].is_zero()) continue;
    unsigned long bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == pivot) continue;
      const Integer norm = on_surface[k] * on_curve[pivot] + on_surface[pivot] * on_curve[k];
      bits += count * (Integer((m + 1) * (n + 1)) * norm).bit_length();
    }
    if (best == 0 || bits < best) best = bits;
  }
  return best + count * static_cast<unsigned long>(curve.degree());
}

class Reconstruction {
 public:
  Reconstruction(const RationalSurface& surface, const RationalCurve& curve)
      : curve_(curve), nu_(representation_bidegree(surface)), system_(moving_plane_system(surface, nu_)) {
    const auto [m, n] = surface.bidegree();
    size_ = 2 * m * n;
  }

  /// The monic multiple of the determinant modulo a prime; nullopt when it vanishes or the matrix is not square.
  std::optional<ModularPolynomial> modulo(const PrimeField& field) const {
    ModularMatrix system(system_.rows(), system_.columns(), field);
    fmpz_mat_get_nmod_mat(system.get(), system_.get());
    ModularMatrix kernel(system_.columns(), system_.columns(), field);
    if (nmod_mat_nullspace(kernel.get(), system.get()) != size_) return std::nullopt;
    std::vector<ModularPolynomial> coordinates;
    for (const UnivariatePolynomial& f : curve_.coordinates())
      fmpz_poly_get_nmod_poly(coordinates.emplace_back(field).get(), f.get());
    ModularMatrix value(size_, size_, field);
    std::vector<mp_limb_t> points;
    std::vector<mp_limb_t> values;
    for (mp_limb_t t = 0; static_cast<long>(points.size()) <= size_ * curve_.degree(); ++t) {
      std::array<mp_limb_t, 4> at{};
      for (std::size_t k = 0; k < 4; ++k) at[k] = nmod_poly_evaluate_nmod(coordinates[k].get(), t);
      for (long i = 0; i < size_; ++i)
        for (long j = 0; j < size_; ++j) {
          mp_limb_t sum = 0;
          for (std::size_t k = 0; k < 4; ++k)
            sum = field.add(sum, field.multiply(at[k], kernel(static_cast<long>(k) * size_ + i, j)));
          value(i, j) = sum;
        }
      points.push_back(t);
      values.push_back(nmod_mat_det(value.get()));
    }
    ModularPolynomial result = interpolate(field, std::move(points), std::move(values));
    if (result.is_zero()) return std::nullopt;
    nmod_poly_make_monic(result.get(), result.get());
    return result;
  }

  long formal_degree() const { return size_ * curve_.degree(); }

 private:
  const RationalCurve& curve_;
  std::array<long, 2> nu_;
  IntegerMatrix system_;
  long size_ = 0;
};

/// The primitive polynomial whose monic multiple has these coefficients modulo `modulus`; nullopt when some coefficient
/// is no small fraction.
std::optional<UnivariatePolynomial> reconstruct(const UnivariatePolynomial& monic, const Integer& modulus) {
  std::vector<Rational> coefficients;
  Integer denominator(1);
  for (long i = 0; i <= monic.degree(); ++i) {
    Rational& value = coefficients.emplace_back();
    Integer residue = monic.coefficient(i) * denominator;
    fmpz_mod(residue.get(), residue.get(), modulus.get());
    if (fmpq_reconstruct_fmpz(value.get(), residue.get(), modulus.get()) == 0) return std::nullopt;
    // What follows is multiplied by the denominators met so far: they are mostly the same.
    value = value / Rational(denominator);
    fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(value.get()));
  }
  UnivariatePolynomial result;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    fmpz_poly_set_coeff_fmpz(result.get(), static_cast<slong>(i),
                             (coefficients[i] * Rational(denominator)).numerator().get());
  return result.primitive_part();
}

unsigned long height_bits(const UnivariatePolynomial& p) {
  return static_cast<unsigned long>(std::labs(fmpz_poly_max_bits(p.get())));
}

}  // namespace

std::optional<ParameterForm> surface_resultant_on_curve(const RationalSurface& surface, const RationalCurve& curve,
                                                        std::uint64_t seed, const Context& context) {
  if (surface.kind() != RationalSurface::Kind::tensor_product) return std::nullopt;
  const auto [m, n] = surface.bidegree();
  if (m < 1 || n < 1) return std::nullopt;
  const Reconstruction images(surface, curve);
  const unsigned long bound_bits = coefficient_bits(surface, curve);
  PrimeSequence primes(seed);
  UnivariatePolynomial monic;
  Integer modulus(1);
  std::optional<UnivariatePolynomial> candidate;
  unsigned long next_attempt = 4 * 61;
  constexpr int most_failures = 3;
  int failures = 0;
  for (unsigned long bits = 0;;) {
    context.checkpoint("elimination");
    const PrimeField field(primes.next());
    const auto image = images.modulo(field);
    if (!image) {
      // Base points, or the curve lies in the surface: no prime will do.
      if (++failures == most_failures) return std::nullopt;
      continue;
    }
    if (bits > 0 && image->degree() != monic.degree()) {
      if (image->degree() < monic.degree()) continue;
      bits = 0;
      candidate.reset();
    }
    if (bits == 0) {
      modulus = Integer(1);
      fmpz_poly_set_nmod_poly(monic.get(), image->get());
    } else {
      fmpz_poly_CRT_ui(monic.get(), monic.get(), modulus.get(), image->get(), 0);
    }
    fmpz_mul_ui(modulus.get(), modulus.get(), field.prime());
    bits += 61;
    if (candidate) {
      // Still the same? Its monic multiple modulo the new prime tells.
      ModularPolynomial reduced(field);
      fmpz_poly_get_nmod_poly(reduced.get(), candidate->get());
      if (reduced.degree() == image->degree()) nmod_poly_make_monic(reduced.get(), reduced.get());
      if (nmod_poly_equal(reduced.get(), image->get()) == 0) candidate.reset();
    }
    if (!candidate && bits >= next_attempt) {
      candidate = reconstruct(monic, modulus);
      next_attempt = bits + bits / 3;
    }
    // Both are primitive with proportional images: the minors of their coefficients vanish modulo `modulus`, and are
    // smaller.
    if (candidate && bits > bound_bits + height_bits(*candidate) + 2)
      return ParameterForm{*candidate, images.formal_degree() - candidate->degree()};
  }
}

}  // namespace eliminant::symbolic
