// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <support/bezier_case.hpp>
#include <support/binary_numbers.hpp>

namespace eliminant::test {

/// All generated cases, family after family, the same ones at every run. A contact is planted exactly: the curve is the
/// image of a line of the parameters under the patch, or a truncation of its Taylor series, plus a multiple of q(t)^k,
/// q the minimal polynomial of the parameter and k the order.
std::vector<BezierCase> bezier_cases();

/// Those of one family; all where the name is empty.
std::vector<BezierCase> bezier_cases(const std::string& family);

/// With the parameter 1 - t on the (first) curve.
BezierCase reversed(BezierCase bezier);
/// With 1 - u for the first parameter of the patch, or for the parameter of the second curve.
BezierCase second_reversed(BezierCase bezier);
/// Two plane curves in the other order; what is planted and the overlap are parameters of the old first curve and are
/// left out.
BezierCase swapped(BezierCase bezier);

/// A problem file that says the same; the weights are not 0.
std::string problem_json(const BezierCase& bezier);

}  // namespace eliminant::test
