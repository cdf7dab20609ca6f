// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/bridge/branches/section_tracing.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/intersect/sections/section_factors.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>

namespace eliminant::intersect {

/// A patch in doubles, its parameters in [0, 1] and its points moved to the origin, and the way back.
class SectionFrame {
 public:
  /// `net` are the Bernstein coefficients of the patch, the weights positive where they have one sign.
  SectionFrame(const symbolic::SurfacePiece& patch, PreparedNet net);

  const PreparedNet& net() const { return net_; }
  bool weight_has_one_sign() const { return weight_has_one_sign_; }
  /// False when a number is out of the range in which doubles are safe; nothing below may be used then.
  bool round();

  /// With positive weight where that of the patch has this sign; a weight of one sign has been made positive.
  const bridge::ControlNet& net_for(int weight_sign) const {
    return nets_[weight_sign < 0 && !weight_has_one_sign_ ? 1 : 0];
  }
  bridge::PatchJets::Value jets_at(const std::array<double, 2>& local, int weight_sign) const {
    return bridge::PatchJets(net_for(weight_sign)).at(local[0], local[1]);
  }

  double to_domain(std::size_t k, double local) const;
  std::array<double, 2> to_local(const std::array<double, 2>& parameters) const;
  /// A length in the parameters, in those of the frame.
  double to_local_length(double length) const;
  /// A vertex, with a bound of its error; `side` says on which borders it is.
  bridge::SectionGoal place_of(const TopologyVertex& vertex, const std::array<int, 2>& side) const;
  /// In the coordinates of the problem; (s, t) are not a number.
  SurfacePoint placed(const std::array<double, 2>& local, const std::array<double, 3>& point) const;
  /// Where u and v are at their lower (0) or upper (1) bound; not a number where it is at infinity.
  SurfacePoint corner(std::size_t u, std::size_t v) const;

 private:
  std::array<symbolic::Interval, 2> domain_;
  PreparedNet net_;
  bool weight_has_one_sign_;
  std::array<symbolic::Rational, 3> origin_;
  /// With the weight as it is, and with the other sign.
  std::array<bridge::ControlNet, 2> nets_;
};

}  // namespace eliminant::intersect
