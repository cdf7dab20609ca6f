// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/plane_curves/certificate.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>

namespace eliminant::io {

/// The certificate as a JSON file (docs/formats.md); read_certificate gives it back.
std::string certificate_json(const intersect::Certificate& certificate);

/// Reads a certificate. Throws ParseError, InvalidInput and LimitReached with the place.
intersect::Certificate read_certificate(const std::string& text, const symbolic::Limits& limits = {});

}  // namespace eliminant::io
