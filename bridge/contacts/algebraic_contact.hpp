// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// The parameters (u, v, s, t) of a point in which two patches touch, real algebraic numbers, each within 2^-150 of the
/// rational number returned, and equal to one that is 0 or 1; proven, as long as the second patch is immersed there.
/// `near` are the parameters in doubles, at a simple zero of the conditions of a contact (contact_conditions).
///
/// Newton's method in numbers of 640 bits; lattice reduction recognises the minimal polynomial of a combination of the
/// parameters and each of them as a polynomial in it, of degree at most eight; exact division proves that both patches
/// touch at all of its roots (symbolic::touch_at_roots), and a change of sign that one of them is here. nullopt where
/// that does not succeed.
std::optional<std::array<symbolic::Rational, 4>> algebraic_contact(const ControlNet& first, const ControlNet& second,
                                                                   const ExactNet& exact_first,
                                                                   const ExactNet& exact_second,
                                                                   const std::array<double, 4>& near);

}  // namespace eliminant::bridge
