// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <eliminant/bridge/contacts/contact_series.hpp>
#include <eliminant/bridge/nets/bernstein_subdivision.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A common point at rational parameters, proven by exact substitution.
struct RationalZero {
  /// Of the first, then of the second; the third is 0 for two curves.
  std::array<symbolic::Rational, 3> parameters;
  /// Intersection multiplicity: the order in which the difference of the two vanishes along the first, exactly.
  unsigned long multiplicity = 1;
  /// There is no other common point with parameters in that box.
  OpenBox alone_in;
};

/// The nearest doubles, or next to them, of parameters of at most 1 in absolute value, with a bound of the error: 0
/// where they are exact.
IsolatedZero rounded_parameters(const std::array<symbolic::Rational, 3>& parameters);

/// Recognises common points at rational parameters of a Bezier curve and a patch, or of two plane curves.
class ContactProver {
 public:
  using Exact = std::function<const ExactNet&()>;

  /// The nets of the subdivision, and what they were rounded from, asked for when it is needed. All must outlive the
  /// object.
  ContactProver(const ControlNet& first, const ControlNet& second, Exact exact_first, Exact exact_second)
      : first_(first), second_(second), exact_first_(std::move(exact_first)), exact_second_(std::move(exact_second)) {}

  /// Looks for a contact within `reach` of these parameters: Newton's steps on the derivative of the distance find it
  /// in doubles, continued fractions its parameters, substitution proves that k derivatives of the distance vanish, and
  /// the k-th has one sign on the box returned, so that by Rolle's theorem there are no other common points. nullopt
  /// when any of this fails: no contact, one known already or at irrational parameters, a singular point of the second.
  std::optional<OpenBox> find(const std::array<double, 3>& near, double reach);

  /// Those that were found.
  const std::vector<RationalZero>& contacts() const { return contacts_; }

  /// The parameters of a simple zero where they are rational with small denominators.
  std::optional<std::array<symbolic::Rational, 3>> exact_zero(const IsolatedZero& zero) const;

 private:
  bool is_common_point(const std::array<symbolic::Rational, 3>& parameters) const;
  /// Taylor coefficients at a common point.
  struct ExactTables {
    TaylorTable<symbolic::Rational> first;
    TaylorTable<symbolic::Rational> second;
  };
  static bool vanishes_to(const ExactTables& tables, std::size_t normal, std::size_t order);
  /// `parameters` are those of the contact, rounded.
  std::optional<OpenBox> alone_around(const ExactTables& tables, const std::array<double, 3>& parameters,
                                      std::size_t order, const std::array<double, 2>& slopes) const;

  const ControlNet& first_;
  const ControlNet& second_;
  Exact exact_first_;
  Exact exact_second_;
  std::vector<RationalZero> contacts_;
};

}  // namespace eliminant::bridge
