// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <eliminant/intersect/curve_surface/surface_representation.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>

namespace eliminant::io {

/// A matrix representation as rows of linear forms in x, y, z, w (in the plane x, y, w), written as text.
nlohmann::ordered_json matrix_json(const symbolic::MatrixRepresentation& m);

/// The linear forms of a matrix representation, row by row.
std::vector<std::vector<std::string>> linear_forms(const symbolic::MatrixRepresentation& m);

/// The row monomials, "s^2*t", in these parameters.
std::vector<std::string> monomial_texts(const symbolic::MatrixRepresentation& m,
                                        const std::vector<std::string>& parameters);

/// The names of homogeneous coordinates: x, y, z, w, or x, y, w when there are three.
const std::vector<std::string>& coordinate_names(std::size_t count);

/// Adds the coordinates of the map as fields x, y, z, w, in s, t or s, t, u.
void add_map(nlohmann::ordered_json& out, const symbolic::RationalSurface& surface);

/// A surface with its representation as JSON (docs/formats.md): read_representation gives the same back, exactly.
std::string representation_json(const intersect::SurfaceRepresentation& representation);

/// Reads what representation_json has written, or anybody else. The columns are checked to be moving planes of the
/// surface; the degree is believed. Throws ParseError, InvalidInput and LimitReached with the place in `text`.
intersect::SurfaceRepresentation read_representation(const std::string& text, const symbolic::Limits& limits = {});

}  // namespace eliminant::io
