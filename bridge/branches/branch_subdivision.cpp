// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/branch_subdivision.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <eliminant/bridge/branches/surface_cell.hpp>
#include <eliminant/bridge/contacts/kept_distance.hpp>
#include <eliminant/bridge/nets/bernstein_subdivision.hpp>

namespace eliminant::bridge {

namespace {

/// The places of parts are rounded by less than this.
constexpr double place_slack = 0x1p-44;

/// A pair of parts and the points known on its sides.
struct Cell {
  std::array<double, 4> lower{};
  std::array<double, 4> width{};
  std::vector<Array4d> first;
  std::vector<Array4d> second;
  Array4d first_error;
  Array4d second_error;
  std::vector<std::size_t> points;
};

/// A contact that was found, and what is known around a degenerate one.
struct KnownContact {
  SurfaceContact contact;
  std::optional<SurfaceContactProver::Surroundings> surroundings;

  /// Whether the box is one in which its half-branches are all.
  bool explains(const CellBox& box) const {
    if (!surroundings) return false;
    for (std::size_t k = 0; k < 4; ++k)
      if (box.lower[k] < surroundings->box.lower[k] || box.upper[k] > surroundings->box.upper[k]) return false;
    return true;
  }
  /// Whether the contact may be in the closed box.
  bool touches(const CellBox& box) const {
    for (std::size_t k = 0; k < 4; ++k)
      if (contact.rounded[k] < box.lower[k] - place_slack || contact.rounded[k] > box.upper[k] + place_slack)
        return false;
    return true;
  }
};

class Subdivision {
 public:
  Subdivision(const ControlNet& first, const ControlNet& second, std::vector<ContainedBorder> contained,
              const SurfaceContactProver* contacts, ContactCurves* curves, const BranchLimits& limits,
              const Context& context)
      : first_(first),
        second_(second),
        contained_(std::move(contained)),
        contacts_(contacts),
        curves_(curves),
        limits_(limits),
        context_(context) {
    std::copy(first.degrees.begin(), first.degrees.end(), test_.first.shape.degree.begin());
    std::copy(second.degrees.begin(), second.degrees.end(), test_.second.shape.degree.begin());
    test_.first.polynomial = first.polynomial;
    test_.second.polynomial = second.polynomial;
    Cell& root = stack_.emplace_back();
    root.width.fill(1);
    root.first = first.points;
    root.second = second.points;
    root.first_error = first.error;
    root.second_error = second.error;
  }

  BranchGraph run(std::vector<CrossingPoint> border) && {
    graph_.points = std::move(border);
    for (std::size_t i = 0; i < graph_.points.size(); ++i) stack_.back().points.push_back(i);
    while (!stack_.empty() && graph_.complete) {
      if (++graph_.cells > limits_.most_cells) {
        graph_.complete = false;
        break;
      }
      // Around singular points of a curve of contact there is no end.
      if (curves_ != nullptr && curves_->is_exhausted()) {
        graph_.complete = false;
        break;
      }
      constexpr unsigned long checked_every = 256;
      if (graph_.cells % checked_every == 0) context_.checkpoint("subdividing");
      step();
    }
    // What was not looked at.
    for (const Cell& cell : stack_) graph_.open.push_back(box_of(cell));
    return std::move(graph_);
  }

 private:
  const Side<2>& side_of(std::size_t axis) const { return axis < 2 ? test_.first : test_.second; }

  void load(Cell& cell) {
    test_.first.points = cell.first.data();
    test_.second.points = cell.second.data();
    test_.first.error = cell.first_error;
    test_.second.error = cell.second_error;
  }

  void step() {
    Cell& cell = stack_.back();
    load(cell);
    if (!bound(test_.first) || !bound(test_.second)) {
      graph_.complete = false;
      return;
    }
    CellVerdict verdict;
    verdict.excluded = test_.apart();
    if (!verdict.excluded) {
      recentre(cell);
      verdict = test_.examine();
    }
    if (verdict.excluded && cell.points.empty()) {
      drop();
      return;
    }
    if (verdict.regular && cell.points.size() <= 2 && cell.points.size() != 1) {
      if (cell.points.size() == 2) graph_.arcs.push_back({cell.points[0], cell.points[1], box_of(cell), {}, {}});
      drop();
      return;
    }
    const double widest = *std::max_element(cell.width.begin(), cell.width.end());
    if (!verdict.excluded && !verdict.regular && (settle_contact_curve(cell, widest) || settle_contact(cell, widest))) {
      drop();
      return;
    }
    if (!verdict.excluded && !verdict.regular && is_gap(cell, widest)) {
      drop();
      return;
    }
    // Points on its sides contradict an excluded cell, or a regular one with a single point: the intersection touches.
    if (widest < limits_.smallest_width || verdict.excluded || (verdict.regular && cell.points.size() == 1)) {
      leave_open(cell);
      return;
    }
    const std::array<double, 4> spreads = test_.spreads();
    if (verdict.regular && cut_between_points(spreads)) return;
    const auto axis = static_cast<std::size_t>(std::max_element(spreads.begin(), spreads.end()) - spreads.begin());
    for (const double at : cut_places(axis))
      if (cut(axis, at)) return;
    for (std::size_t other = 0; other < 4; ++other)
      for (const double at : cut_places(other))
        if (other != axis && cut(other, at)) return;
    // Away from a singular point in the middle.
    for (std::size_t k = 0; k < 4; ++k)
      for (const double at : {0.203125, 0.796875, 0.1015625, 0.8984375})
        if (cut(k, at)) return;
    leave_open(stack_.back());
  }

  /// Not in the middle, where inputs have their symmetries, and nowhere at the same place on both patches, whose
  /// parameters may be the same.
  static std::array<double, 5> cut_places(std::size_t axis) {
    switch (axis) {
      case 0:
        return {0.4921875, 0.53515625, 0.451171875, 0.578125, 0.40234375};
      case 1:
        return {0.5087890625, 0.4638671875, 0.5537109375, 0.421875, 0.6171875};
      case 2:
        return {0.5166015625, 0.470703125, 0.5654296875, 0.4287109375, 0.6298828125};
      default:
        return {0.482421875, 0.525390625, 0.4423828125, 0.5869140625, 0.3935546875};
    }
  }

  /// Moves both parts to the origin once they are small beside their distance from it: roundings are relative to that.
  void recentre(Cell& cell) {
    const Array4d extent = test_.first.box.upper - test_.first.box.lower;
    const Array4d size = test_.first.box.magnitude();
    constexpr double much = 8;
    if (!(size.head<3>().maxCoeff() > much * extent.head<3>().maxCoeff())) return;
    Array4d shift = 0.5 * (test_.first.box.lower + test_.first.box.upper);
    shift[3] = 0;
    const auto move = [&](std::vector<Array4d>& points, Array4d& error, const Side<2>& side) {
      for (Array4d& point : points) point -= side.polynomial ? shift : Array4d(shift * point[3]);
      const double weight = side.polynomial ? 0 : side.size[3];
      error +=
          2 * unit_roundoff * (side.size + shift.abs() * (side.polynomial ? 1 : weight)) * (side.polynomial ? 0 : 1);
      if (!side.polynomial) error += shift.abs() * error[3];
    };
    move(cell.first, cell.first_error, test_.first);
    move(cell.second, cell.second_error, test_.second);
    load(cell);
    bound(test_.first);
    bound(test_.second);
    const auto add_rounding = [](Array4d& error, const Side<2>& side) {
      if (!side.polynomial) return;
      error += unit_roundoff * side.size;
      error[3] = 0;
    };
    add_rounding(cell.first_error, test_.first);
    add_rounding(cell.second_error, test_.second);
    load(cell);
    bound(test_.first);
    bound(test_.second);
  }

  /// True when nearly parallel parts are proven to keep a distance; asked where subdivision takes long.
  bool is_gap(const Cell& cell, double widest) const {
    constexpr unsigned long long_run = 400;
    constexpr double small = 0.25;
    if (graph_.cells < long_run || !cell.points.empty() || !(widest < small)) return false;
    return keep_distance(first_, second_, box_of(cell));
  }

  /// True when the intersection in the cell is a part of a curve of contact, and perhaps a branch that crosses it.
  bool settle_contact_curve(const Cell& cell, double widest) {
    constexpr double small = 0.5;
    if (curves_ == nullptr || !(widest < small)) return false;
    const CellBox box = box_of(cell);
    if (widest < look_for_curve_) {
      std::array<double, 4> middle;
      for (std::size_t k = 0; k < 4; ++k) middle[k] = 0.5 * (box.lower[k] + box.upper[k]);
      if (!curves_->find(middle, widest)) look_for_curve_ = 0.5 * widest;
    }
    if (!curves_->can_explain()) return false;
    if (cell.points.empty() && curves_->explains(box)) return true;
    if (cell.points.size() != 2) return false;
    const auto crossing = curves_->crossing(box);
    if (!crossing) return false;
    if (!crossing->inside) {
      graph_.arcs.push_back({cell.points[0], cell.points[1], box, {}, {}});
      return true;
    }
    return add_crossing(cell, box, *crossing);
  }

  bool add_crossing(const Cell& cell, const CellBox& box, const ContactCurves::Crossing& crossing) {
    std::array<double, 2> height{};
    for (std::size_t i = 0; i < 2; ++i) {
      const CrossingPoint& point = graph_.points[cell.points[i]];
      double unsure = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        height[i] += crossing.growing[k] * (point.parameters[k] - crossing.parameters[k]);
        unsure += std::fabs(crossing.growing[k]) * (point.radius + crossing.radius);
      }
      if (!(std::fabs(height[i]) > unsure)) return false;
    }
    if ((height[0] > 0) == (height[1] > 0)) return false;
    CrossingPoint point;
    point.parameters = crossing.parameters;
    point.radius = crossing.radius;
    for (const std::size_t i : cell.points)
      graph_.arcs.push_back({i, graph_.points.size(), box, {}, graph_.crossings.size()});
    graph_.crossings.push_back({crossing, box, graph_.points.size()});
    graph_.points.push_back(point);
    return true;
  }

  /// True when a contact is in the cell, and all of the intersection there is its arcs.
  bool settle_contact(const Cell& cell, double widest) {
    constexpr double small = 0.25;
    if (contacts_ == nullptr || !(widest < small)) return false;
    const CellBox box = box_of(cell);
    // Where four arcs meet it pays to look again and again.
    const KnownContact* known = contact_in(box, widest, cell.points.size() == 4);
    if (known == nullptr) return is_beside_contact(cell, box);
    const SurfaceContact* contact = &known->contact;
    const auto around = known->explains(box) ? std::optional(known->surroundings->neighbourhood)
                                             : contacts_->neighbourhood(*contact, box);
    if (!around) return false;
    // Each half-arc that starts into the cell leaves it at one point. Only on the border of the domain, which all of
    // them need not cross and one of them may follow, there are fewer than four.
    const bool may_be_cut = around->crossing && !around->degenerate && contact->is_on_border();
    if (!may_be_cut && cell.points.size() != around->half_branches()) return false;
    std::array<bool, 4> taken{};
    for (const std::size_t i : cell.points) {
      const std::array<double, 4>& at = graph_.points[i].parameters;
      const auto half =
          around->half_arc(at[0] - contact->rounded[0], at[1] - contact->rounded[1], graph_.points[i].radius);
      if (!half || taken[*half]) return false;
      taken[*half] = true;
    }
    CrossingPoint point;
    point.parameters = contact->rounded;
    point.radius = place_slack;
    for (std::size_t k = 0; k < 4; ++k) point.side[k] = contact->side(k);
    for (const std::size_t i : cell.points)
      graph_.arcs.push_back({i, graph_.points.size(), box, graph_.contacts.size(), {}});
    graph_.contacts.push_back({*contact, *around, box, graph_.points.size()});
    graph_.points.push_back(point);
    return true;
  }

  /// True when the cell is in a box in which all half-branches of a contact are known, and the contact is not in the
  /// cell: each of them is a graph, as an arc of a regular cell is.
  bool is_beside_contact(const Cell& cell, const CellBox& box) {
    if (!cell.points.empty() && cell.points.size() != 2) return false;
    if (std::none_of(known_contacts_.begin(), known_contacts_.end(),
                     [&](const KnownContact& known) { return known.explains(box) && !known.touches(box); }))
      return false;
    if (cell.points.size() == 2) graph_.arcs.push_back({cell.points[0], cell.points[1], box, {}, {}});
    return true;
  }

  /// One that is known, or found now. Each failure makes the next attempt wait for smaller parts, unless it is likely.
  const KnownContact* contact_in(const CellBox& box, double widest, bool likely) {
    const auto inside = [&](const KnownContact& known) {
      const SurfaceContact& contact = known.contact;
      for (std::size_t k = 0; k < 4; ++k) {
        const double at = contact.rounded[k];
        const bool above = at > box.lower[k] || (contact.side(k) < 0 && box.lower[k] == 0);
        const bool below = at < box.upper[k] || (contact.side(k) > 0 && box.upper[k] > 1 - place_slack);
        if (!above || !below) return false;
      }
      return true;
    };
    const auto known = [&]() -> const KnownContact* {
      const auto at = std::find_if(known_contacts_.begin(), known_contacts_.end(), inside);
      return at == known_contacts_.end() ? nullptr : &*at;
    };
    if (const KnownContact* contact = known()) return contact;
    if (std::any_of(known_contacts_.begin(), known_contacts_.end(),
                    [&](const KnownContact& contact) { return contact.explains(box); }))
      return nullptr;
    if (!likely && !(widest < look_for_contact_)) return nullptr;
    const auto found = contacts_->find(box);
    const auto same = [&](const KnownContact& known) { return known.contact.rounded == found->rounded; };
    if (!found || std::any_of(known_contacts_.begin(), known_contacts_.end(), same)) {
      if (!likely) look_for_contact_ *= 0.5;
      return nullptr;
    }
    known_contacts_.push_back({*found, contacts_->surroundings(*found)});
    return known();
  }

  static CellBox box_of(const Cell& cell) {
    CellBox box;
    for (std::size_t k = 0; k < 4; ++k) {
      box.lower[k] = cell.lower[k];
      box.upper[k] = cell.lower[k] + cell.width[k];
    }
    return box;
  }

  void leave_open(const Cell& cell) {
    graph_.open.push_back(box_of(cell));
    drop();
    if (graph_.open.size() >= limits_.most_open) graph_.complete = false;
  }

  /// Cuts between the points on the sides, where the gap is largest in space and nothing crosses the cut: then it
  /// separates arcs. A cut across all of them would leave as many on both sides of it, for ever.
  bool cut_between_points(const std::array<double, 4>& spreads) {
    const Cell& cell = stack_.back();
    struct Gap {
      double size = 0;
      std::size_t axis = 0;
      double at = 0.5;
    };
    std::array<Gap, 4> gaps;
    for (std::size_t k = 0; k < 4; ++k) {
      std::vector<double> places;
      for (const std::size_t i : cell.points)
        places.push_back((graph_.points[i].parameters[k] - cell.lower[k]) / cell.width[k]);
      std::sort(places.begin(), places.end());
      gaps[k].axis = k;
      for (std::size_t i = 1; i + 2 < places.size(); i += 1) {
        const double width = places[i + 1] - places[i];
        // Between opposite sides a cut meets the arcs instead of separating them.
        constexpr double side = 1e-6;
        constexpr double least_gap = 1e-3;
        if (width < least_gap || (places[i] < side && places[i + 1] > 1 - side)) continue;
        if (width * spreads[k] <= gaps[k].size) continue;
        gaps[k].size = width * spreads[k];
        gaps[k].at = 0.5 * (places[i + 1] + places[i]);
      }
    }
    std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.size > b.size; });
    return std::any_of(gaps.begin(), gaps.end(), [&](const Gap& gap) {
      return gap.size > 0 && cut(gap.axis, std::clamp(gap.at, 0.125, 0.875), true);
    });
  }

  /// Cuts the topmost cell at a local parameter into two. False when the cut passes too near to known points, or not
  /// all points on it can be found, or there are some and it is to be `uncrossed`.
  bool cut(std::size_t axis, double at, bool uncrossed = false) {
    Cell& cell = stack_.back();
    const double place = cell.lower[axis] + at * cell.width[axis];
    std::vector<std::size_t> below;
    std::vector<std::size_t> above;
    for (const std::size_t i : cell.points) {
      const double distance = graph_.points[i].parameters[axis] - place;
      if (std::fabs(distance) < graph_.points[i].radius + 2 * place_slack + 1e-6 * cell.width[axis]) return false;
      (distance < 0 ? below : above).push_back(i);
    }
    const auto found = points_on_cut(cell, axis, at);
    if (!found && curves_ != nullptr) curves_->count_failed_cut();
    if (!found || (uncrossed && !found->empty())) return false;
    for (const CrossingPoint& point : *found) {
      below.push_back(graph_.points.size());
      above.push_back(graph_.points.size());
      graph_.points.push_back(point);
    }
    split(axis, at, std::move(below), std::move(above));
    return true;
  }

  void split(std::size_t axis, double at, std::vector<std::size_t> below, std::vector<std::size_t> above) {
    stack_.push_back(spare_cell());
    Cell& upper = stack_.back();
    Cell& lower = stack_[stack_.size() - 2];
    upper = lower;
    const Side<2>& side = side_of(axis);
    const std::size_t k = axis % 2;
    const bool of_first = axis < 2;
    cut_at(side.shape, k, at, (of_first ? lower.first : lower.second).data(),
           (of_first ? upper.first : upper.second).data());
    for (Cell* part : {&lower, &upper}) {
      Array4d& error = of_first ? part->first_error : part->second_error;
      error += 4 * static_cast<double>(side.shape.degree[k]) * unit_roundoff * side.size;
      if (side.polynomial) error[3] = 0;
    }
    upper.lower[axis] += at * upper.width[axis];
    upper.width[axis] *= 1 - at;
    lower.width[axis] *= at;
    lower.points = std::move(below);
    upper.points = std::move(above);
  }

  /// Takes the topmost cell away; its memory is used again.
  void drop() {
    spare_.push_back(std::move(stack_.back()));
    stack_.pop_back();
  }

  Cell spare_cell() {
    if (spare_.empty()) return {};
    Cell cell = std::move(spare_.back());
    spare_.pop_back();
    return cell;
  }

  /// All points of the intersection on the cut, none of them on the border of the cell.
  std::optional<std::vector<CrossingPoint>> points_on_cut(const Cell& cell, std::size_t axis, double at) {
    ++graph_.sections;
    const bool of_first = axis < 2;
    ControlNet curve = section(of_first ? cell.first : cell.second, of_first ? cell.first_error : cell.second_error,
                               side_of(axis), axis % 2, at);
    ControlNet patch;
    const Side<2>& other = of_first ? test_.second : test_.first;
    patch.degrees = {other.shape.degree[0], other.shape.degree[1]};
    patch.points = of_first ? cell.second : cell.first;
    patch.error = of_first ? cell.second_error : cell.first_error;
    patch.polynomial = other.polynomial;
    SubdivisionLimits limits;
    limits.most_pairs = 2000;
    // They are only to be told apart.
    limits.largest_radius = 0x1p-12;
    limits.part = *std::max_element(cell.width.begin(), cell.width.end());
    FindContact find_contact;
    if (curves_ != nullptr)
      find_contact = [&](const std::array<double, 3>& near, double reach) {
        return explained_on_cut(cell, axis, at, near, reach);
      };
    SubdivisionResult found = bernstein_subdivision(curve, patch, find_contact, limits, context_);
    if (!found.complete || !found.open.empty()) {
      // Flat parts that are nearly parallel can still be told apart.
      constexpr double flat = 0x1p-12;
      if (!(limits.part > flat)) return std::nullopt;
      limits.part = flat;
      found = bernstein_subdivision(curve, patch, find_contact, limits, context_);
      if (!found.complete || !found.open.empty()) return std::nullopt;
    }
    std::vector<CrossingPoint> points;
    for (const IsolatedZero& zero : found.zeros) {
      CrossingPoint point;
      const std::size_t along = of_first ? 1 - axis : 5 - axis;
      std::array<double, 4> local{};
      local[axis] = at;
      local[along] = zero.parameters[0];
      local[of_first ? 2 : 0] = zero.parameters[1];
      local[of_first ? 3 : 1] = zero.parameters[2];
      bool inside = true;
      for (std::size_t k = 0; k < 4; ++k) {
        constexpr double margin = 1e-6;
        inside = inside && (k == axis || (local[k] - zero.radius > margin && local[k] + zero.radius < 1 - margin));
        point.parameters[k] = cell.lower[k] + local[k] * cell.width[k];
        point.radius = std::max(point.radius, zero.radius * cell.width[k] + place_slack);
      }
      // The one zero there is that of the border curve.
      if (std::any_of(contained_.begin(), contained_.end(),
                      [&](const ContainedBorder& border) { return border.holds(point.parameters, point.radius); }))
        continue;
      if (!inside) return std::nullopt;
      points.push_back(point);
    }
    return points;
  }

  /// Parameters of a cut around `near`, in which there are only points of curves of contact.
  std::optional<OpenBox> explained_on_cut(const Cell& cell, std::size_t axis, double at,
                                          const std::array<double, 3>& near, double reach) const {
    const bool of_first = axis < 2;
    const std::array<std::size_t, 3> place{of_first ? 1 - axis : 5 - axis, of_first ? 2U : 0U, of_first ? 3U : 1U};
    std::array<double, 4> point{};
    std::array<double, 4> half{};
    point[axis] = cell.lower[axis] + at * cell.width[axis];
    // The place is rounded.
    half[axis] = place_slack;
    for (std::size_t k = 0; k < 3; ++k) {
      point[place[k]] = cell.lower[place[k]] + near[k] * cell.width[place[k]];
      half[place[k]] = std::min(reach, 1.0) * cell.width[place[k]];
    }
    auto box = curves_->explained_around(axis, point, half);
    const double widest = *std::max_element(half.begin(), half.end());
    if (!box && curves_->find(point, widest)) box = curves_->explained_around(axis, point, half);
    if (!box) return std::nullopt;
    OpenBox result{};
    for (std::size_t k = 0; k < 3; ++k) {
      result.lower[k] = (box->lower[place[k]] - cell.lower[place[k]]) / cell.width[place[k]];
      result.upper[k] = (box->upper[place[k]] - cell.lower[place[k]]) / cell.width[place[k]];
    }
    return result;
  }

  /// The curve where the parameter of the axis has that value, by de Casteljau's algorithm.
  static ControlNet section(const std::vector<Array4d>& points, const Array4d& error, const Side<2>& side,
                            std::size_t axis, double at) {
    const std::size_t degree = side.shape.degree[axis];
    const std::size_t stride = side.shape.stride(axis);
    ControlNet curve;
    curve.degrees = {side.shape.degree[1 - axis]};
    curve.polynomial = side.polynomial;
    std::vector<Array4d> line(degree + 1);
    side.shape.for_each_line(axis, [&](std::size_t base) {
      for (std::size_t i = 0; i <= degree; ++i) line[i] = points[base + i * stride];
      for (std::size_t level = degree; level > 0; --level)
        for (std::size_t i = 0; i < level; ++i) line[i] = (1 - at) * line[i] + at * line[i + 1];
      curve.points.push_back(line[0]);
    });
    curve.error = error + 4 * static_cast<double>(degree) * unit_roundoff * side.size;
    if (side.polynomial) curve.error[3] = 0;
    return curve;
  }

  const ControlNet& first_;
  const ControlNet& second_;
  std::vector<ContainedBorder> contained_;
  const SurfaceContactProver* contacts_;
  ContactCurves* curves_;
  const BranchLimits& limits_;
  const Context& context_;
  std::vector<KnownContact> known_contacts_;
  double look_for_contact_ = 0.25;
  double look_for_curve_ = 0.25;
  SurfaceCell test_;
  std::vector<Cell> stack_;
  std::vector<Cell> spare_;
  BranchGraph graph_;
};

}  // namespace

BranchGraph branch_subdivision(const ControlNet& first, const ControlNet& second, std::vector<CrossingPoint> border,
                               std::vector<ContainedBorder> contained, const SurfaceContactProver* contacts,
                               const BranchLimits& limits, const Context& context, ContactCurves* curves) {
  return Subdivision(first, second, std::move(contained), contacts, curves, limits, context).run(std::move(border));
}

}  // namespace eliminant::bridge
