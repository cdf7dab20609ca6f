// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// The topology of a plane curve as JSON, format 1 (docs/formats.md). `id` is the one of the problem.
std::string curve_topology_json(const intersect::TopologyResult& result, const std::optional<ProblemId>& id);

}  // namespace eliminant::io
