// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/injectivity.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/intersect/whole_surfaces/projective_charts.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// A bounded surface as one map of its plane of parameters, smooth on rectangles of a grid: where it is injective, also
/// across their sides. Of a triangle its map on the square around it. A surface that closes (its first and last border
/// in a parameter are the same, point by point) goes on periodically.
class SurfaceAtlas {
 public:
  /// `charts` are the parts of a surface of several pieces, or of a triangle, and must outlive the object.
  SurfaceAtlas(const symbolic::ParametricSurface& surface, const std::vector<ProjectiveChart>& charts);

  /// False where a coordinate is out of the range in which doubles are safe; nothing below may be used then.
  bool is_rounded() const { return rounded_; }
  /// False where pieces that are neighbours do not have the same points on the side between them.
  bool is_continuous() const { return continuous_; }
  /// In u and v: the length of the domain of a surface that closes.
  const std::array<std::optional<double>, 2>& periods() const { return periods_; }

  /// Whether both rectangles touch a line of the grid on which a side of a piece is a single point, a pole.
  bool meet_at_pole(const bridge::ParameterRectangle& a, const bridge::ParameterRectangle& b) const;

  /// Whether different parameters there are proven to have different points. Rectangles may reach beyond the domain
  /// where the surface closes.
  bool is_injective_on(const bridge::ParameterRectangle& rectangle) const;

 private:
  struct Piece {
    bridge::ControlNet net;
    std::array<double, 2> lower{};
    std::array<double, 2> upper{};
  };

  void add(const std::vector<symbolic::SurfacePiece>& pieces);
  void close(const std::vector<symbolic::SurfacePiece>& pieces);

  /// Where parameter `axis` has this value.
  struct Pole {
    std::size_t axis = 0;
    double at = 0;
  };

  std::vector<Piece> pieces_;
  std::vector<Pole> poles_;
  std::array<std::optional<double>, 2> periods_;
  bool rounded_ = true;
  bool continuous_ = true;
};

}  // namespace eliminant::intersect
