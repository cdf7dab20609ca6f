// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curve_surface/patch_boxes.hpp>
#include <eliminant/intersect/curve_surface/surface_pencil.hpp>
#include <eliminant/intersect/curve_surface/surface_preimages.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>

namespace eliminant::intersect {

/// A representation and what reads parameters from its kernels.
struct Inversion {
  /// With row monomials of at least this degree in each group of parameters: of a bilinear surface and of a plane the
  /// smallest representation does not tell both parameters (1), and k parameters of one point are only told apart in
  /// degree k, whatever their position.
  Inversion(const symbolic::RationalSurface& surface, long least);
  Inversion(const Inversion&) = delete;
  Inversion& operator=(const Inversion&) = delete;

  symbolic::MatrixRepresentation matrix;
  SurfaceInversion inversion;
};

/// One piece of a surface, prepared for any number of curves: each engine's part when it is first asked.
///
/// A map of low total degree written as a tensor product has a base point at infinity in both parameters that is no
/// local complete intersection; over the projective plane it often has none. The matrix engines then work there.
class PreparedSurface {
 public:
  PreparedSurface(const symbolic::SurfacePiece& surface_piece, std::uint64_t seed, const Context& context)
      : piece(surface_piece), seed_(seed), context_(context), boxes_(surface_piece) {}

  const PatchBoxes& boxes() const { return boxes_; }
  /// The map that the matrix engines use, and what belongs to it.
  const symbolic::RationalSurface& map() {
    settle();
    return over_the_plane_ ? *over_the_plane_ : piece.map;
  }
  bool is_over_the_plane() {
    settle();
    return over_the_plane_.has_value();
  }
  const bridge::BallSurface& ball_surface() { return inversion_for(1).surface(); }
  const symbolic::MatrixRepresentation& matrix() {
    settle();
    return smallest_->matrix;
  }
  /// For points with that many parameters.
  const SurfaceInversion& inversion_for(long parameters) {
    settle();
    if (parameters <= 1) return smallest_->inversion;
    auto& larger = larger_[parameters];
    if (!larger) larger = std::make_unique<Inversion>(map(), parameters);
    return larger->inversion;
  }
  const SurfacePencil& pencil() {
    if (!pencil_) pencil_ = std::make_unique<SurfacePencil>(map(), matrix(), inversion_for(1));
    return *pencil_;
  }
  const symbolic::ImplicitDegree& degree() {
    settle();
    return degree_;
  }

  /// The implicit equation in (x, y, z, w), where the degree of the map or planes of base points have to be told apart
  /// from the surface, and it is within reach.
  const std::optional<symbolic::Polynomial>& equation() {
    settle();
    return equation_;
  }

  const symbolic::SurfacePiece& piece;

 private:
  void settle();
  void choose_map();

  std::uint64_t seed_;
  const Context& context_;
  PatchBoxes boxes_;
  std::optional<symbolic::RationalSurface> over_the_plane_;
  std::unique_ptr<Inversion> smallest_;
  std::unique_ptr<SurfacePencil> pencil_;
  std::map<long, std::unique_ptr<Inversion>> larger_;
  symbolic::ImplicitDegree degree_;
  std::optional<symbolic::Polynomial> equation_;
};

}  // namespace eliminant::intersect
