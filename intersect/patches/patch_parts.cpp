// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/patch_parts.hpp>

#include <cmath>

#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>

namespace eliminant::intersect {

namespace {

using bridge::DoubleInterval;
using bridge::nearest;
using symbolic::Interval;
using symbolic::Rational;

/// Where a side is cut.
Rational fraction(std::size_t axis, std::size_t kind) {
  constexpr std::array<long, 4> places{504, 529, 521, 494};
  return Rational(places[2 * kind + axis]) / Rational(1024);
}

}  // namespace

bool apart(const PatchPart& a, const PatchPart& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) return true;
  return false;
}

PartTree::PartTree(const symbolic::SurfacePiece& patch, std::size_t kind,
                   const std::optional<std::array<Rational, 3>>& origin)
    : patch_(patch), kind_(kind) {
  const PreparedNet whole = prepared_patch(patch, "");
  rounded_ = whole.rounded(origin.value_or(whole.origin()));
  add({Interval{Rational(0), Rational(1)}, Interval{Rational(0), Rational(1)}});
}

std::size_t PartTree::add(const std::array<Interval, 2>& sides) {
  PatchPart part;
  part.sides = sides;
  for (std::size_t k = 0; k < 2; ++k) {
    // Neighbours have the same rounded sides, and touch.
    part.rectangle.lower[k] = nearest(sides[k].lower);
    part.rectangle.upper[k] = nearest(sides[k].upper);
  }
  part.lower.fill(-INFINITY);
  part.upper.fill(INFINITY);
  if (rounded_) {
    bridge::ContactFrame frame;
    for (long k = 0; k < 3; ++k) frame.columns[static_cast<std::size_t>(k)][k] = 1;
    const auto table = bridge::taylor_on_box(
        *rounded_, frame,
        {{part.rectangle.lower[0], part.rectangle.lower[1], 0}, {part.rectangle.upper[0], part.rectangle.upper[1], 0}},
        0, 0);
    const auto& value = table.at(0, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const DoubleInterval x = value[k] / value[3];
      const double slack = 1e-14 * x.magnitude() + 1e-15;
      if (!std::isfinite(slack)) continue;
      part.lower[k] = x.lower - slack;
      part.upper[k] = x.upper + slack;
    }
  }
  parts_.push_back(std::move(part));
  first_child_.emplace_back();
  nets_.emplace_back();
  return parts_.size() - 1;
}

std::array<std::size_t, 4> PartTree::children(std::size_t index) {
  if (!first_child_[index]) {
    const std::array<Interval, 2> sides = parts_[index].sides;
    std::array<std::array<Interval, 2>, 2> halves;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational cut = sides[axis].lower + fraction(axis, kind_) * (sides[axis].upper - sides[axis].lower);
      halves[axis] = {Interval{sides[axis].lower, cut}, Interval{cut, sides[axis].upper}};
    }
    const std::size_t first = parts_.size();
    for (const Interval& u : halves[0])
      for (const Interval& v : halves[1]) add({u, v});
    first_child_[index] = first;
  }
  const std::size_t first = *first_child_[index];
  return {first, first + 1, first + 2, first + 3};
}

const PreparedNet& PartTree::net(std::size_t index) {
  if (!nets_[index]) {
    symbolic::SurfacePiece piece = patch_;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Interval& whole = patch_.region->sides[axis];
      const Interval& side = parts_[index].sides[axis];
      const Rational length = whole.upper - whole.lower;
      piece.region->sides[axis] = {whole.lower + side.lower * length, whole.lower + side.upper * length};
    }
    nets_[index] = prepared_patch(piece, "");
  }
  return *nets_[index];
}

}  // namespace eliminant::intersect
