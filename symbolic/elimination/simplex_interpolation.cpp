// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/simplex_interpolation.hpp>

#include <numeric>
#include <utility>

namespace eliminant::symbolic {

namespace {

using Lattice = std::vector<std::vector<unsigned long>>;

/// All points that begin as `point` before the coordinate `next`, the others adding up to at most `rest`.
void add_points(Lattice& lattice, std::vector<unsigned long>& point, std::size_t next, unsigned long rest) {
  if (next == point.size()) {
    lattice.push_back(point);
    return;
  }
  for (unsigned long i = 0; i <= rest; ++i) {
    point[next] = i;
    add_points(lattice, point, next + 1, rest - i);
  }
  point[next] = 0;
}

/// For each line of the lattice in the direction of one axis, the positions of its points, from 0 upwards.
std::vector<std::vector<std::size_t>> lines_along(const Lattice& lattice, std::size_t axis, unsigned long degree) {
  // Positions in a cube of (degree + 1)^m points; one step along the axis is a stride there.
  const std::size_t side = degree + 1;
  const auto cell = [&](const std::vector<unsigned long>& point) {
    return std::accumulate(point.begin(), point.end(), std::size_t{0},
                           [&](std::size_t sum, unsigned long i) { return sum * side + i; });
  };
  std::size_t cells = 1;
  std::size_t stride = 1;
  for (std::size_t k = 0; k < lattice.front().size(); ++k) {
    cells *= side;
    if (k > axis) stride *= side;
  }
  std::vector<std::size_t> position(cells);
  for (std::size_t i = 0; i < lattice.size(); ++i) position[cell(lattice[i])] = i;
  std::vector<std::vector<std::size_t>> lines;
  for (const std::vector<unsigned long>& point : lattice) {
    if (point[axis] != 0) continue;
    const std::size_t first = cell(point);
    const unsigned long length = degree - std::accumulate(point.begin(), point.end(), 0UL);
    std::vector<std::size_t> line;
    line.reserve(length + 1);
    for (unsigned long i = 0; i <= length; ++i) line.push_back(position[first + i * stride]);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::vector<std::vector<unsigned long>> simplex_lattice(std::size_t dimension, unsigned long degree) {
  Lattice lattice;
  std::vector<unsigned long> point(dimension, 0);
  add_points(lattice, point, 0, degree);
  return lattice;
}

std::vector<mp_limb_t> interpolate_on_simplex(const PrimeField& field, const std::vector<mp_limb_t>& origin,
                                              unsigned long degree, const std::vector<mp_limb_t>& values) {
  const Lattice lattice = simplex_lattice(origin.size(), degree);
  std::vector<mp_limb_t> inverses{0};
  for (unsigned long i = 1; i <= degree; ++i) inverses.push_back(field.inverse(i));
  std::vector<mp_limb_t> result = values;
  std::vector<std::vector<std::vector<std::size_t>>> lines;
  for (std::size_t axis = 0; axis < origin.size(); ++axis) {
    lines.push_back(lines_along(lattice, axis, degree));
    for (const std::vector<std::size_t>& line : lines.back())
      for (std::size_t level = 1; level < line.size(); ++level)
        for (std::size_t j = line.size() - 1; j >= level; --j)
          result[line[j]] = field.multiply(field.subtract(result[line[j]], result[line[j - 1]]), inverses[level]);
  }
  // From Newton's basis to powers, by Horner's rule.
  for (std::size_t axis = 0; axis < origin.size(); ++axis)
    for (const std::vector<std::size_t>& line : lines[axis])
      for (std::size_t j = line.size() - 1; j-- > 0;) {
        const mp_limb_t node = field.add(origin[axis], j);
        for (std::size_t i = j; i + 1 < line.size(); ++i)
          result[line[i]] = field.subtract(result[line[i]], field.multiply(node, result[line[i + 1]]));
      }
  return result;
}

}  // namespace eliminant::symbolic
