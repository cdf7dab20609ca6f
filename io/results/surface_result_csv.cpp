// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/surface_result_csv.hpp>

#include <eliminant/io/results/surface_result_words.hpp>

namespace eliminant::io {

std::string surface_result_csv(const intersect::SurfaceResult& result) {
  std::string out = "component,kind,u,v,s,t,x,y,z\n";
  for (std::size_t i = 0; i < result.components.size(); ++i)
    for (const intersect::SurfacePoint& point : result.components[i].points) {
      out += std::to_string(i) + "," + word_for(result.components[i].kind);
      for (const double parameter : point.parameters) out += "," + parameter_text(parameter);
      for (const double coordinate : point.point) out += "," + coordinate_text(coordinate);
      out += "\n";
    }
  return out;
}

}  // namespace eliminant::io
