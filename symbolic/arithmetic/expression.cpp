// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/expression.hpp>

#include <string>

namespace eliminant::symbolic {

namespace {

// Combines neighbours pairwise until one is left: n operands of length L cost O(M(nL) log n), where one after the other
// would cost n times the length of the result.
template <class Value, class Combine>
Value combine_balanced(std::vector<Value> values, Combine combine) {
  while (values.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); i += 2) {
      values[kept] = i + 1 < values.size() ? combine(values[i], values[i + 1]) : std::move(values[i]);
      ++kept;
    }
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(kept), values.end());
  }
  return std::move(values.front());
}

Rational rational_power(const Rational& base, std::uint64_t exponent) {
  return Rational(power(base.numerator(), exponent), power(base.denominator(), exponent));
}

}  // namespace

Expression::Expression(std::size_t variable_count, const Limits& limits)
    : variable_count_(variable_count), limits_(limits), bounds_(variable_count, limits) {}

Expression::Node Expression::add(NodeData data) {
  nodes_.push_back(std::move(data));
  return static_cast<Node>(nodes_.size() - 1);
}

Expression::Node Expression::add_parent(Kind kind, std::span<const Node> children, std::uint64_t exponent,
                                        ExpressionSize size) {
  const auto first = static_cast<std::uint32_t>(child_lists_.size());
  child_lists_.insert(child_lists_.end(), children.begin(), children.end());
  return add({kind, first, static_cast<std::uint32_t>(children.size()), exponent, std::move(size)});
}

std::span<const Expression::Node> Expression::children_of(const NodeData& data) const {
  return std::span(child_lists_).subspan(data.index, data.children);
}

void Expression::charge(const ExpressionSize& size) {
  charged_bits_ = saturating_sum(charged_bits_, size.total_bits);
  if (charged_bits_ > limits_.total_bits())
    throw LimitReached("expanding the products and powers would write more than " +
                       std::to_string(limits_.total_digits) + " digits, which is the limit");
}

std::vector<const ExpressionSize*> Expression::sizes_of(std::span<const Node> nodes) const {
  std::vector<const ExpressionSize*> sizes;
  sizes.reserve(nodes.size());
  for (const Node node : nodes) sizes.push_back(&nodes_[node].size);
  return sizes;
}

Expression::Node Expression::constant(const Rational& value) {
  values_.push_back(value);
  return add({Kind::constant, static_cast<std::uint32_t>(values_.size() - 1), 0, 1, SizeBounds::of_constant(value)});
}

Expression::Node Expression::variable(std::size_t index) { return variable_power(index, 1); }

// Each power of a variable is one node, however often it occurs: a text of a million terms stays small.
Expression::Node Expression::variable_power(std::size_t index, std::uint64_t exponent) {
  const auto [entry, is_new] = variable_powers_.try_emplace({index, exponent}, 0);
  if (is_new) {
    ExpressionSize size = SizeBounds::of_variable();
    size.degree = exponent;
    entry->second = add({Kind::variable_power, static_cast<std::uint32_t>(index), 0, exponent, std::move(size)});
  }
  return entry->second;
}

Expression::Node Expression::sum(std::vector<Node> addends) {
  if (addends.size() == 1) return addends.front();
  ExpressionSize size = bounds_.of_sum(sizes_of(addends));
  std::vector<Rational> numbers;
  for (const Node addend : addends)
    if (is_constant(addend)) numbers.push_back(value(addend));
  if (numbers.size() < addends.size()) return add_parent(Kind::sum, addends, 1, std::move(size));
  return constant(combine_balanced(std::move(numbers), [](const auto& a, const auto& b) { return a + b; }));
}

Expression::Node Expression::product(const std::vector<Node>& factors) {
  if (factors.size() == 1) return factors.front();
  ExpressionSize size = bounds_.of_product(sizes_of(factors));
  std::vector<Rational> numbers;
  std::vector<Node> others;
  for (const Node factor : factors) {
    if (is_constant(factor))
      numbers.push_back(value(factor));
    else
      others.push_back(factor);
  }
  if (!numbers.empty()) {
    const Rational coefficient =
        combine_balanced(std::move(numbers), [](const auto& a, const auto& b) { return a * b; });
    if (others.empty()) return constant(coefficient);
    if (!(coefficient == Rational(1))) others.push_back(constant(coefficient));
  }
  if (others.size() == 1) return others.front();
  charge(size);
  return add_parent(Kind::product, others, 1, std::move(size));
}

Expression::Node Expression::power(Node base, std::uint64_t exponent) {
  ExpressionSize size = bounds_.of_power(nodes_[base].size, exponent);
  if (exponent == 0) return constant(1);
  if (exponent == 1) return base;
  if (is_constant(base)) return constant(rational_power(value(base), exponent));
  const NodeData& data = nodes_[base];
  if (data.kind == Kind::variable_power) return variable_power(data.index, data.exponent * exponent);
  charge(size);
  return add_parent(Kind::power, std::span(&base, 1), exponent, std::move(size));
}

Expression::Node Expression::negated(Node operand) {
  if (is_constant(operand)) return constant(-value(operand));
  return product({constant(-1), operand});
}

bool Expression::multiply_into(Polynomial::Term& term, Node node) const {
  const NodeData& data = nodes_[node];
  switch (data.kind) {
    case Kind::constant:
      term.coefficient = term.coefficient * values_[data.index];
      return true;
    case Kind::variable_power:
      term.exponents[data.index] += data.exponent;
      return true;
    case Kind::product:
      for (const Node child : children_of(data))
        if (!multiply_into(term, child)) return false;
      return true;
    default:
      return false;
  }
}

Polynomial Expression::expand(Node root) { return expand_node(root); }

Polynomial Expression::expand_sum(const NodeData& data) const {
  std::vector<Polynomial::Term> terms;
  std::vector<Polynomial> others;
  for (const Node child : children_of(data)) {
    Polynomial::Term term{1, std::vector<unsigned long>(variable_count_, 0)};
    if (multiply_into(term, child))
      terms.push_back(std::move(term));
    else
      others.push_back(expand_node(child));
  }
  others.push_back(Polynomial::from_terms(variable_count_, terms));
  return combine_balanced(std::move(others), [](const auto& a, const auto& b) { return a + b; });
}

Polynomial Expression::expand_product(const NodeData& data) const {
  Polynomial::Term monomial{1, std::vector<unsigned long>(variable_count_, 0)};
  std::vector<Polynomial> others;
  for (const Node child : children_of(data)) {
    Polynomial::Term factor{1, std::vector<unsigned long>(variable_count_, 0)};
    if (!multiply_into(factor, child)) {
      others.push_back(expand_node(child));
      continue;
    }
    monomial.coefficient = monomial.coefficient * factor.coefficient;
    for (std::size_t i = 0; i < variable_count_; ++i) monomial.exponents[i] += factor.exponents[i];
  }
  others.push_back(Polynomial::from_terms(variable_count_, std::span(&monomial, 1)));
  return combine_balanced(std::move(others), [](const auto& a, const auto& b) { return a * b; });
}

Polynomial Expression::expand_node(Node node) const {
  const NodeData& data = nodes_[node];
  switch (data.kind) {
    case Kind::constant:
      return Polynomial::constant(variable_count_, values_[data.index]);
    case Kind::sum:
      return expand_sum(data);
    case Kind::product:
      return expand_product(data);
    case Kind::power:
      return symbolic::power(expand_node(children_of(data).front()), data.exponent);
    case Kind::variable_power:
      break;
  }
  Polynomial::Term term{1, std::vector<unsigned long>(variable_count_, 0)};
  term.exponents[data.index] = data.exponent;
  return Polynomial::from_terms(variable_count_, std::span(&term, 1));
}

}  // namespace eliminant::symbolic
