// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/contacts/corank_one_branches.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// A point where two patches touch, proven by exact substitution.
struct SurfaceContact {
  /// u, v, s, t: as they are where they are rational with small denominators or bounds of the domain, else within
  /// 2^-150.
  std::array<symbolic::Rational, 4> parameters;
  std::array<double, 4> rounded{};
  /// Where the Hessian has rank one: both patches around it.
  std::shared_ptr<const CorankOnePatches> corank_one{};

  /// -1 or 1 where the parameter is the lower or the upper bound of its domain, exactly, else 0.
  int side(std::size_t axis) const {
    const symbolic::Rational& at = parameters[axis];
    return at.is_zero() ? -1 : at == symbolic::Rational(1) ? 1 : 0;
  }
  bool is_on_border() const { return side(0) != 0 || side(1) != 0 || side(2) != 0 || side(3) != 0; }
};

/// What the patches have in common in a box around a contact, proven.
struct ContactNeighbourhood {
  /// Two smooth arcs that cross.
  bool crossing = false;
  /// The half-branches of a degenerate contact. Without these and without a crossing the contact is the only common
  /// point.
  std::optional<CorankOneBranches> degenerate;
  /// Of a crossing: of the tangents of the arcs, in (u, v): the columns p and q.
  std::array<std::array<double, 2>, 2> directions{};
  /// An arc along p (q) stays within that slope of its tangent, in units of the directions.
  double slope = 0;
  /// Bounds the distance in space of an arc from its chord from the contact to another point of it in the box.
  double chord_error = 0;

  std::size_t half_branches() const { return crossing ? 4 : degenerate ? degenerate->half_branches() : 0; }

  /// On which of the half-arcs a point of an arc lies, by the parameters (u, v) relative to the contact, known up to
  /// the radius: 0 to 3, of a crossing p, -p, q, -q; nullopt where it is too near to call.
  std::optional<std::size_t> half_arc(double u, double v, double radius = 0) const;
};

/// Recognises contacts of two tensor-product patches at rational and algebraic parameters, and proves what is around
/// them.
///
/// Newton's method on the conditions that the normals are parallel and the difference is orthogonal to the second patch
/// finds a contact in doubles, continued fractions its parameters, exact substitution proves it; where they are no
/// simple fractions, algebraic_contact does. With (s, t) as the function of (u, v) that keeps the coordinates along the
/// tangent plane equal, the rest of the difference has a critical zero; where its Hessian is definite on a whole box
/// there is no other zero, where it is indefinite with asymptotic directions that hardly turn there are two arcs that
/// cross (Morse's lemma with bounds). Contacts with a Hessian of rank one, at rational parameters, are those of
/// CorankOneContact.
class SurfaceContactProver {
 public:
  /// All must outlive the object.
  SurfaceContactProver(const ControlNet& first, const ControlNet& second, const ExactNet& exact_first,
                       const ExactNet& exact_second)
      : first_(first), second_(second), exact_first_(exact_first), exact_second_(exact_second) {}

  /// A contact in both closed domains in or near the box, proven; nullopt where none is found.
  std::optional<SurfaceContact> find(const CellBox& box) const;

  /// For a box that holds the contact, perhaps on its border; nullopt where it is too large, or nothing is known of a
  /// degenerate contact.
  std::optional<ContactNeighbourhood> neighbourhood(const SurfaceContact& contact, const CellBox& box) const;

  /// A large box around a degenerate contact, within the domains, in which its half-branches are known to be all.
  struct Surroundings {
    CellBox box;
    ContactNeighbourhood neighbourhood;
  };
  std::optional<Surroundings> surroundings(const SurfaceContact& contact) const;

 private:
  std::optional<SurfaceContact> find_simple(const CellBox& box) const;
  std::optional<SurfaceContact> find_degenerate(const CellBox& box) const;
  void classify(SurfaceContact& contact) const;
  bool is_contact(const std::array<symbolic::Rational, 4>& parameters) const;

  const ControlNet& first_;
  const ControlNet& second_;
  const ExactNet& exact_first_;
  const ExactNet& exact_second_;
};

}  // namespace eliminant::bridge
