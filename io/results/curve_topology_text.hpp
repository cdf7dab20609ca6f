// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/io/input/run_options.hpp>

namespace eliminant::io {

/// The topology of a plane curve for people: what it consists of, its vertices, its edges.
std::string curve_topology_text(const intersect::TopologyResult& result, const RunOptions& options);

}  // namespace eliminant::io
