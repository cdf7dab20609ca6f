// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/patch_border_points.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <eliminant/bridge/contacts/exact_contact.hpp>
#include <eliminant/bridge/nets/bernstein_subdivision.hpp>
#include <eliminant/bridge/nets/exact_plane.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Rational;

Rational value_of(const Plane& plane, const ExactPoint& point) {
  Rational sum;
  for (std::size_t k = 0; k < 4; ++k) sum = sum + plane[k] * point[k];
  return sum;
}

/// Of a patch, where the parameter of the axis is 0 or 1.
ExactNet border_of(const ExactNet& net, std::size_t axis, int side) {
  const std::size_t row = net.degrees[1] + 1;
  const std::size_t kept = side < 0 ? 0 : net.degrees[axis];
  ExactNet curve{{net.degrees[1 - axis]}, {}};
  for (std::size_t i = 0; i <= net.degrees[1 - axis]; ++i)
    curve.points.push_back(net.points[axis == 0 ? kept * row + i : i * row + kept]);
  return curve;
}

ControlNet border_of(const ControlNet& net, std::size_t axis, int side) {
  const std::size_t row = net.degrees[1] + 1;
  const std::size_t kept = side < 0 ? 0 : net.degrees[axis];
  ControlNet curve;
  curve.degrees = {net.degrees[1 - axis]};
  curve.error = net.error;
  curve.polynomial = net.polynomial;
  for (std::size_t i = 0; i <= net.degrees[1 - axis]; ++i)
    curve.points.push_back(net.points[axis == 0 ? kept * row + i : i * row + kept]);
  return curve;
}

/// A border curve of one patch against the other patch.
struct BorderProblem {
  std::size_t axis;
  int side;
  /// Places of the parameters of the curve and of the other patch among u, v, s, t.
  std::array<std::size_t, 3> place;
};

class BorderSearch {
 public:
  BorderSearch(const ControlNet& first, const ControlNet& second, const ExactNet& exact_first,
               const ExactNet& exact_second, const BorderMeetings& meetings, const FindContainedParts& contained_parts,
               const Context& context, ContactCurves* curves)
      : nets_{&first, &second},
        exact_{&exact_first, &exact_second},
        jets_{PatchJets(first), PatchJets(second)},
        meetings_(meetings),
        contained_parts_(contained_parts),
        context_(context),
        curves_(curves) {}

  BorderPoints run() && {
    for (std::size_t axis = 0; axis < 4; ++axis)
      for (const int side : {-1, 1}) look_at(axis, side);
    // What is on a border curve that is contained ends no other arc, and is no reason to leave a border open.
    const auto is_contained = [&](const CrossingPoint& point) {
      return std::any_of(result_.contained.begin(), result_.contained.end(), [&](const ContainedBorder& border) {
        return border.holds(point.parameters, point.radius + 0x1p-40);
      });
    };
    std::erase_if(result_.points, is_contained);
    for (const auto& [point, border] : undecided_)
      if (!is_contained(point)) result_.open.push_back(border);
    for (auto& [point, touched] : touched_)
      if (!is_contained(point)) result_.touched.push_back(std::move(touched));
    return std::move(result_);
  }

 private:
  void look_at(std::size_t axis, int side) {
    const std::size_t own = axis / 2;
    const ControlNet curve = border_of(*nets_[own], axis % 2, side);
    const ControlNet& patch = *nets_[1 - own];
    std::optional<ExactNet> exact_curve;
    const ContactProver::Exact of_curve = [&]() -> const ExactNet& {
      if (!exact_curve) exact_curve = border_of(*exact_[own], axis % 2, side);
      return *exact_curve;
    };
    const ContactProver::Exact of_patch = [&]() -> const ExactNet& { return *exact_[1 - own]; };
    ContactProver prover(curve, patch, of_curve, of_patch);
    const BorderProblem problem{axis, side, {2 * own + 1 - axis % 2, 2 - 2 * own, 3 - 2 * own}};
    const FindContact find_contact = [&](const std::array<double, 3>& near, double reach) {
      if (const auto box = on_contact_curve(problem, near, reach)) return box;
      return prover.find(near, reach);
    };
    SubdivisionResult found = bernstein_subdivision(curve, patch, find_contact, SubdivisionLimits(), context_);
    if (!found.complete || !found.open.empty()) {
      // Small parts of larger patches are so flat that nearly parallel ones can still be told apart.
      SubdivisionLimits flat;
      flat.part = 0x1p-12;
      flat.largest_radius = 0x1p-16;
      found = bernstein_subdivision(curve, patch, find_contact, flat, context_);
    }
    if (!found.complete || !found.open.empty()) {
      const ContainedParts parts = contained_parts_(axis, side);
      for (const auto& [lower, upper] : parts.intervals) {
        result_.contained.push_back({axis, side, lower, upper, parts.one_point});
        if (curves_ != nullptr && !parts.one_point) curves_->find_along(axis, side, lower, upper);
      }
      if (parts.nothing_else) return;
      if (parts.intervals.empty()) result_.open.push_back({axis, side, "the border curve touches the other surface"});
      if (parts.one_point)
        result_.open.push_back({axis, side, "it is one point, which lies in the other surface"});
      else if (!parts.intervals.empty())
        result_.open.push_back({axis, side, "a part of the border curve lies in the other surface"});
      return;
    }
    for (const IsolatedZero& zero : found.zeros) add_crossing(problem, zero, prover, of_curve);
    for (const RationalZero& contact : prover.contacts())
      if (!is_on_contact_curve(problem, contact)) add_contact(problem, contact);
  }

  /// Parameters of a border curve and the other patch around `near`, in which there are only points of curves of
  /// contact.
  std::optional<OpenBox> on_contact_curve(const BorderProblem& problem, const std::array<double, 3>& near,
                                          double reach) {
    if (curves_ == nullptr) return std::nullopt;
    std::array<double, 4> point{};
    std::array<double, 4> half{};
    point[problem.axis] = problem.side < 0 ? 0 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      point[problem.place[k]] = near[k];
      half[problem.place[k]] = std::min(reach, 0.5);
    }
    auto box = curves_->explained_around(problem.axis, point, half);
    if (!box && curves_->find(point, reach)) box = curves_->explained_around(problem.axis, point, half);
    if (!box) return std::nullopt;
    OpenBox result{};
    for (std::size_t k = 0; k < 3; ++k) {
      result.lower[k] = box->lower[problem.place[k]];
      result.upper[k] = box->upper[problem.place[k]];
    }
    return result;
  }

  bool is_on_contact_curve(const BorderProblem& problem, const RationalZero& contact) const {
    if (curves_ == nullptr || curves_->curves().empty()) return false;
    return curves_->holds(parameters_of(problem, contact));
  }

  static CrossingPoint placed(const BorderProblem& problem, const IsolatedZero& zero) {
    CrossingPoint point;
    point.parameters[problem.axis] = problem.side < 0 ? 0 : 1;
    point.side[problem.axis] = problem.side;
    for (std::size_t k = 0; k < 3; ++k) point.parameters[problem.place[k]] = zero.parameters[k];
    point.radius = zero.radius;
    return point;
  }

  void add_crossing(const BorderProblem& problem, const IsolatedZero& zero, const ContactProver& prover,
                    const ContactProver::Exact& curve) {
    BorderPoint point;
    static_cast<CrossingPoint&>(point) = placed(problem, zero);
    std::optional<std::array<Rational, 3>> exact;
    bool asked = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = zero.parameters[k];
      if (value - zero.radius > 0 && value + zero.radius < 1) continue;
      if (!asked) exact = prover.exact_zero(zero);
      asked = true;
      const int end = value < 0.5 ? -1 : 1;
      if (exact) {
        const Rational& parameter = (*exact)[k];
        if (parameter.sign() < 0 || Rational(1) < parameter) return;
        if (parameter.is_zero() || (parameter - Rational(1)).is_zero()) set_side(point, problem.place[k], end);
      } else if (k > 0 && (is_on_border_of_patch(problem, point, problem.place[k], end, curve()) ||
                           meets_border(problem, zero, problem.place[k], end))) {
        set_side(point, problem.place[k], end);
      } else {
        undecided_.push_back(
            {point, {problem.axis, problem.side, "it is undecided whether a point of it lies within the other patch"}});
        return;
      }
    }
    const std::optional<unsigned> arcs = arcs_inside(point);
    if (!arcs) {
      undecided_.push_back({point, {problem.axis, problem.side, "the intersection is nearly tangent to a border"}});
      return;
    }
    point.arcs = *arcs;
    add(point);
  }

  static void set_side(CrossingPoint& point, std::size_t place, int end) {
    point.side[place] = end;
    point.parameters[place] = end < 0 ? 0 : 1;
  }

  /// Both border curves lie in one plane, which the other patch leaves at the point away from its border: the point,
  /// being in the plane, is on the border.
  bool is_on_border_of_patch(const BorderProblem& problem, const CrossingPoint& point, std::size_t axis, int end,
                             const ExactNet& curve) {
    const std::size_t other = axis / 2;
    std::vector<ExactPoint> points = curve.points;
    const ExactNet border = border_of(*exact_[other], axis % 2, end);
    points.insert(points.end(), border.points.begin(), border.points.end());
    const std::optional<Plane> plane = plane_through(points);
    if (!plane || other == problem.axis / 2) return false;
    // The derivative of the plane's form across the border, for all parameters within the radius.
    ExactNet heights = *exact_[other];
    for (ExactPoint& p : heights.points) p = {value_of(*plane, p), Rational(), Rational(), Rational(1)};
    const auto net = ControlNet::round(heights.degrees, heights.points, {});
    if (!net) return false;
    PatchJets jets(*net);
    const double a = point.parameters[2 * other];
    const double b = point.parameters[2 * other + 1];
    const double reach = 4 * point.radius + 0x1p-40;
    // Bounds on a box as narrow as the radius would be those of roundings.
    const double wide = reach + 0x1p-12;
    const auto bounds = jets.bounds_on(a - wide, a + wide, b - wide, b + wide);
    const PatchJets::Value here = jets.at(a, b);
    const double slope = std::fabs(here.first[axis % 2][0]);
    const double change = (bounds->second[0] + 2 * bounds->second[1] + bounds->second[2])[0] * 2 * reach;
    return slope > 2 * change + 1e-9 * bounds->first[axis % 2][0];
  }

  /// Both border curves meet where the zero is, which is the only one near.
  bool meets_border(const BorderProblem& problem, const IsolatedZero& zero, std::size_t axis, int end) const {
    const std::size_t along_other = axis % 2 == 0 ? 2 : 1;
    const bool of_first = problem.axis < 2;
    const auto meetings =
        of_first ? meetings_(problem.axis, problem.side, axis, end) : meetings_(axis, end, problem.axis, problem.side);
    constexpr double accuracy = 1e-11;
    const double near = zero.radius + accuracy;
    return std::any_of(meetings.begin(), meetings.end(), [&](const std::array<double, 2>& at) {
      return near < zero.isolation && std::fabs(at[of_first ? 0 : 1] - zero.parameters[0]) <= near &&
             std::fabs(at[of_first ? 1 : 0] - zero.parameters[along_other]) <= near;
    });
  }

  void add_contact(const BorderProblem& problem, const RationalZero& contact) {
    for (const Rational& parameter : contact.parameters)
      if (parameter.sign() < 0 || Rational(1) < parameter) return;
    BorderPoint point;
    static_cast<CrossingPoint&>(point) = placed(problem, rounded_parameters(contact.parameters));
    for (std::size_t k = 0; k < 3; ++k) {
      if (contact.parameters[k].is_zero()) point.side[problem.place[k]] = -1;
      if ((contact.parameters[k] - Rational(1)).is_zero()) point.side[problem.place[k]] = 1;
    }
    const long sides = std::count_if(point.side.begin(), point.side.end(), [](int s) { return s != 0; });
    point.touching = true;
    const auto undecided = [&](const char* reason) {
      touched_.push_back({point, {parameters_of(problem, contact), {problem.axis, problem.side, reason}}});
    };
    // Other borders, in a corner, may be crossed outwards in both directions.
    if (sides > 1 && arcs_inside(point) == 0U) {
      point.arcs = 0;
      return add(point);
    }
    // Even contact stays on one side of the border.
    if (contact.multiplicity > 2) return undecided("the intersection touches the border of high order");
    const std::optional<double> bend = bend_across(point, problem.axis);
    if (!bend) return undecided("the surfaces are tangent at the border");
    point.arcs = *bend * problem.side < 0 ? 2 : 0;
    // Outside of this border it is outside of the others as well; inside, they would have to be asked.
    if (sides > 1 && point.arcs > 0) return undecided("the intersection touches the border in a corner");
    add(point);
  }

  static std::array<Rational, 4> parameters_of(const BorderProblem& problem, const RationalZero& contact) {
    std::array<Rational, 4> result;
    result[problem.axis] = Rational(problem.side < 0 ? 0 : 1);
    for (std::size_t k = 0; k < 3; ++k) result[problem.place[k]] = contact.parameters[k];
    return result;
  }

  struct Jet {
    /// By parameters in units in which each moves the point by one: patches of any sizes are alike.
    Eigen::Matrix<double, 3, 4> jacobian;
    Eigen::Vector4d unit;
    Eigen::Vector3d bend(const Eigen::Vector4d& direction) const {
      const Eigen::Vector4d d = direction.cwiseProduct(unit);
      const Array4d value = along(first.second, d[0], d[1]) - along(second.second, d[2], d[3]);
      return {value[0], value[1], value[2]};
    }
    PatchJets::Value first;
    PatchJets::Value second;
    /// Bounds the length of the error of each column.
    Eigen::Vector4d error;
    /// The minors of the matrix.
    Eigen::Vector4d tangent;
    Eigen::Vector4d tangent_error;
  };

  /// Bounds the error of the determinant of three columns; products of nearly parallel columns take errors away.
  static double error_of_determinant(const Eigen::Matrix3d& columns, const Eigen::Vector3d& error) {
    const auto cross = [&](long i, long j) { return columns.col(i).cross(columns.col(j)).norm(); };
    const auto length = [&](long i) { return columns.col(i).norm() + error[i]; };
    return error[0] * cross(1, 2) + error[1] * cross(0, 2) + error[2] * cross(0, 1) + error[0] * error[1] * length(2) +
           error[0] * error[2] * length(1) + error[1] * error[2] * length(0) +
           16 * unit_roundoff * length(0) * length(1) * length(2);
  }

  /// At a point; its tangent is the vector of minors.
  Jet jet_at_point(const CrossingPoint& point) {
    Jet jet;
    jet.first = jets_[0].at(point.parameters[0], point.parameters[1]);
    jet.second = jets_[1].at(point.parameters[2], point.parameters[3]);
    for (long i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        jet.jacobian(i, static_cast<long>(k)) = jet.first.first[k][i];
        jet.jacobian(i, static_cast<long>(2 + k)) = -jet.second.first[k][i];
      }
    for (long k = 0; k < 4; ++k) {
      const double speed = jet.jacobian.col(k).norm();
      jet.unit[k] = speed > 0 ? 1 / speed : 0;
    }
    jet.jacobian = jet.jacobian * jet.unit.asDiagonal();
    for (std::size_t own = 0; own < 2; ++own) {
      // Around the point, and of roundings.
      const double u = point.parameters[2 * own];
      const double v = point.parameters[2 * own + 1];
      const double reach = point.radius + 0x1p-20;
      const auto bounds = jets_[own].bounds_on(u - reach, u + reach, v - reach, v + reach);
      const PatchJets::Value& at = own == 0 ? jet.first : jet.second;
      const std::array<double, 2> by{jet.unit[static_cast<long>(2 * own)], jet.unit[static_cast<long>(2 * own + 1)]};
      for (std::size_t k = 0; k < 2; ++k) {
        double bend = infinity;
        double steepness = infinity;
        if (bounds) {
          bend = (bounds->second[k] + bounds->second[k + 1]).head<3>().maxCoeff();
          steepness = 2 * static_cast<double>(jets_[own].degree(k)) + bounds->first[k][3];
        }
        constexpr double root_of_three = 1.7320509;
        jet.error[static_cast<long>(2 * own + k)] =
            1e-14 + root_of_three * 2 * by[k] * (bend * point.radius + steepness * at.error);
      }
    }
    for (int k = 0; k < 4; ++k) {
      Eigen::Matrix3d minor;
      Eigen::Vector3d error;
      for (int c = 0, at = 0; c < 4; ++c) {
        if (c == k) continue;
        error[at] = jet.error[c];
        minor.col(at++) = jet.jacobian.col(c);
      }
      jet.tangent[k] = (k % 2 == 0 ? 1 : -1) * minor.determinant();
      jet.tangent_error[k] = error_of_determinant(minor, error);
    }
    return jet;
  }

  /// How many arcs leave the point into both domains; nullopt where a direction is undecided.
  std::optional<unsigned> arcs_inside(const CrossingPoint& point) {
    const Jet jet = jet_at_point(point);
    enum class Way { inside, undecided, outside };
    // Along the tangent, and against it: outside of one border is outside.
    std::array<Way, 2> ways{Way::inside, Way::inside};
    for (std::size_t k = 0; k < 4; ++k) {
      if (point.side[k] == 0) continue;
      const double component = jet.tangent[static_cast<long>(k)];
      const bool decided = std::fabs(component) > jet.tangent_error[static_cast<long>(k)];
      const bool inward = component * point.side[k] < 0;
      for (std::size_t i = 0; i < 2; ++i)
        ways[i] = std::max(ways[i], !decided ? Way::undecided : inward == (i == 0) ? Way::inside : Way::outside);
    }
    if (ways[0] == Way::undecided || ways[1] == Way::undecided) return std::nullopt;
    return static_cast<unsigned>(std::count(ways.begin(), ways.end(), Way::inside));
  }

  /// The second derivative of the parameter along the intersection, where that touches the border of the axis.
  std::optional<double> bend_across(const CrossingPoint& point, std::size_t axis) {
    const Jet jet = jet_at_point(point);
    if (!(jet.tangent.cwiseAbs().maxCoeff() > 1e3 * jet.tangent_error.maxCoeff())) return std::nullopt;
    const Eigen::Vector4d direction = jet.tangent.normalized();
    const Eigen::Matrix3d gram = jet.jacobian * jet.jacobian.transpose();
    const Eigen::Vector4d bend = -(jet.jacobian.transpose() * (gram.inverse() * jet.bend(direction)));
    const double result = bend[static_cast<long>(axis)];
    if (!(std::fabs(result) > 1e-7 * bend.cwiseAbs().maxCoeff())) return std::nullopt;
    return result;
  }

  /// A point on several borders is found on each of them.
  void add(const BorderPoint& point) {
    const auto same = [&](const BorderPoint& other) {
      if (other.side != point.side) return false;
      for (std::size_t k = 0; k < 4; ++k)
        if (std::fabs(other.parameters[k] - point.parameters[k]) > 2 * (other.radius + point.radius) + 0x1p-40)
          return false;
      return true;
    };
    const auto known = std::find_if(result_.points.begin(), result_.points.end(), same);
    if (known == result_.points.end())
      result_.points.push_back(point);
    else
      known->touching = known->touching || point.touching;
  }

  std::array<const ControlNet*, 2> nets_;
  std::array<const ExactNet*, 2> exact_;
  std::array<PatchJets, 2> jets_;
  const BorderMeetings& meetings_;
  const FindContainedParts& contained_parts_;
  const Context& context_;
  ContactCurves* curves_;
  std::vector<std::pair<CrossingPoint, OpenBorder>> undecided_;
  std::vector<std::pair<CrossingPoint, TouchedBorder>> touched_;
  BorderPoints result_;
};

}  // namespace

BorderPoints patch_border_points(const ControlNet& first, const ControlNet& second, const ExactNet& exact_first,
                                 const ExactNet& exact_second, const BorderMeetings& meetings,
                                 const FindContainedParts& contained_parts, const Context& context,
                                 ContactCurves* curves) {
  return BorderSearch(first, second, exact_first, exact_second, meetings, contained_parts, context, curves).run();
}

}  // namespace eliminant::bridge
