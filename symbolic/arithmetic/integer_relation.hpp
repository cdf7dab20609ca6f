// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/integer.hpp>

namespace eliminant::symbolic {

/// Small integers c, not all zero, with a small sum of c_i x_i: a likely relation between real numbers that are the
/// integers given, rounded, after a multiplication by a large power of two. Proves nothing. Source: the first vector of
/// a basis reduced by the algorithm of Lenstra, Lenstra and Lovász [LenstraLenstraLovasz1982].
std::vector<Integer> integer_relation(const std::vector<Integer>& numbers);

}  // namespace eliminant::symbolic
