// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/surface_contact.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <eliminant/bridge/contacts/algebraic_contact.hpp>
#include <eliminant/bridge/contacts/contact_conditions.hpp>
#include <eliminant/bridge/contacts/tangential_elimination.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/bridge/rounding/simple_fraction.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::Vector4d;
using symbolic::Rational;

constexpr std::size_t weight = 3;

double middle(const DoubleInterval& x) { return 0.5 * (x.lower + x.upper); }

/// True when it is decided that the parameter, known to 2^-150 unless it is 0 or 1 itself, is in [0, 1].
bool is_in_domain(const Rational& parameter) {
  if (parameter.is_zero() || (parameter - Rational(1)).is_zero()) return true;
  const Rational least = exactly(0x1p-140);
  return least < parameter && parameter < Rational(1) - least;
}

/// The directions in which the form vanishes, of an indefinite one.
std::array<std::array<double, 2>, 2> asymptotic_directions(double uu, double uv, double vv) {
  const double root = std::sqrt(std::max(0.0, uv * uv - uu * vv));
  std::array<std::array<double, 2>, 2> result;
  if (std::fabs(uu) >= std::fabs(vv)) {
    // uu x^2 + 2 uv x + vv = 0 with y = 1; the root without cancellation first.
    const double sum = -(uv + (uv < 0 ? -root : root));
    result = {{{sum, uu}, {vv, sum}}};
  } else {
    const double sum = -(uv + (uv < 0 ? -root : root));
    result = {{{vv, sum}, {sum, uu}}};
  }
  for (auto& direction : result) {
    const double length = std::hypot(direction[0], direction[1]);
    direction = {direction[0] / length, direction[1] / length};
  }
  return result;
}

}  // namespace

std::optional<std::size_t> ContactNeighbourhood::half_arc(double u, double v, double radius) const {
  if (degenerate) return degenerate->half_branch(u, v, radius);
  const auto& [p, q] = directions;
  const double determinant = p[0] * q[1] - p[1] * q[0];
  const double along_p = (u * q[1] - v * q[0]) / determinant;
  const double along_q = (p[0] * v - p[1] * u) / determinant;
  const double larger = std::max(std::fabs(along_p), std::fabs(along_q));
  const double smaller = std::min(std::fabs(along_p), std::fabs(along_q));
  if (!(smaller < 0.9 * larger)) return std::nullopt;
  if (std::fabs(along_p) > std::fabs(along_q)) return along_p > 0 ? 0 : 1;
  return along_q > 0 ? 2 : 3;
}

std::optional<SurfaceContact> SurfaceContactProver::find(const CellBox& box) const {
  auto contact = find_simple(box);
  return contact ? contact : find_degenerate(box);
}

std::optional<SurfaceContact> SurfaceContactProver::find_simple(const CellBox& box) const {
  PatchJets first(first_);
  PatchJets second(second_);
  Vector4d x;
  double reach = 0;
  for (long k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(k);
    x[k] = 0.5 * (box.lower[i] + box.upper[i]);
    reach = std::max(reach, box.upper[i] - box.lower[i]);
  }
  double last_step = INFINITY;
  bool singular = false;
  constexpr int most_steps = 15;
  for (int step = 0; step < most_steps; ++step) {
    for (long k = 0; k < 4; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (!(x[k] > box.lower[i] - reach) || !(x[k] < box.upper[i] + reach)) return std::nullopt;
    }
    const ContactConditions conditions = contact_conditions(first, second, x);
    const Eigen::PartialPivLU<Eigen::Matrix4d> factors(conditions.jacobian);
    const Vector4d change = factors.solve(conditions.value);
    constexpr double least_condition = 1e-6;
    singular = !(factors.rcond() > least_condition);
    if (!change.allFinite()) return std::nullopt;
    x -= change;
    last_step = change.lpNorm<Eigen::Infinity>();
    if (last_step < 1e-13) break;
  }
  constexpr double at_rest = 1e-8;
  if (!(last_step < at_rest)) return std::nullopt;
  SurfaceContact contact;
  bool simple = true;
  for (std::size_t k = 0; k < 4 && simple; ++k) {
    const double at = x[static_cast<long>(k)];
    constexpr double beyond = 1e-9;
    if (!(x.minCoeff() > -beyond) || !(x.maxCoeff() < 1 + beyond)) return std::nullopt;
    // Parts of domains have large denominators.
    constexpr double accuracy = 1e-12;
    constexpr double largest_denominator = 0x1p18;
    const auto fraction = simple_fraction(at, accuracy, largest_denominator);
    simple = fraction.has_value();
    if (simple) contact.parameters[k] = *fraction;
  }
  if (!simple || !is_contact(contact.parameters)) {
    const auto algebraic = algebraic_contact(first_, second_, exact_first_, exact_second_, {x[0], x[1], x[2], x[3]});
    if (!algebraic) return std::nullopt;
    contact.parameters = *algebraic;
  }
  if (!std::all_of(contact.parameters.begin(), contact.parameters.end(), is_in_domain)) return std::nullopt;
  for (std::size_t k = 0; k < 4; ++k) contact.rounded[k] = nearest(contact.parameters[k]);
  if (singular && simple) classify(contact);
  return contact;
}

std::optional<SurfaceContact> SurfaceContactProver::find_degenerate(const CellBox& box) const {
  for (const std::array<double, 4>& near : corank_one_contacts_near(first_, second_, box)) {
    SurfaceContact contact;
    bool simple = true;
    for (std::size_t k = 0; k < 4 && simple; ++k) {
      constexpr double accuracy = 1e-11;
      constexpr double largest_denominator = 0x1p16;
      const auto fraction = simple_fraction(near[k], accuracy, largest_denominator);
      simple = fraction.has_value();
      if (simple) contact.parameters[k] = *fraction;
    }
    if (!simple || !is_contact(contact.parameters)) continue;
    for (std::size_t k = 0; k < 4; ++k) contact.rounded[k] = nearest(contact.parameters[k]);
    classify(contact);
    if (contact.corank_one != nullptr) return contact;
  }
  return std::nullopt;
}

void SurfaceContactProver::classify(SurfaceContact& contact) const {
  auto kind = corank_one_contact(exact_first_, exact_second_, contact.parameters);
  if (!kind) return;
  auto patches =
      CorankOnePatches::around(first_, second_, exact_first_, exact_second_, contact.parameters, *std::move(kind));
  if (patches) contact.corank_one = std::make_shared<const CorankOnePatches>(*std::move(patches));
}

bool SurfaceContactProver::is_contact(const std::array<Rational, 4>& parameters) const {
  const TaylorTable<Rational> a = taylor_at(exact_first_, {parameters[0], parameters[1]}, 1);
  const TaylorTable<Rational> b = taylor_at(exact_second_, {parameters[2], parameters[3]}, 1);
  using Row = std::array<Rational, 4>;
  const Row& p = a.at(0, 0);
  const Row& q = b.at(0, 0);
  if (p[weight].is_zero() || q[weight].is_zero()) return false;
  for (std::size_t k = 0; k < weight; ++k)
    if (!(p[k] * q[weight] - q[k] * p[weight]).is_zero()) return false;
  // The tangent planes are equal: every tangent vector is orthogonal to the normal of the second.
  const auto tangent = [](const Row& value, const Row& slope) {
    std::array<Rational, 3> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = slope[k] * value[weight] - value[k] * slope[weight];
    return result;
  };
  const auto s = tangent(q, b.at(1, 0));
  const auto t = tangent(q, b.at(0, 1));
  const std::array<Rational, 3> normal{s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
  for (const auto& along : {tangent(p, a.at(1, 0)), tangent(p, a.at(0, 1))})
    if (!(along[0] * normal[0] + along[1] * normal[1] + along[2] * normal[2]).is_zero()) return false;
  return !(normal[0].is_zero() && normal[1].is_zero() && normal[2].is_zero());
}

std::optional<ContactNeighbourhood> SurfaceContactProver::neighbourhood(const SurfaceContact& contact,
                                                                        const CellBox& box) const {
  if (contact.corank_one != nullptr) {
    ContactNeighbourhood result;
    result.degenerate = contact.corank_one->in_box(first_, box);
    return result.degenerate ? std::optional(std::move(result)) : std::nullopt;
  }
  const auto elimination = TangentialElimination::on(first_, second_, contact.rounded, box);
  if (!elimination) return std::nullopt;
  const Hessian& hessian = elimination->hessian;
  ContactNeighbourhood result;
  if (hessian.determinant().lower > 0) return result;

  result.crossing = true;
  result.directions = asymptotic_directions(middle(hessian.uu), middle(hessian.uv), middle(hessian.vv));
  const auto& [p, q] = result.directions;
  if (!(std::fabs(p[0] * q[1] - p[1] * q[0]) > 1e-3)) return std::nullopt;
  const DoubleInterval mixed = hessian.form(p, q);
  if (!mixed.excludes_zero()) return std::nullopt;
  const double least = std::min(std::fabs(mixed.lower), std::fabs(mixed.upper));
  const double turning = std::max(hessian.form(p, p).magnitude(), hessian.form(q, q).magnitude());
  // Then the form has opposite signs on the diagonals between the directions, and its derivative across a direction has
  // one sign between them: on each side of the contact there is one arc.
  if (!(turning < 0.4 * least)) return std::nullopt;
  result.slope = 0.63 * turning / least;
  double reach = 0;
  for (std::size_t k = 0; k < 2; ++k)
    reach = std::max({reach, box.upper[k] - contact.rounded[k], contact.rounded[k] - box.lower[k]});
  // Lengths along the directions of a point whose coordinates are at most `reach`.
  const double length = 2 * reach / std::fabs(p[0] * q[1] - p[1] * q[0]);
  const auto bounds = PatchJets(first_).bounds_on(box.lower[0], box.upper[0], box.lower[1], box.upper[1]);
  if (!bounds) return std::nullopt;
  double error = 0;
  for (long c = 0; c < 3; ++c) {
    const double speed = bounds->first[0][c] + bounds->first[1][c];
    const double bend = bounds->second[0][c] + 2 * bounds->second[1][c] + bounds->second[2][c];
    error = std::max(error, speed * 2 * result.slope * length + 0.125 * bend * 2 * length * length);
  }
  result.chord_error = 1.74 * error;
  return result;
}

std::optional<SurfaceContactProver::Surroundings> SurfaceContactProver::surroundings(
    const SurfaceContact& contact) const {
  if (contact.corank_one == nullptr) return std::nullopt;
  constexpr double largest = 0x1p-2;
  constexpr double smallest = 0x1p-14;
  constexpr double smaller = 0.75;
  for (double half = largest; half > smallest; half *= smaller) {
    CellBox box;
    for (std::size_t k = 0; k < 4; ++k) {
      box.lower[k] = std::max(contact.rounded[k] - half, 0.0);
      box.upper[k] = std::min(contact.rounded[k] + half, 1.0);
    }
    if (auto around = neighbourhood(contact, box)) return Surroundings{box, *std::move(around)};
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
