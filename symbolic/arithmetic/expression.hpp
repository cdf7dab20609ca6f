// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <eliminant/symbolic/arithmetic/expression_size.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// An expression tree over Q and variables that is bounded while it is built and expanded only on demand: the size of
/// every node is known, and within the limits, before any product or power of polynomials is computed. Subtrees without
/// variables are numbers at once. Every building function throws LimitReached, without a place.
class Expression {
 public:
  using Node = std::uint32_t;

  Expression(std::size_t variable_count, const Limits& limits);

  Node constant(const Rational& value);
  Node variable(std::size_t index);
  Node sum(std::vector<Node> addends);
  Node product(const std::vector<Node>& factors);
  Node power(Node base, std::uint64_t exponent);
  Node negated(Node operand);

  /// Whether no variable occurs in it (also where all of them would cancel, only x^0 counts as a number).
  bool is_constant(Node node) const { return nodes_[node].kind == Kind::constant; }
  /// The value of a constant node.
  const Rational& value(Node node) const { return values_[nodes_[node].index]; }

  Polynomial expand(Node root);

 private:
  enum class Kind : std::uint8_t { constant, variable_power, sum, product, power };
  struct NodeData {
    Kind kind;
    std::uint32_t index = 0;     ///< of the value, of the variable, or of the first child
    std::uint32_t children = 0;  ///< number of children
    std::uint64_t exponent = 1;
    ExpressionSize size;
  };

  Node add(NodeData data);
  Node add_parent(Kind kind, std::span<const Node> children, std::uint64_t exponent, ExpressionSize size);
  std::span<const Node> children_of(const NodeData& data) const;
  /// Charges what an expansion will write against the limit of the whole expression.
  void charge(const ExpressionSize& size);
  Node variable_power(std::size_t index, std::uint64_t exponent);
  std::vector<const ExpressionSize*> sizes_of(std::span<const Node> nodes) const;

  Polynomial expand_sum(const NodeData& data) const;
  Polynomial expand_product(const NodeData& data) const;
  Polynomial expand_node(Node node) const;
  /// Multiplies `node` into `term` if it is a number, a power of a variable, or a product of such.
  bool multiply_into(Polynomial::Term& term, Node node) const;

  std::size_t variable_count_;
  Limits limits_;
  SizeBounds bounds_;
  std::uint64_t charged_bits_ = 0;
  std::vector<NodeData> nodes_;
  std::vector<Node> child_lists_;
  std::vector<Rational> values_;
  std::map<std::pair<std::size_t, std::uint64_t>, Node> variable_powers_;
};

}  // namespace eliminant::symbolic
