// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/printed_result.hpp>

#include <eliminant/io/results/curve_result_csv.hpp>
#include <eliminant/io/results/curve_result_json.hpp>
#include <eliminant/io/results/curve_result_text.hpp>
#include <eliminant/io/results/curve_topology_csv.hpp>
#include <eliminant/io/results/curve_topology_json.hpp>
#include <eliminant/io/results/curve_topology_text.hpp>
#include <eliminant/io/results/cylinder_extraction_csv.hpp>
#include <eliminant/io/results/cylinder_extraction_json.hpp>
#include <eliminant/io/results/cylinder_extraction_text.hpp>
#include <eliminant/io/results/cylinders_csv.hpp>
#include <eliminant/io/results/cylinders_json.hpp>
#include <eliminant/io/results/cylinders_text.hpp>
#include <eliminant/io/results/result_csv.hpp>
#include <eliminant/io/results/result_json.hpp>
#include <eliminant/io/results/result_text.hpp>
#include <eliminant/io/results/surface_result_csv.hpp>
#include <eliminant/io/results/surface_result_json.hpp>
#include <eliminant/io/results/surface_result_text.hpp>

namespace eliminant::cli {

std::string printed(const intersect::Result& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id) {
  if (options.format == io::Format::json) return io::result_json(result, id);
  return options.format == io::Format::csv ? io::result_csv(result) : io::result_text(result, options);
}

std::string printed(const intersect::CurveResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id) {
  if (options.format == io::Format::json) return io::curve_result_json(result, id);
  return options.format == io::Format::csv ? io::curve_result_csv(result) : io::curve_result_text(result, options);
}

std::string printed(const intersect::TopologyResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id) {
  if (options.format == io::Format::json) return io::curve_topology_json(result, id);
  return options.format == io::Format::csv ? io::curve_topology_csv(result) : io::curve_topology_text(result, options);
}

std::string printed(const intersect::CylindersResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id) {
  if (options.format == io::Format::json) return io::cylinders_json(result, id);
  return options.format == io::Format::csv ? io::cylinders_csv(result) : io::cylinders_text(result, options);
}

std::string printed(const intersect::CylinderExtractionResult& result, const io::RunOptions& options,
                    const std::optional<io::ProblemId>& id) {
  const long digits = options.solve.digits;
  if (options.format == io::Format::json) return io::cylinder_extraction_json(result, id, digits);
  return options.format == io::Format::csv ? io::cylinder_extraction_csv(result, digits)
                                           : io::cylinder_extraction_text(result);
}

std::string printed(const intersect::SurfaceResult& result, const io::SurfaceDomains& domains,
                    const io::RunOptions& options, const std::optional<io::ProblemId>& id) {
  if (options.format == io::Format::json) return io::surface_result_json(result, domains, id, options.solve.equation);
  return options.format == io::Format::csv ? io::surface_result_csv(result) : io::surface_result_text(result, options);
}

}  // namespace eliminant::cli
