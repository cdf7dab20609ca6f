// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/contained_borders.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <eliminant/intersect/overlaps/border_arc.hpp>

namespace eliminant::intersect {

namespace {

using bridge::CellContact;
using bridge::ContainedBorder;

/// Of u, v, s, t, the one that runs along the border.
std::size_t along(const ContainedBorder& border) { return border.axis < 2 ? 1 - border.axis : 5 - border.axis; }

/// A part of a border between contacts: their indices where it ends at one.
struct BorderPart {
  ContainedBorder border;
  std::optional<std::size_t> from;
  std::optional<std::size_t> to;
};

std::vector<BorderPart> parts_of(const ContainedBorder& border, const bridge::BranchGraph& graph) {
  const std::vector<CellContact>& contacts = graph.contacts;
  std::vector<std::size_t> on_it;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (crosses(graph, i) && is_on(border, contacts[i])) on_it.push_back(i);
  const auto place = [&](std::size_t i) { return contacts[i].contact.rounded[along(border)]; };
  std::sort(on_it.begin(), on_it.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  std::vector<BorderPart> parts{{border, {}, {}}};
  for (const std::size_t i : on_it) {
    BorderPart& last = parts.back();
    if (place(i) <= last.border.lower) {
      last.from = i;
      continue;
    }
    last.to = i;
    if (place(i) >= border.upper) break;
    last.border.upper = place(i);
    BorderPart next{border, i, {}};
    next.border.lower = place(i);
    parts.push_back(next);
  }
  return parts;
}

SurfaceComponent drawn(const BalancedPair& pair, const BorderPart& part, double tolerance) {
  const bridge::PatchPairNets nets = pair.nets();
  const DrawnCurve curve = drawn_border(nets.first, nets.second, part.border, tolerance);
  SurfaceComponent component = pair.placed(SurfaceComponentKind::curve, curve);
  component.start.side = sides_at(curve.parameters.front());
  component.end.side = sides_at(curve.parameters.back());
  component.start.side[part.border.axis] = component.end.side[part.border.axis] = part.border.side;
  for (const auto& [end, contact] : {std::pair(&component.start, part.from), std::pair(&component.end, part.to)}) {
    if (!contact) continue;
    end->kind = BranchEndKind::singular;
    end->singular_point = contact;
  }
  pair.put_on_border(component.points.front(), component.start);
  pair.put_on_border(component.points.back(), component.end);
  // At a crossing both patches are tangent anyhow.
  const std::size_t last = curve.parameters.size() - 1;
  component.tangential = true;
  for (std::size_t i = part.from ? 1 : 0; i <= (part.to ? last - 1 : last) && component.tangential; ++i)
    component.tangential = pair.is_tangential(curve.parameters[i]);
  if (component.tangential) {
    component.certified = false;
    component.reason = "both surfaces touch along a border, and what else they have in common there is not proven";
  }
  return component;
}

bool have_same_ends(const SurfaceComponent& a, const SurfaceComponent& b) {
  const auto near = [](const SurfacePoint& p, const SurfacePoint& q) {
    constexpr double accuracy = 1e-7;
    for (std::size_t k = 0; k < 4; ++k)
      if (!(std::fabs(p.parameters[k] - q.parameters[k]) < accuracy)) return false;
    return true;
  };
  return (near(a.points.front(), b.points.front()) && near(a.points.back(), b.points.back())) ||
         (near(a.points.front(), b.points.back()) && near(a.points.back(), b.points.front()));
}

bool lies_on(const SurfaceComponent& component, const ContainedBorder& border) {
  return component.start.side[border.axis] == border.side && component.end.side[border.axis] == border.side;
}

/// Whether a part of the domain that is left open meets the curve, as far as the curve is drawn.
bool passes_through(const SurfaceComponent& component, const bridge::CellBox& box, const BalancedPair& pair) {
  std::array<double, 4> lower{};
  std::array<double, 4> upper{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double slack = 1e-9 + 0.5 * (box.upper[k] - box.lower[k]);
    lower[k] = pair.to_domain(k, std::max(box.lower[k] - slack, 0.0));
    upper[k] = pair.to_domain(k, std::min(box.upper[k] + slack, 1.0));
  }
  for (std::size_t i = 0; i + 1 < component.points.size(); ++i) {
    bool apart = false;
    for (std::size_t k = 0; k < 4 && !apart; ++k) {
      const auto [low, high] = std::minmax(component.points[i].parameters[k], component.points[i + 1].parameters[k]);
      apart = high < lower[k] || low > upper[k];
    }
    if (!apart) return true;
  }
  return false;
}

}  // namespace

bool crosses(const bridge::BranchGraph& graph, std::size_t contact) {
  return graph.contacts[contact].around.crossing &&
         std::any_of(graph.arcs.begin(), graph.arcs.end(), [&](const auto& arc) { return arc.contact == contact; });
}

bool is_on(const ContainedBorder& border, const CellContact& contact) {
  if (contact.contact.side(border.axis) != border.side) return false;
  constexpr double accuracy = 1e-11;
  const double at = contact.contact.rounded[along(border)];
  return at > border.lower - accuracy && at < border.upper + accuracy;
}

std::array<int, 4> sides_at(const std::array<double, 4>& at) {
  constexpr double accuracy = 1e-9;
  std::array<int, 4> side{};
  for (std::size_t k = 0; k < 4; ++k) side[k] = at[k] < accuracy ? -1 : at[k] > 1 - accuracy ? 1 : 0;
  return side;
}

std::vector<SurfaceComponent> contained_curves(const BalancedPair& pair, const std::vector<ContainedBorder>& borders,
                                               const bridge::BranchGraph& graph, double tolerance) {
  std::vector<SurfaceComponent> found;
  for (const ContainedBorder& border : borders) {
    if (border.one_point) continue;
    for (const BorderPart& part : parts_of(border, graph)) {
      SurfaceComponent component = drawn(pair, part, tolerance);
      const auto same = [&](const SurfaceComponent& other) { return have_same_ends(component, other); };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back(std::move(component));
    }
  }
  return found;
}

void settle_contained_curves(std::vector<SurfaceComponent>& components, const BalancedPair& pair,
                             const std::vector<ContainedBorder>& borders, const bridge::ContactCurves& curves,
                             const bridge::BranchGraph& graph) {
  for (SurfaceComponent& component : components) {
    const auto of_it = [&](const ContainedBorder& border) { return !border.one_point && lies_on(component, border); };
    if (component.kind != SurfaceComponentKind::curve || std::none_of(borders.begin(), borders.end(), of_it)) continue;
    if (component.tangential && !component.certified) {
      component.certified = std::any_of(borders.begin(), borders.end(), [&](const ContainedBorder& border) {
        return lies_on(component, border) && curves.is_along(border.axis, border.side);
      });
      if (component.certified) component.reason.clear();
    }
    const bool open = !graph.complete || std::any_of(graph.open.begin(), graph.open.end(), [&](const auto& box) {
      return passes_through(component, box, pair);
    });
    if (!open || !component.certified) continue;
    component.certified = false;
    component.reason = "whether another branch crosses it is not proven";
  }
}

}  // namespace eliminant::intersect
