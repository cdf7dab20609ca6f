// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/kept_distance.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <eliminant/bridge/branches/patch_difference.hpp>
#include <eliminant/bridge/branches/surface_cell.hpp>
#include <eliminant/bridge/contacts/height_series.hpp>
#include <eliminant/bridge/contacts/local_tables.hpp>
#include <eliminant/bridge/contacts/tangential_elimination.hpp>
#include <eliminant/bridge/enclosures/taylor_model.hpp>
#include <eliminant/bridge/nets/graph_slopes.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

namespace {

constexpr std::size_t weight = 3;
constexpr double slack = 1.000001;

/// The parameters of the second patch at which its coordinates along the tangent plane of the first are those of the
/// origin of the frame, approximately.
std::optional<std::array<double, 2>> opposite(PatchJets& second, const ContactFrame& frame, std::array<double, 2> at) {
  constexpr int most_steps = 12;
  double step = INFINITY;
  for (int i = 0; i < most_steps && step > 1e-15; ++i) {
    // Control points tell little far beyond the domain.
    constexpr double beyond = 0.02;
    for (const double x : at)
      if (!(x > -beyond && x < 1 + beyond)) return std::nullopt;
    const PatchJets::Value value = second.at(at[0], at[1]);
    Eigen::Matrix2d derivative;
    Eigen::Vector2d rest;
    for (long row = 0; row < 2; ++row) {
      rest[row] = coordinate(frame, value.point - frame.origin, row);
      for (long k = 0; k < 2; ++k)
        derivative(row, k) = coordinate(frame, value.first[static_cast<std::size_t>(k)], row);
    }
    const Eigen::Vector2d change = derivative.partialPivLu().solve(rest);
    if (!change.allFinite()) return std::nullopt;
    at = {at[0] - change[0], at[1] - change[1]};
    step = change.lpNorm<Eigen::Infinity>();
  }
  if (!(step < 1e-9)) return std::nullopt;
  return at;
}

/// The derivative of a patch along the plane, inverted.
Eigen::Matrix2d inverse_along_plane(const ContactFrame& frame, const PatchJets::Value& value) {
  Eigen::Matrix2d derivative;
  for (long row = 0; row < 2; ++row)
    for (long k = 0; k < 2; ++k) derivative(row, k) = coordinate(frame, value.first[static_cast<std::size_t>(k)], row);
  return derivative.inverse();
}

/// The height of the first patch above the second and its derivatives at one point, without bounds.
struct Height {
  double value;
  std::array<double, 2> gradient;
  double uu;
  double uv;
  double vv;
  /// The inverse of the derivative of the second patch along the plane.
  Eigen::Matrix2d follow;
};

/// Where both patches have the same coordinates along the plane.
std::optional<Height> height_at(const ContactFrame& frame, const PatchJets::Value& a, const PatchJets::Value& b) {
  const Eigen::Matrix2d follow = inverse_along_plane(frame, b);
  if (!follow.allFinite()) return std::nullopt;
  // The normal of the second patch with its last component 1; the first patch has unit slopes along the plane.
  Eigen::Vector3d normal(0, 0, 1);
  for (long i = 0; i < 2; ++i)
    normal[i] = -(coordinate(frame, b.first[0], 2) * follow(0, i) + coordinate(frame, b.first[1], 2) * follow(1, i));
  const auto bend = [&](long i, long j) {
    const Array4d bend_of_second = b.second[0] * (follow(0, i) * follow(0, j)) +
                                   b.second[1] * (follow(0, i) * follow(1, j) + follow(1, i) * follow(0, j)) +
                                   b.second[2] * (follow(1, i) * follow(1, j));
    const Array4d difference = a.second[static_cast<std::size_t>(i + j)] - bend_of_second;
    double sum = 0;
    for (long c = 0; c < 3; ++c) sum += normal[c] * coordinate(frame, difference, c);
    return sum;
  };
  return Height{
      coordinate(frame, a.point - b.point, 2), {normal[0], normal[1]}, bend(0, 0), bend(0, 1), bend(1, 1), follow};
}

/// A point of the second patch opposite of one of the first, in a direction.
struct OppositePoint {
  /// The tangents of the first patch there become the first two coordinates, the direction the third.
  ContactFrame frame;
  std::array<double, 2> at{};
  /// The inverse of the derivative of the second patch along the plane.
  Eigen::Matrix2d follow;
};

/// The point with a parallel tangent plane, near one: in its direction translated patches are opposite everywhere, in
/// that of the normal only nearly. nullopt where the direction is far from the normal.
std::optional<OppositePoint> parallel_point(const PatchJets::Value& here, PatchJets& second, const ContactFrame& frame,
                                            std::array<double, 2> at) {
  constexpr int steps = 4;
  PatchJets::Value there = second.at(at[0], at[1]);
  for (int i = 0; i < steps; ++i) {
    const Eigen::Matrix2d follow = inverse_along_plane(frame, there);
    if (!follow.allFinite()) return std::nullopt;
    Eigen::Vector2d slope;
    Eigen::Matrix2d bend;
    for (long k = 0; k < 2; ++k) slope[k] = coordinate(frame, there.first[static_cast<std::size_t>(k)], 2);
    for (long k = 0; k < 3; ++k)
      bend(k / 2, (k + 1) / 2) = coordinate(frame, there.second[static_cast<std::size_t>(k)], 2);
    bend(1, 0) = bend(0, 1);
    const Eigen::Vector2d gradient = follow.transpose() * slope;
    const Eigen::Matrix2d curvature = follow.transpose() * bend * follow;
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix2d> solver;
    solver.setThreshold(1e-6);
    const Eigen::Vector2d change = follow * solver.compute(curvature).solve(gradient);
    for (std::size_t k = 0; k < 2; ++k) {
      at[k] -= change[static_cast<long>(k)];
      // Control points tell little far beyond the domain.
      constexpr double beyond = 0.02;
      if (!(at[k] > -beyond && at[k] < 1 + beyond)) return std::nullopt;
    }
    there = second.at(at[0], at[1]);
  }
  const Eigen::Vector3d direction = space_part(here.point - there.point);
  Eigen::Matrix3d axes;
  axes << space_part(here.first[0]), space_part(here.first[1]), direction.normalized();
  const Eigen::Vector3d normal = axes.col(0).cross(axes.col(1)).normalized();
  constexpr double least_cosine = 0.2;
  if (!(std::fabs(normal.dot(axes.col(2))) > least_cosine)) return std::nullopt;
  const Eigen::Matrix3d inverse = axes.inverse();
  OppositePoint result;
  result.frame.origin = here.point;
  for (long k = 0; k < 3; ++k)
    result.frame.columns[static_cast<std::size_t>(k)] = Array4d(inverse(0, k), inverse(1, k), inverse(2, k), 0);
  result.at = at;
  result.follow = inverse_along_plane(result.frame, there);
  if (!result.follow.allFinite()) return std::nullopt;
  return result;
}

/// Two parts, looked at from the middle of the first one and the point opposite.
class FacingParts {
 public:
  static std::optional<FacingParts> of(const ControlNet& first, const ControlNet& second, const CellBox& box) {
    const double u = 0.5 * (box.lower[0] + box.upper[0]);
    const double v = 0.5 * (box.lower[1] + box.upper[1]);
    const PatchJets::Value here = PatchJets(first).at(u, v);
    const auto frame = tangent_frame(here);
    if (!frame) return std::nullopt;
    PatchJets jets(second);
    const auto at = opposite(jets, *frame, {0.5 * (box.lower[2] + box.upper[2]), 0.5 * (box.lower[3] + box.upper[3])});
    if (!at) return std::nullopt;
    const auto height = height_at(*frame, here, jets.at((*at)[0], (*at)[1]));
    if (!height) return std::nullopt;
    return FacingParts(first, second, box, *frame, here, *at, *height);
  }

  /// Whether a proof has a chance: its bounds, from the values at the centre alone.
  bool may_keep_distance() const {
    const double sign = height_.value > 0 ? 1 : -1;
    const double curvature = std::min(sign * height_.uu, sign * height_.vv) - std::fabs(height_.uv);
    const double slope = std::hypot(height_.gradient[0], height_.gradient[1]);
    const double least = std::fabs(height_.value);
    return least > change_by_gradient() + change_by_curvature() || least * curvature > 0.5 * slope * slope;
  }
  /// Whether they bend alike, so that it may be proven with few cuts: the same, more generously, of large parts.
  bool seem_parallel() const {
    constexpr double much = 4;
    constexpr double little = 1.5;
    const double least = std::fabs(height_.value);
    return much * least > change_by_gradient() && little * least > change_by_curvature();
  }

  bool keep_distance() const { return keep_distance_by_curvature() || keep_distance_by_opposite_points(); }

 private:
  FacingParts(const ControlNet& first, const ControlNet& second, const CellBox& box, const ContactFrame& frame,
              const PatchJets::Value& here, const std::array<double, 2>& opposite, const Height& height)
      : first_(first),
        second_(second),
        box_(box),
        frame_(frame),
        here_(here),
        centre_{0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1]), opposite[0], opposite[1]},
        height_(height) {}

  /// By as much the height changes from the centre, to first order and by terms of the second.
  double change_by_gradient() const {
    return std::fabs(height_.gradient[0]) * reach(0) + std::fabs(height_.gradient[1]) * reach(1);
  }
  double change_by_curvature() const {
    const double p = reach(0);
    const double q = reach(1);
    return 0.5 * (std::fabs(height_.uu) * p * p + 2 * std::fabs(height_.uv) * p * q + std::fabs(height_.vv) * q * q);
  }
  double reach(std::size_t axis) const { return 0.5 * (box_.upper[axis] - box_.lower[axis]); }

  bool keep_distance_by_curvature() const {
    CellBox whole = box_;
    CellBox middle;
    for (std::size_t k = 0; k < 4; ++k) {
      // It holds the true values of the function, which are near; derivatives on much smaller boxes are all rounding.
      constexpr double near = 0x1p-22;
      middle.lower[k] = centre_[k] - near;
      middle.upper[k] = centre_[k] + near;
      whole.lower[k] = std::min(whole.lower[k], middle.lower[k]);
      whole.upper[k] = std::max(whole.upper[k], middle.upper[k]);
    }
    const std::array<double, 2> reach{std::max(whole.upper[0] - centre_[0], centre_[0] - whole.lower[0]),
                                      std::max(whole.upper[1] - centre_[1], centre_[1] - whole.lower[1])};
    const auto here = TangentialElimination::on(first_, second_, centre_, middle);
    if (!here) return false;
    const auto around = TangentialElimination::on(first_, second_, centre_, whole);
    if (!around) return false;
    // h at a point of the first patch at most that far from the centre: the coordinates along the plane agree where the
    // second patch has those of the first there.
    const DoubleInterval height = here->first.value[2] - here->second.value[2];
    double most = 0;
    for (std::size_t i = 0; i < 2; ++i) most += here->gradient[i].magnitude() * reach[i];
    const Hessian& h = around->hessian;
    most += 0.5 * (h.uu.magnitude() * reach[0] * reach[0] + 2 * h.uv.magnitude() * reach[0] * reach[1] +
                   h.vv.magnitude() * reach[1] * reach[1]);
    const double least = std::max(height.lower, -height.upper);
    if (least > slack * most) return true;
    // Where h bends away from zero, its least value is no farther than the gradient and the curvature say.
    const double sign = height.lower > 0 ? 1 : -1;
    const double curvature_u = sign > 0 ? h.uu.lower : -h.uu.upper;
    const double curvature_v = sign > 0 ? h.vv.lower : -h.vv.upper;
    const double curvature = std::min(curvature_u, curvature_v) - h.uv.magnitude();
    const double slope = std::hypot(here->gradient[0].magnitude(), here->gradient[1].magnitude());
    return least > 0 && curvature > 0 && least * curvature > slack * 0.5 * slope * slope;
  }

  using Model = TaylorModel<6>;
  /// Of the parameters of the opposite points.
  static constexpr std::size_t order = 5;

  /// With q(p) near the parameters of the opposite point and A(p) = B(s, t), the vector A(p) - B(q(p)) is the
  /// difference of two points of B: its part along the normal is bounded by that along the plane and the slopes of B.
  bool keep_distance_by_opposite_points() const {
    PatchJets jets(second_);
    const auto parallel = parallel_point(here_, jets, frame_, {centre_[2], centre_[3]});
    const OppositePoint opposite = parallel.value_or(OppositePoint{frame_, {centre_[2], centre_[3]}, height_.follow});
    const LocalPowers a =
        local_powers(first_, opposite.frame, {{box_.lower[0], box_.lower[1], 0}, {box_.upper[0], box_.upper[1], 0}}, 0);
    Array4d change = Array4d::Zero();
    for (std::size_t k = 1; k < a.coefficients.size(); ++k) change += a.coefficients[k].abs();
    const Array4d extent = change / a.coefficients[0][weight];
    // Around the opposite points, and around these and the part.
    OpenBox near{};
    OpenBox whole{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto row = static_cast<long>(k);
      const double room = 1.25 + extent[weight];
      const double half =
          room * (std::fabs(opposite.follow(row, 0)) * extent[0] + std::fabs(opposite.follow(row, 1)) * extent[1]);
      near.lower[k] = opposite.at[k] - half;
      near.upper[k] = opposite.at[k] + half;
      whole.lower[k] = std::min(near.lower[k], box_.lower[2 + k]);
      whole.upper[k] = std::max(near.upper[k], box_.upper[2 + k]);
      // Control points tell little far beyond the domain.
      constexpr double beyond = 0.25;
      if (!(whole.lower[k] > -beyond && whole.upper[k] < 1 + beyond)) return false;
    }
    const local::EnclosedSlopes slopes(taylor_on_box(second_, opposite.frame, whole, 0, 1));
    const Eigen::Matrix2d& follow = opposite.follow;
    const GraphSlopes graph(slopes.slope, {{{follow(0, 0), follow(0, 1)}, {follow(1, 0), follow(1, 1)}}});
    const std::array<double, 2> steepness{graph.normal[0].magnitude(), graph.normal[1].magnitude()};
    if (!std::isfinite(steepness[0]) || !std::isfinite(steepness[1])) return false;
    const LocalPowers b = local_powers(second_, opposite.frame, near, 0);
    const auto between = difference(a, b);
    if (!between) return false;
    const Model& along_normal = (*between)[2];
    const double least = std::fabs(along_normal.constant()) - along_normal.variation();
    return least > slack * (steepness[0] * (*between)[0].magnitude() + steepness[1] * (*between)[1].magnitude());
  }

  /// A(p) - B(q(p)) in the frame, up to a positive factor; p are the local parameters of the first part. nullopt where
  /// q leaves the box of the second.
  std::optional<std::array<Model, 3>> difference(const LocalPowers& a, const LocalPowers& b) const {
    const auto table = [](const LocalPowers& powers) {
      TaylorTable<double> result(2, order);
      for (std::size_t i = 0; i <= std::min(order, powers.degree[0]); ++i)
        for (std::size_t j = 0; j <= std::min(order - i, powers.degree[1]); ++j)
          for (std::size_t k = 0; k < 4; ++k)
            result.at(i, j)[k] = powers.coefficients[i * (powers.degree[1] + 1) + j][static_cast<long>(k)];
      return result;
    };
    const bool polynomial = first_.polynomial && second_.polynomial;
    const auto followed = height_series<order>(table(a), table(b), order, polynomial).second;
    // The powers of both parameters of the second.
    std::array<std::vector<Model>, 2> power;
    for (std::size_t k = 0; k < 2; ++k) {
      Model q;
      for (std::size_t i = 0; i <= order; ++i)
        for (std::size_t j = 0; i + j <= order; ++j) q.add_term(followed[k].at(i, j), i, j);
      if (!(q.magnitude() < 1)) return std::nullopt;
      power[k].emplace_back(1);
      while (power[k].size() <= b.degree[k]) power[k].push_back(power[k].back() * q);
    }
    std::array<Model, 4> of_first;
    std::array<Model, 4> of_second;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto lane = static_cast<long>(k);
      for (std::size_t i = 0; i <= a.degree[0]; ++i)
        for (std::size_t j = 0; j <= a.degree[1]; ++j)
          of_first[k].add_term(a.coefficients[i * (a.degree[1] + 1) + j][lane], i, j);
      of_first[k].add_error(a.error[lane]);
      of_second[k].add_error(b.error[lane]);
    }
    for (std::size_t i = 0; i <= b.degree[0]; ++i)
      for (std::size_t j = 0; j <= b.degree[1]; ++j) {
        const Model product = power[0][i] * power[1][j];
        for (std::size_t k = 0; k < 4; ++k)
          of_second[k].add_product(b.coefficients[i * (b.degree[1] + 1) + j][static_cast<long>(k)], product);
      }
    std::array<Model, 3> result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] =
          polynomial ? of_first[k] - of_second[k] : of_first[k] * of_second[weight] - of_first[weight] * of_second[k];
    return result;
  }

  const ControlNet& first_;
  const ControlNet& second_;
  CellBox box_;
  /// In the middle of the first part.
  ContactFrame frame_;
  PatchJets::Value here_;
  /// Of both points.
  std::array<double, 4> centre_;
  Height height_;
};

/// Cuts the parameters of both patches until all pairs of parts are apart.
class DistanceSearch {
 public:
  DistanceSearch(const ControlNet& first, const ControlNet& second) : first_(first), second_(second) {
    for (std::size_t k = 0; k < 2; ++k) {
      test_.first.shape.degree[k] = first.degrees[k];
      test_.second.shape.degree[k] = second.degrees[k];
    }
    test_.first.polynomial = first.polynomial;
    test_.second.polynomial = second.polynomial;
  }

  bool run() {
    CellBox root;
    root.upper.fill(1);
    const auto whole = FacingParts::of(first_, second_, root);
    if (!whole || !whole->seem_parallel()) return false;
    std::vector<CellBox> rest{root};
    for (unsigned long looked_at = 0; !rest.empty(); ++looked_at) {
      const CellBox box = rest.back();
      rest.pop_back();
      constexpr unsigned long most = 4000;
      if (looked_at > most) return false;
      const auto cut = axis_to_cut(box);
      if (!cut) continue;
      // Where parts that are small do not seem to keep a distance, they will not at last.
      constexpr double small = 0.1;
      if (box.upper[*cut] - box.lower[*cut] < small) {
        const auto facing = FacingParts::of(first_, second_, box);
        if (facing && !facing->may_keep_distance()) return false;
      }
      CellBox lower = box;
      CellBox upper = box;
      lower.upper[*cut] = upper.lower[*cut] = 0.5 * (box.lower[*cut] + box.upper[*cut]);
      rest.push_back(lower);
      rest.push_back(upper);
    }
    return true;
  }

 private:
  /// nullopt when the parts are apart.
  std::optional<std::size_t> axis_to_cut(const CellBox& box) {
    part(first_, test_.first, box, 0, points_[0]);
    part(second_, test_.second, box, 2, points_[1]);
    if (bound(test_.first) && bound(test_.second) && (test_.apart() || test_.examine().excluded)) return std::nullopt;
    const auto facing = FacingParts::of(first_, second_, box);
    if (facing && facing->may_keep_distance() && facing->keep_distance()) return std::nullopt;
    const std::array<double, 4> spreads = test_.spreads();
    return static_cast<std::size_t>(std::max_element(spreads.begin(), spreads.end()) - spreads.begin());
  }

  static void part(const ControlNet& net, Side<2>& side, const CellBox& box, std::size_t axis,
                   std::vector<Array4d>& points) {
    points = net.points;
    side.points = points.data();
    side.error = net.error;
    bound(side);
    const double degrees = static_cast<double>(net.degrees[0] + net.degrees[1]);
    side.error = net.error + 10 * degrees * unit_roundoff * side.size;
    if (net.polynomial) side.error[weight] = 0;
    for (std::size_t k = 0; k < 2; ++k)
      restrict_to(side.shape, k, box.lower[axis + k], box.upper[axis + k], points.data());
  }

  const ControlNet& first_;
  const ControlNet& second_;
  SurfaceCell test_;
  std::array<std::vector<Array4d>, 2> points_;
};

}  // namespace

bool keep_distance(const ControlNet& first, const ControlNet& second, const CellBox& box) {
  const auto facing = FacingParts::of(first, second, box);
  return facing && facing->may_keep_distance() && facing->keep_distance();
}

bool keep_distance(const ControlNet& first, const ControlNet& second) { return DistanceSearch(first, second).run(); }

}  // namespace eliminant::bridge
