// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/curves/curve_result.hpp>

namespace eliminant::io {

/// One line for each solution under the header
///   curve_surface: t_re,t_im,x_re,x_im,...,w_im,radius,real,multiplicity,inside,certified,a_re,a_im,...,c_im
///   curve_curve:   t_re,t_im,u_re,u_im,x_re,x_im,...,w_im,radius,real,multiplicity,inside,certified
///   self_intersection: the same, and kind
/// in the plane without z. (a, b), of a triangular surface (a : b : c), is the first preimage. Infinity is inf,0; what
/// there is not is empty. `real` is true, false or undecided. Status, counts, overlaps and further preimages are only
/// in the other formats.
std::string curve_result_csv(const intersect::CurveResult& result);

}  // namespace eliminant::io
