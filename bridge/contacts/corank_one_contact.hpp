// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// A contact of two patches where the height h of one over the other has a Hessian of rank one, an A_(m-1) singularity:
/// in coordinates x and y - r(x) of (u, v) it is a y^2 + c x^m + ..., exactly.
struct CorankOneContact {
  /// Up to that m they are told from curves of contact.
  static constexpr std::size_t highest_order = 8;

  /// x is v and y is u, else x is u and y is v.
  bool exchanged = false;
  /// m, at least 3.
  std::size_t order = 0;
  /// Coefficients of 1 (which is 0), x, x^2, ... of r, up to the degree m / 2 + 1: h_y along it is of a higher order.
  std::vector<symbolic::Rational> ridge;
};

/// What it is at the parameters (u, v, s, t) of a contact; nullopt where the Hessian has another rank, or m is above
/// `highest_order`. The second patch must be immersed there. Source: the splitting lemma
/// [ArnoldGuseinZadeVarchenko1985].
std::optional<CorankOneContact> corank_one_contact(const ExactNet& first, const ExactNet& second,
                                                   const std::array<symbolic::Rational, 4>& parameters);

/// The parameters of such contacts in or near the box, approximately; none where doubles see none. The conditions are
/// that the first derivatives of h and the derivative of order m - 1 of h along its ridge vanish, which is a simple
/// zero where Newton's method for a contact meets a multiple one.
std::vector<std::array<double, 4>> corank_one_contacts_near(const ControlNet& first, const ControlNet& second,
                                                            const CellBox& box);

}  // namespace eliminant::bridge
