// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/topology/curve_topology.hpp>

namespace eliminant::io {

/// The vertices of a plane curve as CSV (docs/formats.md); edges are in the other formats.
std::string curve_topology_csv(const intersect::TopologyResult& result);

}  // namespace eliminant::io
