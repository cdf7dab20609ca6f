// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/contained_curve.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/plane_curves/parameter_roots.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::CurvePiece;
using symbolic::ParameterForm;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// A rational number between two roots.
Rational between(ParameterRoots& roots, std::size_t lower, std::size_t upper) {
  for (long bits = 32;; bits *= 2) {
    roots.refine(lower, bits);
    roots.refine(upper, bits);
    bridge::RealBall sum;
    arb_add(sum.get(), roots.ball(lower).real(), roots.ball(upper).real(), ARF_PREC_EXACT);
    arb_mul_2exp_si(sum.get(), sum.get(), -1);
    Rational middle;
    arf_get_fmpq(middle.get(), arb_midref(sum.get()));
    if (roots.compare(lower, middle) < 0 && roots.compare(upper, middle) > 0) return middle;
  }
}

/// An integer above a root.
Rational beyond(ParameterRoots& roots, std::size_t last) {
  bridge::RealBall above;
  arb_get_ubound_arf(arb_midref(above.get()), roots.ball(last).real(), 64);
  symbolic::Integer whole;
  arf_get_fmpz(whole.get(), arb_midref(above.get()), ARF_RND_CEIL);
  return whole + symbolic::Integer(1);
}

class ContainedCurve {
 public:
  ContainedCurve(const CurvePiece& curve, PreparedSurface& surface, SurfaceBorders& borders,
                 const PatchTest& is_within_patch, const Options& options, const Context& context)
      : curve_(curve),
        surface_(surface),
        borders_(borders),
        is_within_patch_(is_within_patch),
        options_(options),
        context_(context) {}

  ContainedParts run() {
    cut();
    for (Overlap& overlap : overlaps_) overlap.certified = options_.certify && certified_;
    parts_.stretches = std::move(overlaps_);
    parts_.certified = certified_;
    return std::move(parts_);
  }

 private:
  void cut() {
    if (!surface_.piece.region) {
      overlaps_.push_back(whole_curve(curve_, options_));
      return;
    }
    parts_.crossings = crossings();
    ParameterRoots ends(parts_.crossings, Wanted::real, context_);
    std::vector<std::size_t> cuts;
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (!curve_.domain || (ends.compare(i, curve_.domain->lower) >= 0 && ends.compare(i, curve_.domain->upper) <= 0))
        cuts.push_back(i);
    if (cuts.empty()) {
      const Rational half(symbolic::Integer(1), symbolic::Integer(2));
      if (is_inside(curve_.domain ? (curve_.domain->lower + curve_.domain->upper) * half : Rational(0)))
        overlaps_.push_back(whole_curve(curve_, options_));
      return;
    }
    std::vector<bool> inside_after(cuts.size(), false);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) inside_after[k] = is_inside(between(ends, cuts[k], cuts[k + 1]));
    if (!curve_.domain) inside_after.back() = is_inside(beyond(ends, cuts.back()));
    for (std::size_t k = 0; k < cuts.size(); ++k)
      if (!inside_after[k] && !inside_after[k > 0 ? k - 1 : cuts.size() - 1]) parts_.isolated.push_back(cuts[k]);
    join(ends, cuts, inside_after);
  }

  /// The parameters at which the curve may enter or leave the patch, or its domain ends: a squarefree polynomial.
  UnivariatePolynomial crossings() {
    UnivariatePolynomial all({symbolic::Integer(1)});
    for (const auto& [group, value] : borders_of_region()) {
      const ParameterForm& condition = borders_.condition(group, value);
      if (!condition.finite.is_zero()) all = all * condition.finite;
    }
    if (curve_.domain)
      for (const Rational& end : {curve_.domain->lower, curve_.domain->upper})
        all = all * UnivariatePolynomial({-end.numerator(), end.denominator()});
    if (all.degree() < 1) return UnivariatePolynomial({symbolic::Integer(0), symbolic::Integer(1)});
    UnivariatePolynomial squarefree({symbolic::Integer(1)});
    for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(all))
      squarefree = squarefree * part.factor;
    return squarefree;
  }

  /// From cut to cut; what is inside on both sides of a cut is one stretch. What follows the last cut leads through
  /// infinity.
  void join(ParameterRoots& ends, const std::vector<std::size_t>& cuts, const std::vector<bool>& inside_after) {
    if (std::all_of(inside_after.begin(), inside_after.end(), [](bool inside) { return inside; })) {
      overlaps_.push_back(whole_curve(curve_, options_));
      return;
    }
    const bool through_infinity = inside_after.back();
    bool open = through_infinity;
    // Of a stretch through infinity the beginning lies behind its end.
    std::size_t last_stretch = cuts.size() - 1;
    while (through_infinity && inside_after[last_stretch - 1]) --last_stretch;
    std::size_t opened_at = cuts[last_stretch];
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      if (open && !inside_after[k]) {
        add_stretch(ends, opened_at, cuts[k]);
        open = false;
      }
      if (!open && inside_after[k]) {
        if (through_infinity && k == last_stretch) break;
        open = true;
        opened_at = cuts[k];
      }
    }
  }

  std::vector<std::pair<std::size_t, Rational>> borders_of_region() const {
    const symbolic::ParameterRegion& region = *surface_.piece.region;
    if (region.triangle) return {{0, Rational(0)}, {1, Rational(0)}, {2, Rational(0)}};
    return {
        {0, region.sides[0].lower}, {0, region.sides[0].upper}, {1, region.sides[1].lower}, {1, region.sides[1].upper}};
  }

  /// Whether the point of a rational parameter, which is on no border, lies in the patch.
  bool is_inside(const Rational& t) {
    PointOnCurve point;
    point.exact_t = t;
    point.real = true;
    for (point.precision_bits = 128;; point.precision_bits *= 2) {
      context_.checkpoint("cutting a curve in the surface");
      point.coordinates.clear();
      for (const Rational& coordinate : curve_.map.at(t)) {
        ComplexBall& ball = point.coordinates.emplace_back();
        arb_set_fmpq(ball.real(), coordinate.get(), point.precision_bits);
      }
      const bool patient = point.precision_bits < largest_preimage_precision && surface_.degree().map_degree == 1;
      const long most = patient ? 1 : surface_.matrix().rows();
      auto found = surface_.inversion_for(1).preimages(point.coordinates, most, surface_.degree().map_degree,
                                                       point.precision_bits);
      if (!found) continue;
      if (found->kernel_dimension > 1) {
        found = surface_.inversion_for(found->kernel_dimension)
                    .preimages(point.coordinates, std::numeric_limits<long>::max(), surface_.degree().map_degree,
                               point.precision_bits);
        certified_ = false;
      }
      Answer inside = Answer::no;
      for (const HomogeneousParameters& parameters : found->parameters) {
        const Answer within = is_within_patch_(parameters, point);
        if (within == Answer::yes || inside != Answer::yes) inside = within;
        if (inside == Answer::yes) break;
      }
      if (inside != Answer::unknown || !found->proven) return inside == Answer::yes;
    }
  }

  void add_stretch(ParameterRoots& ends, std::size_t first, std::size_t last) {
    ParameterInterval interval;
    const std::array<std::size_t, 2> indices{first, last};
    for (std::size_t k = 0; k < 2; ++k) {
      long radius_exponent = 0;
      for (long bits = bits_for_digits(options_.digits) + 32; !interval[k]; bits *= 2) {
        ends.refine(indices[k], bits);
        interval[k] = print_value(ends.ball(indices[k]), options_.digits, radius_exponent);
      }
    }
    Overlap overlap;
    overlap.t = interval;
    overlaps_.push_back(std::move(overlap));
  }

  const CurvePiece& curve_;
  PreparedSurface& surface_;
  SurfaceBorders& borders_;
  const PatchTest& is_within_patch_;
  const Options& options_;
  const Context& context_;
  bool certified_ = true;
  std::vector<Overlap> overlaps_;
  ContainedParts parts_;
};

}  // namespace

ContainedParts contained_parts(const CurvePiece& curve, PreparedSurface& surface, SurfaceBorders& borders,
                               const PatchTest& is_within_patch, const Options& options, const Context& context) {
  return ContainedCurve(curve, surface, borders, is_within_patch, options, context).run();
}

}  // namespace eliminant::intersect
