// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/triple_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <eliminant/bridge/certificates/krawczyk_system.hpp>
#include <eliminant/bridge/enclosures/ball_surface.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;

constexpr long precision_bits = 128;

using Preimage = std::array<double, 2>;
using Preimages = std::array<Preimage, 3>;

/// 0 where that is in the ball.
double middle(const ComplexBall& x) {
  return arb_contains_zero(x.real()) != 0 ? 0 : arf_get_d(arb_midref(x.real()), ARF_RND_NEAR);
}

/// A double curve in the plane of parameters, with the other preimage of each point.
struct PlaneLine {
  std::vector<Preimage> points;
  std::vector<Preimage> others;
};

struct PlaneBox {
  Preimage lower{INFINITY, INFINITY};
  Preimage upper{-INFINITY, -INFINITY};

  void add(const Preimage& p) {
    for (std::size_t k = 0; k < 2; ++k) {
      lower[k] = std::min(lower[k], p[k]);
      upper[k] = std::max(upper[k], p[k]);
    }
  }
  bool meets(const PlaneBox& other) const {
    for (std::size_t k = 0; k < 2; ++k)
      if (lower[k] > other.upper[k] || other.lower[k] > upper[k]) return false;
    return true;
  }
};

/// The boxes of parts of a polyline, cut in two again and again.
class LineTree {
 public:
  explicit LineTree(const PlaneLine& line) : line_(line) { build(0, line.points.size() - 1); }

  /// Calls `visit` with indices of segments that may cross, each pair once.
  template <class Visit>
  static void cross(const LineTree& a, const LineTree& b, const Visit& visit) {
    cross(a, 0, b, 0, visit);
  }

 private:
  struct Node {
    PlaneBox box;
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t left = 0;
    std::size_t right = 0;
  };

  std::size_t build(std::size_t first, std::size_t last) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({{}, first, last, 0, 0});
    PlaneBox box;
    if (last - first <= 1) {
      box.add(line_.points[first]);
      box.add(line_.points[last]);
    } else {
      const std::size_t middle = (first + last) / 2;
      const std::size_t left = build(first, middle);
      const std::size_t right = build(middle, last);
      nodes_[index].left = left;
      nodes_[index].right = right;
      for (const std::size_t child : {left, right}) {
        box.add(nodes_[child].box.lower);
        box.add(nodes_[child].box.upper);
      }
    }
    nodes_[index].box = box;
    return index;
  }

  template <class Visit>
  static void cross(const LineTree& a, std::size_t i, const LineTree& b, std::size_t j, const Visit& visit) {
    const Node& p = a.nodes_[i];
    const Node& q = b.nodes_[j];
    if (&a == &b && q.last <= p.first) return;
    if (!p.box.meets(q.box)) return;
    if (p.left == 0 && q.left == 0) {
      if (&a != &b || q.first > p.first + 1) visit(p.first, q.first);
    } else if (q.left == 0 || (p.left != 0 && p.last - p.first >= q.last - q.first)) {
      cross(a, p.left, b, j, visit);
      cross(a, p.right, b, j, visit);
    } else {
      cross(a, i, b, q.left, visit);
      cross(a, i, b, q.right, visit);
    }
  }

  const PlaneLine& line_;
  std::vector<Node> nodes_;
};

/// The place on the first of two segments at which they cross.
std::optional<double> crossing(const Preimage& a, const Preimage& b, const Preimage& c, const Preimage& d) {
  const auto cross = [](const Preimage& p, const Preimage& q) { return p[0] * q[1] - p[1] * q[0]; };
  const Preimage ab{b[0] - a[0], b[1] - a[1]};
  const Preimage cd{d[0] - c[0], d[1] - c[1]};
  const Preimage ac{c[0] - a[0], c[1] - a[1]};
  const double turn = cross(ab, cd);
  if (turn == 0) return std::nullopt;
  // A little more than the segments, whose ends are on the curves as far as chords go.
  constexpr double slack = 0.01;
  const double place = cross(ac, cd) / turn;
  const double other = cross(ac, ab) / turn;
  if (place < -slack || place > 1 + slack || other < -slack || other > 1 + slack) return std::nullopt;
  return place;
}

Preimage between(const Preimage& a, const Preimage& b, double place) {
  return {std::lerp(a[0], b[0], place), std::lerp(a[1], b[1], place)};
}

class TripleSearch {
 public:
  TripleSearch(const symbolic::SurfacePiece& patch, const std::vector<SurfaceComponent>& curves, const Context& context)
      : patch_(patch), surface_(patch.map), context_(context) {
    for (std::size_t k = 0; k < 2; ++k) {
      const bridge::RealBall width(patch.region->sides[k].upper - patch.region->sides[k].lower, 64);
      width_[k] = arf_get_d(arb_midref(width.get()), ARF_RND_NEAR);
    }
    for (const SurfaceComponent& curve : curves) {
      if (curve.kind != SurfaceComponentKind::curve && curve.kind != SurfaceComponentKind::loop) continue;
      if (curve.points.size() < 2) continue;
      PlaneLine first;
      for (const SurfacePoint& at : curve.points) {
        first.points.push_back({at.parameters[0], at.parameters[1]});
        first.others.push_back({at.parameters[2], at.parameters[3]});
      }
      lines_.push_back({first.others, first.points});
      lines_.push_back(std::move(first));
    }
  }

  std::vector<SurfaceSingularPoint> run() && {
    std::vector<LineTree> trees;
    trees.reserve(lines_.size());
    for (const PlaneLine& line : lines_) trees.emplace_back(line);
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t j = i; j < lines_.size(); ++j) {
        context_.checkpoint("looking for triple points");
        LineTree::cross(trees[i], trees[j], [&](std::size_t p, std::size_t q) { look_at(lines_[i], p, lines_[j], q); });
      }
    return std::move(found_);
  }

 private:
  void look_at(const PlaneLine& a, std::size_t i, const PlaneLine& b, std::size_t j) {
    const auto place = crossing(a.points[i], a.points[i + 1], b.points[j], b.points[j + 1]);
    const auto other = crossing(b.points[j], b.points[j + 1], a.points[i], a.points[i + 1]);
    if (!place || !other) return;
    Preimages at{between(a.points[i], a.points[i + 1], *place), between(a.others[i], a.others[i + 1], *place),
                 between(b.others[j], b.others[j + 1], *other)};
    std::sort(at.begin(), at.end());
    if (is_near(at[0], at[1]) || is_near(at[1], at[2]) || is_near(at[0], at[2]) || is_known(at)) return;
    prove(at);
  }

  /// Pairs that come together in a pinch point are no triple.
  bool is_near(const Preimage& a, const Preimage& b, double distance = 1e-6) const {
    return std::fabs(a[0] - b[0]) < distance * width_[0] && std::fabs(a[1] - b[1]) < distance * width_[1];
  }

  bool is_known(const Preimages& at) const {
    // Found three times, from polylines.
    constexpr double same = 1e-4;
    return std::any_of(known_.begin(), known_.end(), [&](const Preimages& other) {
      for (const Preimage& p : at)
        if (std::none_of(other.begin(), other.end(), [&](const Preimage& q) { return is_near(p, q, same); }))
          return false;
      return true;
    });
  }

  bridge::BallSurface::Jet jet_at(const ComplexBall& a, const ComplexBall& b, long bits) const {
    const ComplexBall one(1, 0);
    return surface_.jet_at({a, one, b, one}, {0, 2}, bits);
  }

  /// Phi(p) = Phi(q) and Phi(q) = Phi(r) in affine coordinates, multiplied by both weights.
  bridge::SystemValue equations(const std::vector<ComplexBall>& z, long bits) const {
    std::vector<bridge::BallSurface::Jet> jets;
    for (std::size_t i = 0; i < 3; ++i) jets.push_back(jet_at(z[2 * i], z[2 * i + 1], bits));
    bridge::SystemValue result;
    const auto minor = [bits](const std::vector<ComplexBall>& x, const std::vector<ComplexBall>& y, std::size_t k) {
      ComplexBall value;
      ComplexBall product;
      acb_mul(value.get(), x[k].get(), y[3].get(), bits);
      acb_mul(product.get(), y[k].get(), x[3].get(), bits);
      acb_sub(value.get(), value.get(), product.get(), bits);
      return value;
    };
    for (std::size_t pair = 0; pair < 2; ++pair)
      for (std::size_t k = 0; k < 3; ++k) {
        result.values.push_back(minor(jets[pair].point, jets[pair + 1].point, k));
        std::vector<ComplexBall>& row = result.jacobian.emplace_back(6);
        for (std::size_t by = 0; by < 2; ++by) {
          row[2 * pair + by] = minor(jets[pair].derivatives[by], jets[pair + 1].point, k);
          row[2 * pair + 2 + by] = minor(jets[pair].point, jets[pair + 1].derivatives[by], k);
        }
      }
    return result;
  }

  void prove(const Preimages& at) {
    std::vector<ComplexBall> start;
    for (const Preimage& p : at)
      for (const double x : p) start.emplace_back(x, 0);
    const auto zero = bridge::enclose_system_zero(
        [this](const std::vector<ComplexBall>& z, long bits) { return equations(z, bits); }, start, precision_bits);
    if (!zero || !is_triple_inside(*zero)) return;
    // A real box with one zero: that is real.
    Preimages proven;
    for (std::size_t i = 0; i < 6; ++i) proven[i / 2][i % 2] = middle((*zero)[i]);
    std::sort(proven.begin(), proven.end());
    if (is_known(proven)) return;
    known_.push_back(proven);
    found_.push_back(point_at(proven, *zero));
  }

  bool is_triple_inside(const std::vector<ComplexBall>& zero) const {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        const symbolic::Interval& side = patch_.region->sides[k];
        const bridge::RealBall lower(side.lower, precision_bits);
        const bridge::RealBall upper(side.upper, precision_bits);
        const ComplexBall& x = zero[2 * i + k];
        if (arb_ge(x.real(), lower.get()) == 0 || arb_le(x.real(), upper.get()) == 0) return false;
      }
      const std::size_t j = (i + 1) % 3;
      if (acb_overlaps(zero[2 * i].get(), zero[2 * j].get()) != 0 &&
          acb_overlaps(zero[2 * i + 1].get(), zero[2 * j + 1].get()) != 0)
        return false;
    }
    // With a weight of 0 the equations say nothing.
    for (std::size_t i = 0; i < 3; ++i)
      if (acb_contains_zero(jet_at(zero[2 * i], zero[2 * i + 1], precision_bits).point[3].get()) != 0) return false;
    return true;
  }

  SurfaceSingularPoint point_at(const Preimages& at, const std::vector<ComplexBall>& zero) const {
    SurfaceSingularPoint point;
    point.kind = SurfaceSingularity::triple_point;
    point.certified = true;
    // Three double curves pass through it.
    point.half_branches = 6;
    point.at.parameters = {at[0][0], at[0][1], at[1][0], at[1][1]};
    point.third_preimage = at[2];
    double size = 0;
    bridge::Magnitude widest;
    const auto widen = [&](const ComplexBall& ball, double value) {
      size = std::max(size, std::fabs(value));
      mag_max(widest.get(), widest.get(), arb_radref(ball.real()));
    };
    for (const ComplexBall& x : zero) widen(x, middle(x));
    const auto image = jet_at(zero[0], zero[1], precision_bits).point;
    for (std::size_t k = 0; k < 3; ++k) {
      ComplexBall x;
      acb_div(x.get(), image[k].get(), image[3].get(), precision_bits);
      point.at.point[k] = middle(x);
      widen(x, point.at.point[k]);
    }
    point.radius = mag_get_d(widest.get()) + 0x1p-52 * size;
    return point;
  }

  const symbolic::SurfacePiece& patch_;
  bridge::BallSurface surface_;
  const Context& context_;
  std::array<double, 2> width_{};
  std::vector<PlaneLine> lines_;
  std::vector<Preimages> known_;
  std::vector<SurfaceSingularPoint> found_;
};

}  // namespace

std::vector<SurfaceSingularPoint> triple_points(const symbolic::SurfacePiece& patch,
                                                const std::vector<SurfaceComponent>& double_curves,
                                                const Context& context) {
  return TripleSearch(patch, double_curves, context).run();
}

}  // namespace eliminant::intersect
