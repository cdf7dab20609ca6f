// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/branch_joining.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/intersect/patches/seam_curves.hpp>
#include <eliminant/intersect/patches/singular_joining.hpp>
#include <eliminant/intersect/patches/space_polyline.hpp>

namespace eliminant::intersect {

namespace {

using Parameters = std::array<double, 4>;

Parameters exchanged(const Parameters& p) { return {p[2], p[3], p[0], p[1]}; }

void exchange(SurfaceComponent& component) {
  for (SurfacePoint& point : component.points) point.parameters = exchanged(point.parameters);
  for (BranchEnd* end : {&component.start, &component.end}) {
    end->side = {end->side[2], end->side[3], end->side[0], end->side[1]};
    std::swap(end->third_side[0], end->third_side[1]);
  }
  std::swap(component.along_seam[0], component.along_seam[1]);
}

void reverse(SurfaceComponent& component) {
  std::reverse(component.points.begin(), component.points.end());
  std::swap(component.start, component.end);
}

/// Forgets the sides that are no borders of the whole domain; true when some were, and none is left. Sides of the
/// parameters that are kept do not count: the curve does not end there.
bool is_only_seam(BranchEnd& end, const Parameters& at, const DomainBounds& bounds, const KeptParameters& kept = {}) {
  bool any = false;
  bool left = false;
  for (std::size_t i = 0; i < 2; ++i) left = left || (end.third_side[i] && !kept[first_third_coordinate + i]);
  for (std::size_t k = 0; k < 4; ++k) {
    if (end.side[k] == 0) continue;
    any = any || !kept[k];
    if (end.side[k] == seam_in_triangle) {
      end.side[k] = 0;
      continue;
    }
    bool border = false;
    if (bounds[k]) {
      const double bound = (*bounds[k])[end.side[k] < 0 ? 0 : 1];
      constexpr double rounding = 1e-13;
      constexpr double digits = 0x1p-50;
      const double width = (*bounds[k])[1] - (*bounds[k])[0];
      border = std::fabs(at[k] - bound) <= rounding * width + digits * std::fabs(bound);
    }
    if (!border) end.side[k] = 0;
    left = left || (border && !kept[k]);
  }
  return any && !left;
}

class Joining {
 public:
  Joining(SurfaceResult& result, const DomainBounds& bounds, bool symmetric)
      : result_(result),
        bounds_(bounds),
        metric_(bounds),
        same_(metric_.same()),
        apart_(metric_.apart()),
        symmetric_(symmetric) {}

  void run() {
    remove_repeated_seams(result_.components, metric_);
    for (SurfaceComponent& component : result_.components)
      if (component.kind == SurfaceComponentKind::curve)
        pieces_.push_back(std::move(component));
      else
        rest_.push_back(std::move(component));
    for (SurfaceComponent& piece : pieces_) {
      const KeptParameters kept = kept_parameters(piece);
      const Parameters& first = piece.points.front().parameters;
      const Parameters& last = piece.points.back().parameters;
      at_corner_.push_back({is_at_corner(piece.start), is_at_corner(piece.end)});
      open_.push_back({piece.start.kind == BranchEndKind::border && is_only_seam(piece.start, first, bounds_, kept),
                       piece.end.kind == BranchEndKind::border && is_only_seam(piece.end, last, bounds_, kept)});
      if (open_.back()[0]) open_ends_.push_back(first);
      if (open_.back()[1]) open_ends_.push_back(last);
    }
    if (!symmetric_) find_crossings_on_seams();
    used_.assign(pieces_.size(), false);
    // Curves with an end first, what then is left are loops.
    for (const bool with_end : {true, false})
      for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (used_[i] || (with_end && open_[i][0] && open_[i][1])) continue;
        if (with_end && open_[i][0]) turn(i);
        follow(i);
      }
    result_.components = std::move(rest_);
    take_out_repeated_points();
    if (!symmetric_) join_singular_points(result_, bounds_);
  }

 private:
  BranchEnd& end_of(std::size_t piece, bool at_end) { return at_end ? pieces_[piece].end : pieces_[piece].start; }
  const SurfacePoint& place_of(std::size_t piece, bool at_end) const {
    return at_end ? pieces_[piece].points.back() : pieces_[piece].points.front();
  }

  /// Both parameters of one of the surfaces are known exactly.
  static bool is_at_corner(const BranchEnd& end) {
    return (end.side[0] != 0 && end.side[1] != 0) || (end.side[2] != 0 && end.side[3] != 0);
  }

  /// Open ends of more than two pieces in one corner, as where kinked seams cross, and those in a contact of others.
  void find_crossings_on_seams() {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (const bool at_end : {false, true}) {
        if (!open_[i][at_end ? 1 : 0]) continue;
        const SurfacePoint at = place_of(i, at_end);
        std::optional<std::size_t> crossing = contact_at(at.parameters);
        const auto ends = open_ends_at(at.parameters);
        const bool in_corner = std::all_of(ends.begin(), ends.end(),
                                           [&](const auto& end) { return at_corner_[end.first][end.second ? 1 : 0]; });
        const bool meet =
            in_corner && ends.size() > 2 && open_ends_near(at.parameters) == static_cast<std::ptrdiff_t>(ends.size());
        if (!crossing && !meet) continue;
        if (!crossing) crossing = add_crossing(at, ends);
        for (const auto& [piece, end] : ends) {
          open_[piece][end ? 1 : 0] = false;
          end_of(piece, end).kind = BranchEndKind::singular;
          end_of(piece, end).singular_point = crossing;
        }
      }
  }

  /// Which pieces have an open end there, at their start or end.
  std::vector<std::pair<std::size_t, bool>> open_ends_at(const Parameters& at) const {
    std::vector<std::pair<std::size_t, bool>> result;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (const bool at_end : {false, true})
        if (open_[i][at_end ? 1 : 0] && metric_.distance(place_of(i, at_end).parameters, at) < same_)
          result.emplace_back(i, at_end);
    return result;
  }

  std::optional<std::size_t> contact_at(const Parameters& at) const {
    const auto& all = result_.singular_points;
    const auto found = std::find_if(all.begin(), all.end(), [&](const SurfaceSingularPoint& point) {
      return point.certified &&
             (point.kind == SurfaceSingularity::contact || point.kind == SurfaceSingularity::crossing) &&
             metric_.distance(point.at.parameters, at) < same_;
    });
    if (found == all.end()) return std::nullopt;
    return static_cast<std::size_t>(found - all.begin());
  }

  std::size_t add_crossing(const SurfacePoint& at, const std::vector<std::pair<std::size_t, bool>>& ends) {
    SurfaceSingularPoint point;
    point.kind = SurfaceSingularity::crossing;
    point.at = at;
    point.half_branches = ends.size();
    point.certified = true;
    for (std::size_t k = 0; k < 4; ++k)
      point.radius = std::max(point.radius, same_ * (bounds_[k] ? (*bounds_[k])[1] - (*bounds_[k])[0] : 1));
    for (const auto& [piece, end] : ends) point.radius = std::max(point.radius, pieces_[piece].error);
    result_.singular_points.push_back(std::move(point));
    return result_.singular_points.size() - 1;
  }

  /// Pieces that meet in a point find it several times, and some only the corner of what is a curve on another piece.
  /// A point at which no curve passes is one of the intersection, also where surfaces only touch along a seam.
  void take_out_repeated_points() {
    std::vector<SurfaceComponent>& all = result_.components;
    std::vector<bool> removed(all.size(), false);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].kind != SurfaceComponentKind::point) continue;
      const bool on_side =
          all[i].start.side != std::array<int, 4>{} || all[i].start.third_side != std::array<bool, 2>{};
      is_only_seam(all[i].start, all[i].points.front().parameters, bounds_);
      for (std::size_t j = 0; j < all.size() && !removed[i]; ++j) {
        if (removed[j] || j == i) continue;
        removed[i] = all[j].kind == SurfaceComponentKind::point ? j < i && is_same_place(all[i], all[j])
                                                                : is_on(all[j], all[i], on_side);
      }
      all[i].end = all[i].start;
    }
    std::size_t index = 0;
    std::erase_if(all, [&](const SurfaceComponent&) { return removed[index++]; });
  }

  bool is_same_place(const SurfaceComponent& a, const SurfaceComponent& b) const {
    return metric_.distance(a.points.front().parameters, b.points.front().parameters) < same_;
  }

  /// Whether a curve ends at a point, or passes it within its error, which is asked on the sides of pieces.
  bool is_on(const SurfaceComponent& curve, const SurfaceComponent& point, bool on_side) const {
    if (curve.kind == SurfaceComponentKind::overlap) return false;
    const SurfacePoint& at = point.points.front();
    for (const SurfacePoint* end : {&curve.points.front(), &curve.points.back()})
      if (metric_.distance(end->parameters, at.parameters) < same_) return true;
    constexpr double near = 1e-3;
    if (!on_side || !(distance_to(curve, at.parameters, metric_) < near)) return false;
    return distance_in_space(curve, at.point) <= 2 * (curve.error + point.error);
  }

  void turn(std::size_t i) {
    reverse(pieces_[i]);
    std::swap(open_[i][0], open_[i][1]);
  }

  /// From a piece as far as it goes, in both directions where both of its ends are open.
  void follow(std::size_t first) {
    used_[first] = true;
    SurfaceComponent curve = std::move(pieces_[first]);
    const bool from_inside = open_[first][0];
    if (open_[first][1]) extend(curve, from_inside);
    if (from_inside && curve.kind == SurfaceComponentKind::curve) {
      reverse(curve);
      extend(curve, false);
    }
    rest_.push_back(std::move(curve));
  }

  /// From its end, which is open.
  void extend(SurfaceComponent& curve, bool may_close) {
    const Parameters begin = curve.points.front().parameters;
    for (bool open = true; open;) {
      const Parameters at = curve.points.back().parameters;
      const auto next = continuation(at);
      if (!next) {
        if (may_close && metric_.distance(at, begin) < same_ && open_ends_near(at) == 2) {
          curve.kind = SurfaceComponentKind::loop;
          curve.points.back() = curve.points.front();
        } else {
          leave_unjoined(curve, curve.end);
        }
        return;
      }
      SurfaceComponent& piece = pieces_[*next];
      used_[*next] = true;
      open = open_[*next][1];
      curve.points.insert(curve.points.end(), piece.points.begin() + 1, piece.points.end());
      curve.end = piece.end;
      curve.error = std::max(curve.error, piece.error);
      curve.tangential = curve.tangential || piece.tangential;
      if (!piece.certified && curve.certified) curve.reason = piece.reason;
      curve.certified = curve.certified && piece.certified;
    }
  }

  static void leave_unjoined(SurfaceComponent& curve, BranchEnd& end) {
    end.kind = BranchEndKind::unknown;
    if (curve.certified) curve.reason = not_followed;
    curve.certified = false;
  }

  /// Also those that are joined already, and the one asked for.
  std::ptrdiff_t open_ends_near(const Parameters& at) const {
    return std::count_if(open_ends_.begin(), open_ends_.end(), [&](const Parameters& end) {
      return metric_.distance(at, end) < apart_ || (symmetric_ && metric_.distance(at, exchanged(end)) < apart_);
    });
  }

  /// The one piece not used yet that begins there, turned if necessary.
  std::optional<std::size_t> continuation(const Parameters& at) {
    if (open_ends_near(at) != 2) return std::nullopt;
    struct Candidate {
      std::size_t piece = 0;
      bool turned = false;
      bool exchanged = false;
      double distance = INFINITY;
    };
    Candidate best;
    double second_best = INFINITY;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used_[i]) continue;
      for (const bool turned : {false, true}) {
        if (!open_[i][turned ? 1 : 0]) continue;
        const Parameters& there = (turned ? pieces_[i].points.back() : pieces_[i].points.front()).parameters;
        for (const bool mirrored : {false, true}) {
          if (mirrored && !symmetric_) continue;
          const double d = metric_.distance(at, mirrored ? exchanged(there) : there);
          if (d < best.distance) {
            second_best = best.distance;
            best = {i, turned, mirrored, d};
          } else {
            second_best = std::min(second_best, d);
          }
        }
      }
    }
    if (!(best.distance < same_) || second_best < apart_) return std::nullopt;
    if (best.turned) turn(best.piece);
    if (best.exchanged) exchange(pieces_[best.piece]);
    return best.piece;
  }

  SurfaceResult& result_;
  const DomainBounds& bounds_;
  ParameterMetric metric_;
  double same_;
  double apart_;
  bool symmetric_;
  std::vector<SurfaceComponent> pieces_;
  std::vector<SurfaceComponent> rest_;
  /// Whether start and end are to be continued.
  std::vector<std::array<bool, 2>> open_;
  /// Whether start and end are in a corner of a piece.
  std::vector<std::array<bool, 2>> at_corner_;
  /// Where, of all pieces.
  std::vector<Parameters> open_ends_;
  std::vector<bool> used_;
};

}  // namespace

void join_branches(SurfaceResult& result, const DomainBounds& bounds, bool symmetric) {
  Joining(result, bounds, symmetric).run();
}

void remove_mirror_images(SurfaceResult& result, const DomainBounds& bounds) {
  const ParameterMetric metric(bounds);
  std::vector<SurfaceComponent>& all = result.components;
  std::vector<bool> removed(all.size(), false);
  // Polylines are that far from their curves in the parameters at most.
  constexpr double near = 1e-3;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (removed[i]) continue;
    // Next to a pinch point one of both may be longer: its middle, or else its ends, has an image on the other.
    double nearest = INFINITY;
    std::size_t partner = i;
    const std::size_t last = all[i].points.size() - 1;
    for (const std::size_t sample : {last / 2, std::size_t{0}, last}) {
      if (nearest < near) break;
      const Parameters image = exchanged(all[i].points[sample].parameters);
      for (std::size_t j = i; j < all.size(); ++j) {
        if (removed[j] || all[j].kind != all[i].kind) continue;
        const double d = distance_to(all[j], image, metric);
        if (!(d < nearest)) continue;
        nearest = d;
        partner = j;
      }
    }
    if (!(nearest < near)) {
      all[i].certified = false;
      all[i].reason = "its image under the exchange of both preimages was not found";
    } else if (partner == i) {
      all[i].mirrored = all[i].kind != SurfaceComponentKind::point;
    } else {
      removed[partner] = true;
    }
  }
  std::size_t index = 0;
  std::erase_if(all, [&](const SurfaceComponent&) { return removed[index++]; });
}

}  // namespace eliminant::intersect
