// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>

#include <algorithm>
#include <array>
#include <numeric>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>
#include <eliminant/symbolic/elimination/modular_matrix.hpp>

namespace eliminant::symbolic {

namespace {

using LineCoordinates = SeparatedBezoutian::LineCoordinates;
using Residues = std::vector<mp_limb_t>;

constexpr std::size_t coordinates = 6;

Integer norm_of(const UnivariatePolynomial& f) {
  Integer sum;
  Integer magnitude;
  for (long k = 0; k <= f.degree(); ++k) {
    fmpz_abs(magnitude.get(), f.coefficient(k).get());
    sum = sum + magnitude;
  }
  return sum;
}

long degree_of(const LineCoordinates& lines) {
  long degree = -1;
  for (const UnivariatePolynomial& coordinate : lines) degree = std::max(degree, coordinate.degree());
  return degree;
}

/// Indices of the pair in the upper triangle of a symmetric array.
std::size_t pair_index(std::size_t i, std::size_t j, std::size_t size) {
  if (i > j) std::swap(i, j);
  return i * size - i * (i + 1) / 2 + j;
}

/// The values of all lines of one surface modulo a prime at the parameters 0, 1, ...: for each parameter and each pair
/// of the upper triangle the six coordinates.
class LineValues {
 public:
  template <class Lines>
  LineValues(std::size_t size, const Lines& lines, std::size_t points, const PrimeField& field)
      : pairs_(size * (size + 1) / 2), values_(points * pairs_ * coordinates) {
    ModularPolynomial coordinate(field);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = i; j < size; ++j)
        for (std::size_t c = 0; c < coordinates; ++c) {
          fmpz_poly_get_nmod_poly(coordinate.get(), lines(i, j)[c].get());
          for (std::size_t x = 0; x < points; ++x)
            values_[(x * pairs_ + pair_index(i, j, size)) * coordinates + c] =
                nmod_poly_evaluate_nmod(coordinate.get(), x);
        }
  }
  std::size_t pairs() const { return pairs_; }
  const mp_limb_t* at(std::size_t x, std::size_t pair) const { return &values_[(x * pairs_ + pair) * coordinates]; }

 private:
  std::size_t pairs_;
  Residues values_;
};

mp_limb_t incidence(const mp_limb_t* a, const mp_limb_t* b, const nmod_t& modulus) {
  // Six products below 2^124 do not overflow two words.
  mp_limb_t high = 0;
  mp_limb_t low = 0;
  for (std::size_t c = 0; c < coordinates; ++c) {
    mp_limb_t product_high;
    mp_limb_t product_low;
    umul_ppmm(product_high, product_low, a[c], b[c]);
    add_ssaaaa(high, low, high, low, product_high, product_low);
  }
  return n_ll_mod_preinv(high, low, modulus.n, modulus.ninv);
}

/// A symmetric matrix over a prime field, row by row, and its determinant as a fraction: elimination without division.
class SymmetricElimination {
 public:
  SymmetricElimination(std::size_t size, const PrimeField& field) : size_(size), field_(field), a_(size * size) {}
  mp_limb_t& operator()(std::size_t i, std::size_t j) { return a_[i * size_ + j]; }

  struct Fraction {
    mp_limb_t numerator = 1;
    mp_limb_t denominator = 1;
  };
  /// Reads the upper triangle and destroys it.
  Fraction determinant() {
    Fraction result;
    for (std::size_t k = 0; k < size_; ++k) {
      const mp_limb_t pivot = a_[k * size_ + k];
      if (pivot == 0) {
        result.numerator = field_.multiply(result.numerator, rest(k));
        return result;
      }
      result.numerator = field_.multiply(result.numerator, pivot);
      const nmod_t modulus = field_.modulus();
      for (std::size_t i = k + 1; i < size_; ++i) {
        // Row i is multiplied by the pivot: so is the determinant.
        result.denominator = field_.multiply(result.denominator, pivot);
        const mp_limb_t factor = field_.negate(a_[k * size_ + i]);
        for (std::size_t j = i; j < size_; ++j) {
          mp_limb_t high;
          mp_limb_t low;
          mp_limb_t other_high;
          mp_limb_t other_low;
          umul_ppmm(high, low, pivot, a_[i * size_ + j]);
          umul_ppmm(other_high, other_low, factor, a_[k * size_ + j]);
          add_ssaaaa(high, low, high, low, other_high, other_low);
          a_[i * size_ + j] = n_ll_mod_preinv(high, low, modulus.n, modulus.ninv);
        }
      }
    }
    return result;
  }

 private:
  /// The determinant of what is left from row k on, where the pivot is zero.
  mp_limb_t rest(std::size_t k) const {
    ModularMatrix matrix(static_cast<long>(size_ - k), static_cast<long>(size_ - k), field_);
    for (std::size_t i = k; i < size_; ++i)
      for (std::size_t j = k; j < size_; ++j)
        matrix(static_cast<long>(i - k), static_cast<long>(j - k)) = a_[std::min(i, j) * size_ + std::max(i, j)];
    return nmod_mat_det(matrix.get());
  }

  std::size_t size_;
  PrimeField field_;
  Residues a_;
};

/// values[k] <- 1 / values[k], none zero, with one inversion (Montgomery's trick).
void invert_all(Residues& values, const PrimeField& field) {
  Residues prefixes(values.size());
  mp_limb_t product = 1;
  for (std::size_t k = 0; k < values.size(); ++k) {
    prefixes[k] = product;
    product = field.multiply(product, values[k]);
  }
  mp_limb_t inverse = field.inverse(product);
  for (std::size_t k = values.size(); k-- > 0;) {
    const mp_limb_t value = values[k];
    values[k] = field.multiply(inverse, prefixes[k]);
    inverse = field.multiply(inverse, value);
  }
}

/// The matrix from the values at 0, ..., d to the coefficients of a polynomial of degree d: column k holds the
/// coefficients of Lagrange's polynomial of the point k.
ModularMatrix interpolation_matrix(std::size_t degree, const PrimeField& field) {
  const auto size = static_cast<long>(degree) + 1;
  Residues product{1};  // of all x - k
  for (std::size_t k = 0; k <= degree; ++k) {
    product.push_back(0);
    for (std::size_t e = product.size(); e-- > 0;)
      product[e] = field.subtract(e > 0 ? product[e - 1] : 0, field.multiply(k, product[e]));
  }
  Residues weights(degree + 1, 1);  // the product of all k - j, j != k: (-1)^(d-k) k! (d-k)!
  for (std::size_t k = 0; k <= degree; ++k) {
    for (std::size_t j = 1; j <= k; ++j) weights[k] = field.multiply(weights[k], j);
    for (std::size_t j = 1; j <= degree - k; ++j) weights[k] = field.multiply(weights[k], field.negate(j));
  }
  invert_all(weights, field);
  ModularMatrix result(size, size, field);
  for (std::size_t k = 0; k <= degree; ++k) {
    mp_limb_t quotient = 0;
    for (std::size_t e = degree + 1; e-- > 0;) {
      quotient = field.add(field.multiply(quotient, k), product[e + 1]);
      result(static_cast<long>(e), static_cast<long>(k)) = field.multiply(quotient, weights[k]);
    }
  }
  return result;
}

struct Degrees {
  std::size_t u = 0;
  std::size_t t = 0;
};

/// A minor by interpolation: everything that does not depend on the prime.
class MinorInterpolation {
 public:
  MinorInterpolation(const SeparatedBezoutian& matrix, const std::vector<std::size_t>& rows,
                     const std::vector<std::size_t>& columns)
      : matrix_(matrix),
        rows_(rows),
        columns_(columns),
        degrees_{degree(true), degree(false)},
        bits_(coefficient_bits()) {}

  /// A bound of the degrees from elsewhere.
  void limit_degrees(Degrees most) { degrees_ = {std::min(degrees_.u, most.u), std::min(degrees_.t, most.t)}; }
  Degrees degrees() const { return degrees_; }

  Polynomial reconstruct(std::uint64_t seed, const Context& context) const {
    // Every prime exceeds 2^61.
    const std::size_t primes_needed = bits_ / 61 + 1;
    require_memory(primes_needed);
    PrimeSequence primes(seed);
    std::vector<ModularMatrix> images;
    for (std::size_t k = 0; k < primes_needed; ++k) images.push_back(modulo(PrimeField(primes.next()), context));
    return lift(images);
  }

 private:
  /// The sum over the rows of the largest degree in it.
  std::size_t degree(bool in_u) const {
    long sum = 0;
    for (const std::size_t row : rows_) {
      long largest = 0;
      for (const std::size_t column : columns_)
        largest = std::max(largest, in_u ? degree_of(first(row, column)) : degree_of(second(row, column)));
      sum += largest;
    }
    return static_cast<std::size_t>(sum);
  }

  const LineCoordinates& first(std::size_t row, std::size_t column) const {
    return matrix_.first_lines(row % matrix_.first_degree(), column % matrix_.first_degree());
  }
  const LineCoordinates& second(std::size_t row, std::size_t column) const {
    return matrix_.second_lines(row / matrix_.first_degree(), column / matrix_.first_degree());
  }

  /// log2 of a bound of twice the largest coefficient.
  unsigned long coefficient_bits() const {
    Integer squared(1);
    for (const std::size_t row : rows_) {
      Integer sum;
      for (const std::size_t column : columns_) {
        Integer norm;
        for (std::size_t c = 0; c < coordinates; ++c)
          norm = norm + norm_of(first(row, column)[c]) * norm_of(second(row, column)[c]);
        sum = sum + norm * norm;
      }
      squared = squared * sum;
    }
    return squared.bit_length() / 2 + 2;
  }

  void require_memory(std::size_t primes) const {
    constexpr std::size_t most_words = std::size_t{1} << 26U;
    const std::size_t words = (degrees_.u + 1) * (degrees_.t + 1) * primes;
    if (words > most_words)
      throw LimitReached("a determinant of bidegree (" + std::to_string(degrees_.u) + ", " +
                         std::to_string(degrees_.t) + ") with coefficients of " + std::to_string(bits_) +
                         " bits would not fit in memory");
  }

  /// The coefficients modulo a prime: row e, column f that of u^e t^f.
  ModularMatrix modulo(const PrimeField& field, const Context& context) const {
    const std::size_t n = matrix_.first_degree();
    const std::size_t m = matrix_.second_degree();
    const LineValues first(
        n, [&](std::size_t i, std::size_t j) -> const LineCoordinates& { return matrix_.first_lines(i, j); },
        degrees_.u + 1, field);
    const LineValues second(
        m, [&](std::size_t i, std::size_t j) -> const LineCoordinates& { return matrix_.second_lines(i, j); },
        degrees_.t + 1, field);
    ModularMatrix values(static_cast<long>(degrees_.u) + 1, static_cast<long>(degrees_.t) + 1, field);
    const bool symmetric = rows_ == columns_;
    SymmetricElimination elimination(symmetric ? rows_.size() : 0, field);
    const auto size = static_cast<long>(rows_.size());
    ModularMatrix whole(size, size, field);
    Residues entries(first.pairs() * second.pairs());
    const auto entry = [&](std::size_t i, std::size_t j) {
      return entries[pair_index(rows_[i] % n, columns_[j] % n, n) * second.pairs() +
                     pair_index(rows_[i] / n, columns_[j] / n, m)];
    };
    Residues denominators(degrees_.t + 1, 1);
    for (std::size_t u = 0; u <= degrees_.u; ++u) {
      context.checkpoint("elimination");
      for (std::size_t t = 0; t <= degrees_.t; ++t) {
        for (std::size_t a = 0; a < first.pairs(); ++a)
          for (std::size_t b = 0; b < second.pairs(); ++b)
            entries[a * second.pairs() + b] = incidence(first.at(u, a), second.at(t, b), field.modulus());
        mp_limb_t& value = values(static_cast<long>(u), static_cast<long>(t));
        for (std::size_t i = 0; i < rows_.size(); ++i)
          for (std::size_t j = symmetric ? i : 0; j < rows_.size(); ++j)
            (symmetric ? elimination(i, j) : whole(static_cast<long>(i), static_cast<long>(j))) = entry(i, j);
        if (symmetric) {
          const SymmetricElimination::Fraction fraction = elimination.determinant();
          value = fraction.numerator;
          denominators[t] = fraction.denominator;
        } else {
          value = nmod_mat_det(whole.get());
        }
      }
      if (!symmetric) continue;
      invert_all(denominators, field);
      for (std::size_t t = 0; t <= degrees_.t; ++t) {
        mp_limb_t& value = values(static_cast<long>(u), static_cast<long>(t));
        value = field.multiply(value, denominators[t]);
      }
    }
    return coefficients_of(values, field);
  }

  ModularMatrix coefficients_of(const ModularMatrix& values, const PrimeField& field) const {
    const auto rows = static_cast<long>(degrees_.u) + 1;
    const auto columns = static_cast<long>(degrees_.t) + 1;
    ModularMatrix half(rows, columns, field);
    nmod_mat_mul(half.get(), interpolation_matrix(degrees_.u, field).get(), values.get());
    ModularMatrix transposed(columns, columns, field);
    nmod_mat_transpose(transposed.get(), interpolation_matrix(degrees_.t, field).get());
    ModularMatrix result(rows, columns, field);
    nmod_mat_mul(result.get(), half.get(), transposed.get());
    return result;
  }

  Polynomial lift(std::vector<ModularMatrix>& images) const {
    const auto rows = static_cast<long>(degrees_.u) + 1;
    const auto columns = static_cast<long>(degrees_.t) + 1;
    IntegerMatrix coefficients(rows, columns);
    // FLINT takes an array of matrices by value; these are borrowed.
    std::vector<nmod_mat_struct> borrowed;
    for (ModularMatrix& image : images) borrowed.push_back(*image.get());
    fmpz_mat_multi_CRT_ui(coefficients.get(), reinterpret_cast<nmod_mat_t*>(borrowed.data()),
                          static_cast<slong>(borrowed.size()), 1);
    Polynomial result(2);
    std::array<unsigned long, 2> exponents{};
    for (long u = rows; u-- > 0;)
      for (long t = columns; t-- > 0;) {
        const fmpz* coefficient = fmpz_mat_entry(coefficients.get(), u, t);
        if (fmpz_is_zero(coefficient) != 0) continue;
        exponents = {static_cast<unsigned long>(u), static_cast<unsigned long>(t)};
        fmpq_mpoly_push_term_fmpz_ui(result.get(), coefficient, exponents.data(), result.ring());
      }
    fmpq_mpoly_reduce(result.get(), result.ring());
    return result;
  }

  const SeparatedBezoutian& matrix_;
  std::vector<std::size_t> rows_;
  std::vector<std::size_t> columns_;
  Degrees degrees_;
  unsigned long bits_;
};

std::vector<std::size_t> indices(std::size_t first, std::size_t end) {
  std::vector<std::size_t> result(end - first);
  std::iota(result.begin(), result.end(), first);
  return result;
}

}  // namespace

Polynomial minor(const SeparatedBezoutian& matrix, const std::vector<std::size_t>& rows,
                 const std::vector<std::size_t>& columns, std::uint64_t seed, const Context& context) {
  if (rows.size() != columns.size())
    throw InvalidInput("a minor of " + std::to_string(rows.size()) + " rows and " + std::to_string(columns.size()) +
                           " columns was asked for",
                       "as many rows as columns");
  for (const std::vector<std::size_t>* list : {&rows, &columns})
    for (const std::size_t index : *list)
      if (index >= matrix.size())
        throw InvalidInput("index " + std::to_string(index) + " in a matrix of size " + std::to_string(matrix.size()),
                           "an index below the size");
  return MinorInterpolation(matrix, rows, columns).reconstruct(seed, context);
}

Polynomial principal_minor(const SeparatedBezoutian& matrix, const std::vector<std::size_t>& rows, std::uint64_t seed,
                           const Context& context) {
  return minor(matrix, rows, rows, seed, context);
}

Polynomial bezoutian_determinant(const SeparatedBezoutian& matrix, std::uint64_t seed, const Context& context) {
  return principal_minor(matrix, indices(0, matrix.size()), seed, context);
}

Polynomial self_intersection_determinant(const SeparatedBezoutian& matrix, std::uint64_t seed, const Context& context) {
  if (matrix.size() < 2) return Polynomial::constant(2, 1);
  const std::vector<std::size_t> rows = indices(1, matrix.size());
  MinorInterpolation interpolation(matrix, rows, rows);
  // The minor without the last row is the same times u^(2 (m - 1)) v^(2 (n - 1)).
  const std::vector<std::size_t> others = indices(0, matrix.size() - 1);
  const Degrees last = MinorInterpolation(matrix, others, others).degrees();
  const std::size_t of_u = 2 * (matrix.second_degree() - 1);
  const std::size_t of_t = 2 * (matrix.first_degree() - 1);
  interpolation.limit_degrees({last.u > of_u ? last.u - of_u : 0, last.t > of_t ? last.t - of_t : 0});
  return interpolation.reconstruct(seed, context);
}

GenericRank generic_rank_modulo(const SeparatedBezoutian& matrix, std::uint64_t seed) {
  const PrimeField field(PrimeSequence(mix(seed, 1)).next());
  const mp_limb_t u = mix(seed, 2) % field.prime();
  const mp_limb_t t = mix(seed, 3) % field.prime();
  const auto at = [&](const UnivariatePolynomial& f, mp_limb_t x) {
    ModularPolynomial reduced(field);
    fmpz_poly_get_nmod_poly(reduced.get(), f.get());
    return nmod_poly_evaluate_nmod(reduced.get(), x);
  };
  const std::size_t n = matrix.first_degree();
  const auto size = static_cast<long>(matrix.size());
  ModularMatrix value(size, size, field);
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j)
      for (std::size_t c = 0; c < coordinates; ++c) {
        mp_limb_t& entry = value(static_cast<long>(i), static_cast<long>(j));
        entry = field.add(entry, field.multiply(at(matrix.first_lines(i % n, j % n)[c], u),
                                                at(matrix.second_lines(i / n, j / n)[c], t)));
      }
  // Pivot columns of the row echelon form: of a symmetric matrix the same rows and columns give a regular minor.
  GenericRank result;
  result.rank = static_cast<std::size_t>(nmod_mat_rref(value.get()));
  for (std::size_t i = 0; i < result.rank; ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j)
      if (value(static_cast<long>(i), static_cast<long>(j)) != 0) {
        result.rows.push_back(j);
        break;
      }
  return result;
}

}  // namespace eliminant::symbolic
