// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/patch_overlap.hpp>

#include <eliminant/intersect/overlaps/common_surface.hpp>
#include <eliminant/intersect/overlaps/shared_map.hpp>

namespace eliminant::intersect {

namespace {

PatchOverlap parts_of(const SharedMap& shared, const bridge::ControlNet& first, double tolerance) {
  PatchOverlap result;
  for (const auto& part : shared.parts) {
    const bool wide = part[0].lower < part[0].upper;
    const bool high = part[1].lower < part[1].upper;
    std::vector<DrawnCurve>& list = wide && high ? result.outlines : wide || high ? result.curves : result.points;
    list.push_back(drawn_part(first, shared.change, part, tolerance));
  }
  result.complete = shared.embedded;
  return result;
}

}  // namespace

std::optional<PatchOverlap> patch_overlap(const PatchNets& first, const PatchNets& second, double tolerance,
                                          const Context& context) {
  const auto shared = shared_map(first, second, context);
  if (shared && shared->embedded) return parts_of(*shared, first.rounded, tolerance);
  if (auto result = parts_of_common_surface(first, second, tolerance, context)) return result;
  if (shared && shared->has_area()) return parts_of(*shared, first.rounded, tolerance);
  return std::nullopt;
}

}  // namespace eliminant::intersect
