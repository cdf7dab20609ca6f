// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/surface_result_words.hpp>

namespace eliminant::cli {

/// A result in the format that `options` asks for.
std::string printed(const intersect::Result& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id);
std::string printed(const intersect::CurveResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id);
std::string printed(const intersect::TopologyResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id);
std::string printed(const intersect::CylindersResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id);
std::string printed(const intersect::CylinderExtractionResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id);
std::string printed(const intersect::SurfaceResult& result, const io::SurfaceDomains& domains,
                    const io::RunOptions& options, const std::optional<io::ProblemId>& id);

}  // namespace eliminant::cli
