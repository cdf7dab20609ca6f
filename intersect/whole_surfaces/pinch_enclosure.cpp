// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/pinch_enclosure.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <eliminant/bridge/certificates/krawczyk_system.hpp>
#include <eliminant/bridge/enclosures/ball_curve.hpp>
#include <eliminant/bridge/enclosures/ball_matrix.hpp>
#include <eliminant/intersect/whole_surfaces/projection_charts.hpp>

namespace eliminant::intersect {

namespace {

using bridge::BallCurve;
using bridge::BallJet;
using bridge::ComplexBall;
using bridge::PlaneBall;
using symbolic::Polynomial;

constexpr long precision = 160;

/// Derivatives of the coordinates Phi_i / Phi_k, i != k, times Phi_k^2: along the parameter of the unknown slope, and
/// along the other one.
struct Derivatives {
  std::vector<BallCurve> fixed;
  std::vector<BallCurve> sloped;
};

Derivatives derivatives(const std::vector<Polynomial>& phi, std::size_t pivot, std::size_t sloped) {
  Derivatives result;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i == pivot) continue;
    for (const std::size_t by : {std::size_t{0}, std::size_t{1}}) {
      const Polynomial p = phi[i].derivative(by) * phi[pivot] - phi[i] * phi[pivot].derivative(by);
      (by == sloped ? result.sloped : result.fixed).emplace_back(p);
    }
  }
  return result;
}

/// fixed + m sloped = 0 in (u, v, m).
bridge::System system_of(const Derivatives& parts) {
  return [&parts](const std::vector<ComplexBall>& at, long bits) {
    const PlaneBall point{at[0], at[1]};
    bridge::SystemValue value;
    for (std::size_t i = 0; i < 3; ++i) {
      BallJet jet = parts.fixed[i].jet(point, bits);
      const BallJet slope = parts.sloped[i].jet(point, bits);
      acb_addmul(jet.value.get(), at[2].get(), slope.value.get(), bits);
      acb_addmul(jet.dx.get(), at[2].get(), slope.dx.get(), bits);
      acb_addmul(jet.dy.get(), at[2].get(), slope.dy.get(), bits);
      value.values.push_back(std::move(jet.value));
      value.jacobian.push_back({std::move(jet.dx), std::move(jet.dy), slope.value});
    }
    return value;
  };
}

ComplexBall ball_of(const DoubleInterval& interval) {
  ComplexBall result(middle(interval), 0.0);
  bridge::Magnitude radius;
  mag_set_d(radius.get(), width(interval));
  arb_add_error_mag(result.real(), radius.get());
  return result;
}

/// Whether the system has one zero at most on a convex box: its Jacobian is near one regular matrix there.
bool is_injective(const bridge::System& system, const std::vector<ComplexBall>& box) {
  bridge::BallMatrix jacobian(system(box, precision).jacobian);
  bridge::BallMatrix inverse(system(box, precision).jacobian);
  inverse.drop_radii();
  if (acb_mat_approx_inv(inverse.get(), inverse.get(), precision) == 0) return false;
  inverse.drop_radii();
  acb_mat_mul(jacobian.get(), inverse.get(), jacobian.get(), precision);
  for (std::size_t i = 0; i < box.size(); ++i) {
    acb_sub_ui(jacobian.entry(i, i), jacobian.entry(i, i), 1, precision);
    double row = 0;
    for (std::size_t j = 0; j < box.size(); ++j) {
      bridge::Magnitude entry;
      acb_get_mag(entry.get(), jacobian.entry(i, j));
      row += mag_get_d(entry.get());
    }
    if (!(row < 0.99)) return false;
  }
  return true;
}

}  // namespace

std::optional<std::array<DoubleInterval, 2>> enclose_pinch_point(const symbolic::RationalSurface& surface,
                                                                 const std::array<bool, 2>& inverted,
                                                                 const std::array<DoubleInterval, 2>& within) {
  // Of parameters that are known exactly, too, the enclosure of the point has to lie in the rectangle.
  std::array<DoubleInterval, 2> rectangle = within;
  const double widest = std::max(width(within[0]), width(within[1]));
  for (DoubleInterval& side : rectangle) {
    const double room = 0.25 * widest + 1e-12 * (1 + side.magnitude());
    side = side + DoubleInterval(-room, room);
  }
  const std::vector<Polynomial> phi =
      change_parameters(surface, {chart(inverted[0]), chart(inverted[1])}).coordinates();
  const SurfaceJet jet = SurfaceCharts(surface).jet(inverted, rectangle);
  for (std::size_t pivot = 0; pivot < 4; ++pivot) {
    if (!jet.value[pivot].excludes_zero()) continue;
    for (const std::size_t sloped : {std::size_t{0}, std::size_t{1}}) {
      // The slope, from a derivative along its parameter that is not 0.
      for (std::size_t i = 0; i < 4; ++i) {
        const auto along = [&](std::size_t by) {
          return jet.derivative[by][i] * jet.value[pivot] - jet.value[i] * jet.derivative[by][pivot];
        };
        if (i == pivot || !along(sloped).excludes_zero()) continue;
        const DoubleInterval slope = DoubleInterval(0) - along(1 - sloped) / along(sloped);
        if (!(slope.magnitude() < 4)) continue;
        const Derivatives parts = derivatives(phi, pivot, sloped);
        const bridge::System system = system_of(parts);
        const std::vector<ComplexBall> box{ball_of(rectangle[0]), ball_of(rectangle[1]), ball_of(slope)};
        if (!is_injective(system, box)) continue;
        const auto zero = bridge::enclose_system_zero(system, box, precision);
        if (!zero) continue;
        const std::array<DoubleInterval, 2> found{enclose(bridge::RealBall((*zero)[0].real())),
                                                  enclose(bridge::RealBall((*zero)[1].real()))};
        if (!contains(rectangle[0], found[0]) || !contains(rectangle[1], found[1])) continue;
        return found;
      }
    }
  }
  return std::nullopt;
}

}  // namespace eliminant::intersect
