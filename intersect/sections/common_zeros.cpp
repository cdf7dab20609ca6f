// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/common_zeros.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;
using symbolic::Rational;

constexpr std::size_t most_boxes = 50000;
constexpr int most_halvings = 80;

/// Bernstein coefficients on a box, of u^i v^j at i (n + 1) + j.
struct Bernstein {
  std::array<std::size_t, 2> degrees{};
  std::vector<DoubleInterval> coefficients;

  DoubleInterval range() const {
    DoubleInterval result = coefficients.front();
    for (const DoubleInterval& c : coefficients) result = hull(result, c);
    return result;
  }

  /// On the lower and the upper half, by de Casteljau's algorithm.
  std::array<Bernstein, 2> halves(std::size_t axis) const {
    std::array<Bernstein, 2> result{*this, *this};
    const std::size_t step = axis == 0 ? degrees[1] + 1 : 1;
    const std::size_t lines = axis == 0 ? degrees[1] + 1 : degrees[0] + 1;
    const std::size_t degree = degrees[axis];
    for (std::size_t line = 0; line < lines; ++line) {
      const std::size_t start = axis == 0 ? line : line * (degrees[1] + 1);
      std::vector<DoubleInterval>& upper = result[1].coefficients;
      for (std::size_t level = 0; level <= degree; ++level) {
        result[0].coefficients[start + level * step] = upper[start];
        for (std::size_t i = 0; i + level < degree; ++i)
          upper[start + i * step] = (upper[start + i * step] + upper[start + (i + 1) * step]) * DoubleInterval(0.5);
      }
    }
    return result;
  }
};

/// Coefficients of powers, row by row.
using Powers = std::vector<Rational>;

Powers powers_in_chart(const BidegreeForm& form, const std::array<bool, 2>& inverted) {
  const auto rows = static_cast<std::size_t>(form.degrees[0]);
  const auto columns = static_cast<std::size_t>(form.degrees[1]);
  Powers result((rows + 1) * (columns + 1));
  for (const auto& term : form.polynomial.terms()) {
    const std::size_t i = inverted[0] ? rows - term.exponents[0] : term.exponents[0];
    const std::size_t j = inverted[1] ? columns - term.exponents[1] : term.exponents[1];
    result[i * (columns + 1) + j] = term.coefficient;
  }
  return result;
}

/// Along one line of coefficients: from powers of x in [0, 1] to Bernstein form.
void to_bernstein(Powers& c, std::size_t start, std::size_t step, std::size_t degree) {
  // c_k / binomial(degree, k), then sums of sums.
  Rational binomial(1);
  for (std::size_t k = 0; k <= degree; ++k) {
    c[start + k * step] = c[start + k * step] / binomial;
    binomial = binomial * Rational(static_cast<long>(degree - k)) / Rational(static_cast<long>(k + 1));
  }
  for (std::size_t level = 1; level <= degree; ++level)
    for (std::size_t k = degree; k >= level; --k) c[start + k * step] = c[start + k * step] + c[start + (k - 1) * step];
}

/// On the quarter of the chart's square [-1, 1]^2 with these signs: the parameters are sign times x, x in [0, 1].
Bernstein on_quarter(Powers c, const std::array<long, 2>& degrees, const std::array<int, 2>& sign) {
  Bernstein result;
  result.degrees = {static_cast<std::size_t>(degrees[0]), static_cast<std::size_t>(degrees[1])};
  const std::size_t width = result.degrees[1] + 1;
  Rational largest(0);
  for (std::size_t k = 0; k < c.size(); ++k) {
    const bool negated = (sign[0] < 0 && (k / width) % 2 == 1) != (sign[1] < 0 && (k % width) % 2 == 1);
    if (negated) c[k] = -c[k];
    const Rational size = c[k].sign() < 0 ? -c[k] : c[k];
    if (largest < size) largest = size;
  }
  for (std::size_t i = 0; i <= result.degrees[0]; ++i) to_bernstein(c, i * width, 1, result.degrees[1]);
  for (std::size_t j = 0; j < width; ++j) to_bernstein(c, j, width, result.degrees[0]);
  if (largest.is_zero()) largest = Rational(1);
  for (const Rational& value : c) result.coefficients.push_back(enclose(value / largest));
  return result;
}

struct Box {
  std::vector<Bernstein> forms;
  /// Second derivatives (uu, uv, vv) of the first form, where one corner is a zero of order two that may be ignored.
  std::vector<Bernstein> hessian;
  bool at_corner = false;
  int halvings = 0;
};

bool is_excluded(const Box& box) {
  if (std::any_of(box.forms.begin(), box.forms.end(),
                  [](const Bernstein& form) { return form.range().excludes_zero(); }))
    return true;
  if (!box.at_corner || box.hessian.empty()) return false;
  const DoubleInterval mixed = box.hessian[1].range();
  const DoubleInterval determinant = box.hessian[0].range() * box.hessian[2].range() - mixed * mixed;
  return determinant.lower > 0;
}

Polynomial polynomial_of(const Powers& c, const std::array<long, 2>& degrees) {
  std::vector<Polynomial::Term> terms;
  const auto width = static_cast<std::size_t>(degrees[1] + 1);
  for (std::size_t k = 0; k < c.size(); ++k)
    if (!c[k].is_zero()) terms.push_back({c[k], {k / width, k % width}});
  return Polynomial::from_terms(2, terms);
}

/// The Hessian of the first form in the chart on a quarter, where its origin is a zero of order two to be ignored.
/// One scale for all three, so that the sign of the determinant is right.
std::vector<Bernstein> hessian_at_origin(const BidegreeForm& form, const std::array<bool, 2>& inverted,
                                         const std::array<int, 2>& sign) {
  const Polynomial p = polynomial_of(powers_in_chart(form, inverted), form.degrees);
  if (!p.constant_term().is_zero() || !p.derivative(0).constant_term().is_zero() ||
      !p.derivative(1).constant_term().is_zero())
    return {};
  Rational largest(1);
  for (const auto& term : p.terms()) {
    const Rational size = term.coefficient.sign() < 0 ? -term.coefficient : term.coefficient;
    if (largest < size) largest = size;
  }
  std::vector<Bernstein> result;
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 0}, {0, 1}, {1, 1}}) {
    const BidegreeForm derivative{p.derivative(i).derivative(j), form.degrees};
    Powers c = powers_in_chart(derivative, {false, false});
    // Each is divided by its own largest coefficient below; undo that by a common one.
    Rational own(0);
    for (const Rational& value : c) {
      const Rational size = value.sign() < 0 ? -value : value;
      if (own < size) own = size;
    }
    Bernstein bernstein = on_quarter(std::move(c), form.degrees, sign);
    const DoubleInterval scale = enclose(own / largest);
    for (DoubleInterval& value : bernstein.coefficients) value = value * scale;
    result.push_back(std::move(bernstein));
  }
  return result;
}

bool vanish_at_origin(const std::vector<BidegreeForm>& forms, const std::array<bool, 2>& inverted) {
  return !forms.empty() && std::all_of(forms.begin(), forms.end(), [&](const BidegreeForm& form) {
    return powers_in_chart(form, inverted).front().is_zero();
  });
}

/// The pieces of a box, split in one direction: the corner stays with the lower one.
std::array<Box, 2> halves(const Box& box) {
  const auto axis = static_cast<std::size_t>(box.halvings % 2);
  std::array<Box, 2> result;
  for (const bool of_hessian : {false, true})
    for (const Bernstein& form : of_hessian ? box.hessian : box.forms) {
      std::array<Bernstein, 2> parts = form.halves(axis);
      for (std::size_t k = 0; k < 2; ++k) {
        if (of_hessian && k == 1) continue;
        (of_hessian ? result[k].hessian : result[k].forms).push_back(std::move(parts[k]));
      }
    }
  result[0].at_corner = box.at_corner;
  for (Box& half : result) half.halvings = box.halvings + 1;
  return result;
}

}  // namespace

bool have_no_common_real_zero(const std::vector<BidegreeForm>& forms, const std::vector<BidegreeForm>& ignored,
                              const Context& context) {
  std::vector<Box> open;
  for (const std::array<bool, 2>& inverted :
       {std::array{false, false}, std::array{false, true}, std::array{true, false}, std::array{true, true}})
    for (const std::array<int, 2>& sign :
         {std::array{1, 1}, std::array{1, -1}, std::array{-1, 1}, std::array{-1, -1}}) {
      Box box;
      for (const BidegreeForm& form : forms)
        box.forms.push_back(on_quarter(powers_in_chart(form, inverted), form.degrees, sign));
      if (vanish_at_origin(ignored, inverted)) {
        box.hessian = hessian_at_origin(forms.front(), inverted, sign);
        box.at_corner = true;
      }
      open.push_back(std::move(box));
    }
  std::size_t seen = 0;
  while (!open.empty()) {
    const Box box = std::move(open.back());
    open.pop_back();
    if (is_excluded(box)) continue;
    if (++seen > most_boxes || box.halvings >= most_halvings) return false;
    if (seen % 64 == 0) context.checkpoint("exclusion of points without one pair of parameters");
    for (Box& half : halves(box)) open.push_back(std::move(half));
  }
  return true;
}

}  // namespace eliminant::intersect
