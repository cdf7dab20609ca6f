// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/patch_section.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/contacts/contact_curve.hpp>
#include <eliminant/bridge/nets/function_net.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/only_common_point.hpp>
#include <eliminant/intersect/sections/section_factors.hpp>
#include <eliminant/symbolic/elimination/rational_inversion.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::RationalInversion;

bool has_no_zero(const Polynomial& p) {
  const symbolic::Interval unit{0, 1};
  return !p.is_zero() && bridge::excludes_zero(bridge::function_net(p, {unit, unit}), {0, 0}, {1, 1});
}

/// The curve on one of both patches, the base.
class Section {
 public:
  Section(const bridge::PatchPairNets& nets, bool swapped)
      : swapped_(swapped),
        base_(swapped ? PatchNets{nets.exact_second, nets.second} : PatchNets{nets.exact_first, nets.first}),
        other_(swapped ? PatchNets{nets.exact_first, nets.first} : PatchNets{nets.exact_second, nets.second}),
        map_(patch_of(base_.exact).map) {}

  std::optional<PatchSection> run(double tolerance, double size, const Context& context) && {
    if (!prepare()) return std::nullopt;
    const Options options;
    const SectionFactor* curve = nullptr;
    const std::vector<SectionFactor> factors = section_factors(map_, section_, options.seed);
    for (const SectionFactor& factor : factors) {
      if (factor.kind == SectionFactorKind::at_infinity || has_no_zero(factor.factor)) continue;
      if (factor.kind == SectionFactorKind::point) {
        if (!add_border_of(factor.factor)) return std::nullopt;
        continue;
      }
      // Two curves might cross.
      if (curve != nullptr) return std::nullopt;
      curve = &factor;
    }
    if (curve != nullptr && !add_arcs(*curve, tolerance, size, context)) return std::nullopt;
    for (const auto& [axis, side] : collapsed_) add_point(axis, side);
    return std::move(result_);
  }

 private:
  /// The function on the base, and the parameters of the other patch as quotients in its parameters.
  bool prepare() {
    const symbolic::RationalSurface other = patch_of(other_.exact).map;
    // Of larger ones no equation of low degree is to be expected.
    constexpr long most = 4;
    if (2 * other.bidegree()[0] * other.bidegree()[1] > most) return false;
    const auto inversion = symbolic::rational_inversion(other);
    if (!inversion || !inversion->is_inverse_everywhere()) return false;
    section_ = inversion->equation.compose(map_.coordinates());
    if (section_.is_zero()) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& quotients = inversion->parameters[k];
      const auto usable = std::find_if(quotients.begin(), quotients.end(), [&](const auto& quotient) {
        return has_no_zero(quotient.denominator.compose(map_.coordinates()));
      });
      if (usable == quotients.end()) return false;
      relation_.numerator[k] = usable->numerator.compose(map_.coordinates());
      relation_.denominator[k] = usable->denominator.compose(map_.coordinates());
    }
    return true;
  }

  /// Of a factor that is constant along it: only a border that is one point is understood.
  bool add_border_of(const Polynomial& factor) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (const int side : {-1, 1}) {
        const Polynomial line = Polynomial::variable(2, axis) - Polynomial::constant(2, side < 0 ? 0 : 1);
        if (!(factor.primitive_part() == line.primitive_part()) || !is_one_point(base_.exact, axis, side)) continue;
        collapsed_.emplace_back(axis, side);
        return true;
      }
    return false;
  }

  bool add_arcs(const SectionFactor& curve, double tolerance, double size, const Context& context) {
    relation_.curve = curve.factor;
    const bridge::ContactCurve along(base_.rounded, other_.rounded, base_.exact, other_.exact, relation_, swapped_);
    ContactArcs found = contact_arcs(along, base_, {}, tolerance, size, context);
    const auto is_proven = [](const ContactArc& arc) { return arc.proven; };
    if (!found.complete || !std::all_of(found.arcs.begin(), found.arcs.end(), is_proven)) return false;
    result_.tangential = curve.multiplicity > 1;
    result_.arcs = std::move(found.arcs);
    return true;
  }

  /// A border that is one point, unless it is not in the other patch, or arcs end there.
  void add_point(std::size_t axis, int side) {
    const std::size_t of_base = swapped_ ? 2 : 0;
    const auto ends_there = [&](const ContactArc& arc) {
      return !arc.closed && (arc.start.side[of_base + axis] == side || arc.end.side[of_base + axis] == side);
    };
    if (std::any_of(result_.arcs.begin(), result_.arcs.end(), ends_there)) return;
    std::vector<Rational> at{Rational(), Rational()};
    at[axis] = Rational(side < 0 ? 0 : 1);
    PatchSection::Point point;
    point.parameters[of_base + axis] = side < 0 ? 0 : 1;
    point.parameters[of_base + 1 - axis] = std::nan("");
    point.side[of_base + axis] = side;
    const std::array<Polynomial, 2> place{Polynomial::constant(2, at[0]), Polynomial::constant(2, at[1])};
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational value = relation_.numerator[k].compose(place).constant_term() /
                             relation_.denominator[k].compose(place).constant_term();
      if (value.sign() < 0 || Rational(1) < value) return;
      point.parameters[2 - of_base + k] = bridge::nearest(value);
      point.side[2 - of_base + k] = value.is_zero() ? -1 : value == Rational(1) ? 1 : 0;
    }
    result_.points.push_back(point);
  }

  bool swapped_;
  PatchNets base_;
  PatchNets other_;
  symbolic::RationalSurface map_;
  Polynomial section_{2};
  symbolic::ContactRelation relation_;
  /// Axis and side of borders of the base that are one point, which is on the other surface.
  std::vector<std::pair<std::size_t, int>> collapsed_;
  PatchSection result_;
};

}  // namespace

std::optional<PatchSection> patch_section(const bridge::PatchPairNets& nets, double tolerance, double size,
                                          const Context& context) {
  for (const bool swapped : {false, true})
    if (auto section = Section(nets, swapped).run(tolerance, size, context)) return section;
  return std::nullopt;
}

}  // namespace eliminant::intersect
