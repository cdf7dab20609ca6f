// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/control_points_input.hpp>

#include <algorithm>
#include <charconv>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/symbolic/arithmetic/expression_size.hpp>

namespace eliminant::io {

namespace {

using Kind = JsonValue::Kind;
using symbolic::Integer;
using symbolic::Rational;

// Binary length of rationals over their common denominator, which is not computed beyond `most_bits`.
class CommonSize {
 public:
  explicit CommonSize(std::size_t most_bits) : most_bits_(most_bits) {}
  void add(const Rational& value) {
    numerator_bits_ = std::max<std::uint64_t>(numerator_bits_, value.numerator().bit_length());
    if (denominator_.bit_length() > most_bits_) return;
    fmpz_lcm(denominator_.get(), denominator_.get(), fmpq_denref(value.get()));
  }
  std::uint64_t bits() const { return numerator_bits_ + denominator_.bit_length(); }

 private:
  std::size_t most_bits_;
  std::uint64_t numerator_bits_ = 0;
  Integer denominator_{1};
};

}  // namespace

std::size_t degree_from_json(const JsonFields& fields, const JsonValue& value, const std::string& what) {
  const auto largest = static_cast<long>(fields.limits().degree);
  long degree = 0;
  const char* const end = value.text.data() + value.text.size();
  const auto parsed = std::from_chars(value.text.data(), end, degree);
  const bool number = value.kind == Kind::number || value.kind == Kind::text;
  const bool beyond = parsed.ec == std::errc::result_out_of_range && !value.text.starts_with('-');
  if (number && parsed.ptr == end && (beyond || (parsed.ec == std::errc() && degree > largest)))
    throw LimitReached(what + " is " + value.text.substr(0, 40) + ", beyond the limit of " + std::to_string(largest),
                       fields.document().place_of(value));
  return static_cast<std::size_t>(fields.integer(value, what, 1, largest));
}

std::array<std::size_t, 2> degree_pair_from_json(const JsonFields& fields, const JsonValue& value) {
  const std::string what = "the degree of a surface";
  if (value.kind != Kind::array) fields.refuse(value, what, "two whole numbers such as [3, 3]");
  if (value.elements.size() != 2)
    throw InvalidInput(what + " is an array of " + std::to_string(value.elements.size()) + " values",
                       "two whole numbers such as [3, 3]", fields.document().place_of(value));
  const std::array<std::size_t, 2> degrees{degree_from_json(fields, value.elements[0], "the first degree"),
                                           degree_from_json(fields, value.elements[1], "the second degree")};
  if (degrees[0] + degrees[1] > fields.limits().degree)
    throw LimitReached("the degrees of a surface add up to " + std::to_string(degrees[0] + degrees[1]) +
                           ", beyond the limit of " + std::to_string(fields.limits().degree),
                       fields.document().place_of(value));
  return degrees;
}

std::vector<Rational> numbers_from_json(const JsonFields& fields, const JsonValue& value, const std::string& what,
                                        const std::string& element) {
  std::vector<Rational> numbers;
  for (const JsonValue& number : fields.array(value, what))
    numbers.push_back(named(element, [&] { return fields.number(number, element); }));
  return numbers;
}

std::vector<Rational> point_from_json(const JsonFields& fields, const JsonValue& value, std::size_t lowest) {
  const std::string expected = lowest == 2 ? "[x, y], [x, y, z] or [x, y, z, w]" : "[x, y, z] or [x, y, z, w]";
  if (value.kind != Kind::array) fields.refuse(value, "a control point", expected);
  if (value.elements.size() < lowest || value.elements.size() > 4)
    throw InvalidInput("a control point has " + std::to_string(value.elements.size()) + " numbers", expected,
                       fields.document().place_of(value));
  return numbers_from_json(fields, value, "a control point", "a coordinate of a control point");
}

symbolic::ControlPoint with_own_weight(std::vector<Rational> numbers) {
  for (std::size_t i = 0; i + 1 < numbers.size(); ++i) numbers[i] = numbers[i] * numbers.back();
  return numbers;
}

symbolic::ControlPoint with_weight(std::vector<Rational> coordinates, const Rational& weight) {
  coordinates.push_back(weight);
  return with_own_weight(std::move(coordinates));
}

void require_a_weight(const JsonFields& fields, const JsonValue& value,
                      std::span<const symbolic::ControlPoint> points) {
  if (std::all_of(points.begin(), points.end(), [](const auto& point) { return point.back().is_zero(); }))
    throw InvalidInput("all weights are zero", "a weight that is not zero", fields.document().place_of(value));
}

void require_few_points(const JsonFields& fields, const JsonValue& value, std::size_t count) {
  if (count > most_control_points)
    throw LimitReached(
        std::to_string(count) + " control points, beyond the limit of " + std::to_string(most_control_points),
        fields.document().place_of(value));
}

void require_moderate_size(const JsonFields& fields, const JsonValue& value,
                           std::span<const symbolic::ControlPoint> points, std::span<const Rational> knots,
                           std::size_t degree, std::size_t coefficients) {
  const symbolic::Limits& limits = fields.limits();
  CommonSize of_points(limits.coefficient_bits());
  for (const symbolic::ControlPoint& point : points)
    for (const Rational& coordinate : point) of_points.add(coordinate);
  CommonSize of_knots(limits.coefficient_bits());
  for (const Rational& knot : knots) of_knots.add(knot);
  // Binomial coefficients have `degree` bits; each round of knot insertion and each power of the parameter brings in
  // knots. Every coefficient passes through `degree` additions, those of knot insertion of fractions.
  using symbolic::saturating_product;
  using symbolic::saturating_sum;
  const std::uint64_t bits_of_a_round = knots.empty() ? 2 : saturating_sum(2, 2 * of_knots.bits());
  const std::uint64_t bits = saturating_sum(of_points.bits(), saturating_product(degree, bits_of_a_round));
  const std::uint64_t total = saturating_product(coefficients, bits);
  constexpr std::uint64_t most_additions_of_everything = 200;
  const std::uint64_t most_coefficients = 4 * limits.terms;
  const std::uint64_t most_fractions = 5 * limits.terms;
  if (coefficients > most_coefficients || total > limits.total_bits() ||
      (!knots.empty() && saturating_product(coefficients, degree) > most_fractions) ||
      saturating_product(total, degree) > most_additions_of_everything * limits.total_bits())
    throw LimitReached("the polynomials of these control points would be too large", fields.document().place_of(value));
}

}  // namespace eliminant::io
