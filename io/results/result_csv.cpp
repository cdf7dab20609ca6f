// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/result_csv.hpp>

#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

std::string result_csv(const intersect::Result& result) {
  std::string out = "x_re,x_im,y_re,y_im,radius,real,multiplicity,certified\n";
  for (const intersect::Solution& solution : result.solutions) {
    out += solution.x.real + "," + solution.x.imaginary + "," + solution.y.real + "," + solution.y.imaginary;
    out += "," + radius_text(solution.radius_exponent) + "," + word_for(solution.reality);
    out += "," + std::to_string(solution.multiplicity) + (solution.certified ? ",true\n" : ",false\n");
  }
  return out;
}

}  // namespace eliminant::io
