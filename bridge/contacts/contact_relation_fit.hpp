// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/symbolic/elimination/contact_identity.hpp>

namespace eliminant::bridge {

/// The relation of low degree with simple rational coefficients that points (a, b, c, d) satisfy as far as doubles can
/// tell: a curve in (a, b), and c and d as quotients of polynomials in them. nullopt where there is none. Proves
/// nothing: symbolic/elimination/contact_identity does.
std::optional<symbolic::ContactRelation> contact_relation_fit(const std::vector<std::array<double, 4>>& points);

}  // namespace eliminant::bridge
