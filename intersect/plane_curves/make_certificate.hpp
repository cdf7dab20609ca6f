// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/plane_curves/certificate.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/plane_curves/solution_set.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>

namespace eliminant::intersect {

/// Writes down what is known of all solutions, with as many digits as check_certificate needs to accept it; it has been
/// asked. `set` holds every solution of the cofactors of `split`, proven; nullptr when a cofactor is constant. nullopt
/// when no number of digits within reason suffices.
std::optional<Certificate> make_certificate(const PlaneCurvesProblem& problem, const symbolic::CommonComponent& split,
                                            SolutionSet* set, const Context& context);

}  // namespace eliminant::intersect
