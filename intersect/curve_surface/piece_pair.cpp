// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/piece_pair.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/certificates/krawczyk_system.hpp>
#include <eliminant/intersect/curve_surface/contained_curve.hpp>
#include <eliminant/intersect/curve_surface/surface_borders.hpp>
#include <eliminant/intersect/curves/common_points.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/curves/piece_boxes.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/symbolic/elimination/surface_resultant.hpp>
#include <eliminant/symbolic/geometry/border_curve.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::CurvePiece;
using symbolic::MatrixRepresentation;
using symbolic::ParameterForm;
using symbolic::Rational;
using symbolic::RationalCurve;
using symbolic::RationalSurface;

/// One piece of the curve with one piece of the surface.
class PiecePair {
 public:
  PiecePair(const CurvePiece& curve, PreparedSurface& surface, const Options& options, const Context& context,
            CurveResult& result)
      : curve_(curve),
        surface_(surface),
        options_(options),
        context_(context),
        result_(result),
        borders_(surface.piece.map, curve.map, options.seed, context) {}

  void run() {
    if (solve_by_boxes()) return;
    if (options_.engine != Engine::pencil && options_.engine != Engine::exact &&
        excluded_by_boxes(symbolic::bounding_box(curve_), symbolic::bounding_box(surface_.piece), options_, result_))
      return;
    if (!solve_by_pencil()) solve_exactly();
  }

 private:
  /// The box engine answers for real solutions within bounded domains.
  bool solve_by_boxes() {
    if (options_.engine != Engine::automatic && options_.engine != Engine::box) return false;
    if (options_.field == Field::complex) return false;
    auto solutions = surface_.boxes().solve(curve_, options_, context_);
    if (!solutions) return false;
    // Two sheets at one t are one solution, if it is one t.
    for (std::size_t i = 0; i < solutions->size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (acb_overlaps((*(*solutions)[i].t)->ball.get(), (*(*solutions)[j].t)->ball.get()) != 0) return false;
    CurveCounts counts;
    counts.distinct = counts.real = static_cast<unsigned long>(solutions->size());
    for (const CurveSolution& solution : *solutions) counts.with_multiplicity += solution.multiplicity;
    counts.within_domains_only = true;
    EngineReport engine;
    engine.method = "box";
    engine.precision_bits = 53;
    add_part(Status::certified, counts, engine, {}, result_);
    for (CurveSolution& solution : *solutions) result_.solutions.push_back(std::move(solution));
    return true;
  }

  /// The pencil engine answers where all solutions are simple, which their number proves.
  bool solve_by_pencil() {
    if (options_.engine != Engine::automatic && options_.engine != Engine::pencil) return false;
    if (surface_.matrix().columns() < surface_.matrix().rows() || surface_.is_over_the_plane()) return false;
    const symbolic::ImplicitDegree& degree = surface_.degree();
    if (!degree.proven || degree.map_degree != 1) return false;
    const auto expected = static_cast<unsigned long>(degree.product * curve_.map.degree());
    constexpr unsigned long largest_pencil = 600;
    if (static_cast<unsigned long>(surface_.matrix().rows() * curve_.map.degree()) > largest_pencil) return false;
    EngineReport engine;
    auto solutions = surface_.pencil().solve(curve_.map, expected, options_, context_, engine);
    if (!solutions) return false;
    const bool real = real_only(options_, curve_.domain.has_value() || surface_.piece.region.has_value());
    CurveCounts counts;
    counts.expected = counts.with_multiplicity = counts.distinct = expected;
    std::vector<CurveSolution> listed;
    for (CurveSolution& solution : *solutions) {
      if (solution.reality == Reality::real) ++counts.real;
      const Answer inside = is_surely_inside(solution);
      if (inside == Answer::unknown) return false;
      solution.inside = inside == Answer::yes;
      if (options_.engine == Engine::pencil) solution.eigenvalue_multiplicity = 1;
      if (!real || solution.inside) listed.push_back(std::move(solution));
    }
    add_part(Status::certified, counts, engine, {}, result_);
    for (CurveSolution& solution : listed) result_.solutions.push_back(std::move(solution));
    return true;
  }

  /// From the enclosures alone: a point on a border stays unknown.
  Answer is_surely_inside(const CurveSolution& solution) const {
    if (solution.reality != Reality::real) return Answer::no;
    Answer result = Answer::yes;
    const auto require = [&](const ComplexBall& value, const symbolic::Interval& side) {
      constexpr long precision_bits = 256;
      const bridge::RealBall lower(side.lower, precision_bits);
      const bridge::RealBall upper(side.upper, precision_bits);
      if (arb_lt(value.real(), lower.get()) != 0 || arb_gt(value.real(), upper.get()) != 0) {
        result = Answer::no;
      } else if (result == Answer::yes &&
                 (arb_gt(value.real(), lower.get()) == 0 || arb_lt(value.real(), upper.get()) == 0)) {
        result = Answer::unknown;
      }
    };
    if (curve_.domain) require((*solution.t)->ball, *curve_.domain);
    if (!surface_.piece.region) return result;
    const symbolic::ParameterRegion& region = *surface_.piece.region;
    const std::vector<Parameter>& parameters = solution.surface_parameters.front();
    if (!region.triangle) {
      for (std::size_t axis = 0; axis < 2; ++axis) require(parameters[axis]->ball, region.sides[axis]);
      return result;
    }
    constexpr long precision_bits = 256;
    ComplexBall sum;
    for (const Parameter& parameter : parameters) acb_add(sum.get(), sum.get(), parameter->ball.get(), precision_bits);
    for (const Parameter& parameter : parameters) {
      ComplexBall barycentric;
      acb_div(barycentric.get(), parameter->ball.get(), sum.get(), precision_bits);
      if (acb_is_finite(barycentric.get()) == 0) return Answer::unknown;
      require(barycentric, {0, 1});
    }
    return result;
  }

  void solve_exactly() {
    const MatrixRepresentation& m = surface_.matrix();
    EngineReport engine;
    engine.method = "exact";
    engine.matrix = "moving planes";
    engine.matrix_size = m.rows();
    engine.matrix_degree = curve_.map.degree();
    add_part(Status::certified, {}, engine, {}, result_);
    if (m.columns() < m.rows())
      throw LimitReached("the base points of the surface leave no matrix representation by moving planes");
    const bool real = real_only(options_, curve_.domain.has_value() || surface_.piece.region.has_value());
    const auto fill_solution = [&](CurveSolution& solution, const PointOnCurve& point) {
      return fill(solution, point, real);
    };
    if (surface_.equation()) {
      const ParameterForm condition = along_curve(curve_.map, *surface_.equation());
      if (condition.finite.is_zero()) {
        add_contained_curve();
        return;
      }
      if (options_.engine == Engine::pencil)
        minors_ = symbolic::minors_on_curve(m, curve_.map, options_.seed, context_);
      add_condition_roots(curve_, condition, 1, real, options_, context_, fill_solution, result_);
      return;
    }
    // Without base points the smallest representation is square.
    std::optional<ParameterForm> resultant;
    if (m.columns() == m.rows() && surface_.degree().proven && !surface_.is_over_the_plane())
      resultant = symbolic::surface_resultant_on_curve(surface_.piece.map, curve_.map, options_.seed, context_);
    ParameterForm condition =
        resultant ? *resultant : symbolic::minors_on_curve(m, curve_.map, options_.seed, context_);
    if (condition.finite.is_zero()) {
      if (!surface_.degree().proven && !is_contained()) {
        result_.status = Status::numeric;
        warn("the curve lies in a plane that belongs to a base point of the surface: its intersections are not known");
        return;
      }
      // Without a proven degree one general point was looked at.
      if (!surface_.degree().proven) result_.status = Status::numeric;
      add_contained_curve(surface_.degree().proven);
      return;
    }
    minors_ = condition;
    const long expected = surface_.degree().product * curve_.map.degree();
    bool proven = surface_.degree().proven;
    if (condition.degree() != expected) {
      if (auto exact = symbolic::surface_on_curve(m, surface_.degree(), curve_.map, condition, options_.seed, context_))
        condition = *std::move(exact);
      else
        proven = false;
    }
    const std::size_t before = result_.solutions.size();
    add_condition_roots(curve_, condition, surface_.degree().map_degree, real, options_, context_, fill_solution,
                        result_);
    if (proven) return;
    result_.status = Status::numeric;
    for (std::size_t i = before; i < result_.solutions.size(); ++i) {
      result_.solutions[i].certified = false;
      result_.solutions[i].reason = "the base points of the surface leave its degree unproven";
    }
  }

  Filling fill(CurveSolution& solution, const PointOnCurve& point, bool real) {
    // At a point to which a whole curve of parameters belongs no precision tells them.
    const long patience = largest_preimage_precision + 16 * bits_for_digits(options_.digits);
    std::optional<Preimages> preimages = find_preimages(point);
    if (!preimages) {
      if (point.precision_bits < patience) return Filling::more_precision;
      preimages.emplace();
      preimages->proven = false;
    }
    Answer inside = surface_.piece.region ? Answer::no : Answer::yes;
    for (const HomogeneousParameters& parameters : preimages->parameters) {
      if (is_base_point(parameters, point)) {
        if (point.precision_bits < largest_preimage_precision) return Filling::more_precision;
        continue;
      }
      std::optional<std::vector<Parameter>> printed = print(parameters, point, solution.radius_exponent);
      const Answer within = is_within(parameters, point);
      if (!printed || within == Answer::unknown) {
        if (point.precision_bits < patience) return Filling::more_precision;
        preimages->proven = false;
        continue;
      }
      // Of a patch only what lies in it, of a point outside everything.
      if (within == Answer::yes && inside == Answer::no) solution.surface_parameters.clear();
      if (within == Answer::yes || inside == Answer::no || !surface_.piece.region)
        solution.surface_parameters.push_back(*std::move(printed));
      if (within == Answer::yes) inside = Answer::yes;
    }
    if (!preimages->proven) {
      if (inside == Answer::no && !(point.real && surface_.boxes().excludes(point.coordinates, context_)))
        inside = on_collapsed_border(point) ? Answer::yes : Answer::unknown;
      warn("not all parameters of a point of the surface could be proven; those that are not are left out");
    }
    // Several parameters are each proven to be transversal: of a patch only its own sheets count, where all of them
    // are.
    if (surface_.piece.region && inside == Answer::yes && preimages->proven && preimages->kernel_dimension > 1 &&
        solution.multiplicity == preimages->parameters.size())
      solution.multiplicity = static_cast<unsigned long>(solution.surface_parameters.size());
    if (options_.engine == Engine::pencil && !minors_.finite.is_zero())
      solution.eigenvalue_multiplicity = eigenvalue_multiplicity(point);
    if (inside == Answer::unknown) {
      solution.certified = false;
      solution.reason = "whether the point lies in the patch is not proven";
    }
    solution.inside = solution.inside && inside == Answer::yes;
    return real && !solution.inside && inside != Answer::unknown ? Filling::left_out : Filling::done;
  }

  /// Theorem 3 of [LuuBuseMourrain2009]: the eigenvalues of the regular part are the roots of the gcd of the minors.
  unsigned long eigenvalue_multiplicity(const PointOnCurve& point) {
    if (point.roots == nullptr) return static_cast<unsigned long>(minors_.order_at_infinity);
    for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(minors_.finite))
      if (point.roots->is_zero_of(point.index, part.factor)) return part.multiplicity;
    return 0;
  }

  void warn(const std::string& warning) {
    if (std::find(result_.warnings.begin(), result_.warnings.end(), warning) == result_.warnings.end())
      result_.warnings.push_back(warning);
  }

  /// A whole border of the patch may be one point, as at the pole of a sphere.
  bool on_collapsed_border(const PointOnCurve& point) {
    const symbolic::ParameterRegion& region = *surface_.piece.region;
    const auto collapsed = [&](std::size_t axis, const Rational& value) {
      const std::optional<RationalCurve> border = symbolic::border_curve(surface_.piece.map, axis, value);
      return border && border->degree() == 0 && point.real && borders_.contains(point, axis, value);
    };
    if (region.triangle) return collapsed(0, Rational(0)) || collapsed(1, Rational(0)) || collapsed(2, Rational(0));
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (collapsed(axis, region.sides[axis].lower) || collapsed(axis, region.sides[axis].upper)) return true;
    return false;
  }

  /// A kernel of larger dimension is believed when no precision shows a smaller one. Its parameters count when they are
  /// proven one by one.
  std::optional<Preimages> find_preimages(const PointOnCurve& point) {
    const bool patient = point.precision_bits < largest_preimage_precision;
    const long most = patient ? surface_.degree().map_degree : surface_.matrix().rows();
    std::optional<Preimages> found = surface_.inversion_for(1).preimages(
        point.coordinates, most, surface_.degree().map_degree, point.precision_bits);
    if (!found || found->proven) return found;
    const long dimension = found->kernel_dimension;
    const SurfaceInversion& larger = surface_.inversion_for(dimension);
    if (patient && dimension > surface_.degree().map_degree) return std::nullopt;
    found = larger.preimages(point.coordinates, std::numeric_limits<long>::max(), surface_.degree().map_degree,
                             point.precision_bits);
    prove(*found, point);
    return found;
  }

  /// Krawczyk's test in the parameters of the surface and the curve at once.
  void prove(Preimages& preimages, const PointOnCurve& point) {
    std::vector<HomogeneousParameters> proven;
    if (point.roots == nullptr) preimages.parameters.clear();
    for (const HomogeneousParameters& start : preimages.parameters) {
      std::optional<HomogeneousParameters> enclosed = prove(start, point);
      if (!enclosed) continue;
      const bool known = std::any_of(proven.begin(), proven.end(), [&](const HomogeneousParameters& other) {
        return std::equal(other.begin(), other.end(), enclosed->begin(),
                          [](const auto& a, const auto& b) { return acb_overlaps(a.get(), b.get()) != 0; });
      });
      if (!known) proven.push_back(*std::move(enclosed));
    }
    preimages.proven = static_cast<long>(proven.size()) == preimages.kernel_dimension;
    preimages.parameters = std::move(proven);
  }

  std::optional<HomogeneousParameters> prove(const HomogeneousParameters& start, const PointOnCurve& point) {
    std::vector<std::size_t> variables;
    for (std::size_t k = 0; k < start.size(); ++k)
      if (acb_is_one(start[k].get()) == 0 || variables_of_same_group(start, k)) variables.push_back(k);
    if (variables.size() != 2) return std::nullopt;
    std::size_t pivot = 0;
    while (pivot < 3 && acb_contains_zero(point.coordinates[pivot].get()) != 0) ++pivot;
    const bridge::System system =
        common_point_system(surface_.ball_surface(), curve_.map, start, {variables[0], variables[1]}, pivot);
    // A start in the real plane makes a box that is its own mirror image.
    std::vector<ComplexBall> from{start[variables[0]], start[variables[1]], point.roots->ball(point.index)};
    bool start_real = point.real;
    for (std::size_t k = 0; k < 2; ++k) {
      const double imaginary = arf_get_d(arb_midref(from[k].imaginary()), ARF_RND_NEAR);
      start_real = start_real && std::fabs(imaginary) < 1e-6;
    }
    if (start_real)
      for (ComplexBall& value : from) arb_zero(value.imaginary());
    const auto zero = bridge::enclose_system_zero(system, from, point.precision_bits);
    if (!zero) return std::nullopt;
    for (std::size_t i = 0; i < point.roots->size(); ++i)
      if (i != point.index && acb_overlaps((*zero)[2].get(), point.roots->ball(i).get()) != 0) return std::nullopt;
    HomogeneousParameters result = start;
    for (std::size_t k = 0; k < 2; ++k) {
      result[variables[k]] = (*zero)[k];
      if (start_real) arb_zero(result[variables[k]].imaginary());
    }
    return result;
  }

  /// One of several exact ones of a group is only normalised, not the others.
  bool variables_of_same_group(const HomogeneousParameters& parameters, std::size_t k) const {
    for (const std::vector<std::size_t>& group : surface_.ball_surface().groups()) {
      if (std::find(group.begin(), group.end(), k) == group.end()) continue;
      for (const std::size_t other : group)
        if (acb_is_one(parameters[other].get()) != 0) return other != k;
    }
    return false;
  }

  /// At a base point all coordinates vanish; at parameters of a point they do not.
  bool is_base_point(const HomogeneousParameters& parameters, const PointOnCurve& point) const {
    const std::vector<ComplexBall> image = surface_.ball_surface().point_at(parameters, point.precision_bits);
    return std::all_of(image.begin(), image.end(),
                       [](const ComplexBall& z) { return acb_contains_zero(z.get()) != 0; });
  }

  std::optional<std::vector<Parameter>> print(const HomogeneousParameters& parameters, const PointOnCurve& point,
                                              long& radius_exponent) {
    if (surface_.piece.map.kind() == RationalSurface::Kind::triangular) {
      auto printed = print_point(parameters, options_.digits, point.precision_bits, radius_exponent,
                                 [&](std::size_t k) { return borders_.contains(point, k, Rational(0)); });
      if (!printed) return std::nullopt;
      return std::vector<Parameter>(printed->begin(), printed->end());
    }
    std::vector<Parameter> result;
    for (std::size_t group = 0; group < 2; ++group) {
      const auto [above, below] = fraction(group);
      ComplexBall numerator = parameters[above];
      const ComplexBall& denominator = parameters[below];
      if (acb_contains_zero(denominator.get()) != 0) {
        if (!at_infinity(point, group)) return std::nullopt;
        result.emplace_back(std::nullopt);
        continue;
      }
      if (acb_contains_zero(numerator.get()) != 0 && borders_.contains(point, group, Rational(0)))
        acb_zero(numerator.get());
      acb_div(numerator.get(), numerator.get(), denominator.get(), point.precision_bits);
      Parameter printed = print_value(numerator, options_.digits, radius_exponent);
      if (!printed) return std::nullopt;
      result.push_back(std::move(printed));
    }
    return result;
  }

  /// The homogeneous parameters of which an affine one is the quotient.
  std::pair<std::size_t, std::size_t> fraction(std::size_t group) {
    return surface_.is_over_the_plane() ? std::pair(group, std::size_t{2}) : std::pair(2 * group, 2 * group + 1);
  }

  /// Whether the point lies on the curve of the surface where that affine parameter is infinite.
  bool at_infinity(const PointOnCurve& point, std::size_t group) {
    return surface_.is_over_the_plane() ? borders_.at_line_at_infinity(point, surface_.map())
                                        : borders_.contains(point, group, std::nullopt);
  }

  Answer is_within(const HomogeneousParameters& parameters, const PointOnCurve& point) {
    if (!point.real) return Answer::no;
    if (!surface_.piece.region) return Answer::yes;
    const symbolic::ParameterRegion& region = *surface_.piece.region;
    Answer result = Answer::yes;
    const auto require = [&](const ComplexBall& value, std::size_t group, const Rational& border) {
      if (arb_contains_zero(value.imaginary()) == 0) result = Answer::no;
      if (result == Answer::no || arb_is_positive(value.real()) != 0) return;
      if (arb_is_negative(value.real()) != 0) {
        result = Answer::no;
      } else if (!borders_.contains(point, group, border)) {
        result = Answer::unknown;
      }
    };
    const long bits = point.precision_bits;
    if (region.triangle) {
      ComplexBall sum;
      for (const ComplexBall& parameter : parameters) acb_add(sum.get(), sum.get(), parameter.get(), bits);
      // Within the triangle none is negative, and the largest is 1.
      if (acb_contains_zero(sum.get()) != 0) return Answer::no;
      for (std::size_t k = 0; k < 3; ++k) {
        ComplexBall barycentric;
        acb_div(barycentric.get(), parameters[k].get(), sum.get(), bits);
        require(barycentric, k, Rational(0));
      }
      return result;
    }
    for (std::size_t group = 0; group < 2; ++group) {
      ComplexBall value;
      // The quotient by a denominator near 0 is beyond the sides: the numerator is exactly 1 then.
      const symbolic::Interval& side = region.sides[group];
      bridge::RealBall reach(side.lower * side.lower + side.upper * side.upper + Rational(1), bits);
      bridge::RealBall size;
      acb_abs(size.get(), parameters[fraction(group).second].get(), bits);
      arb_mul(size.get(), size.get(), reach.get(), bits);
      arb_sub_ui(size.get(), size.get(), 1, bits);
      if (arb_is_negative(size.get()) != 0) return Answer::no;
      if (acb_contains_zero(parameters[fraction(group).second].get()) != 0) return Answer::unknown;
      acb_div(value.get(), parameters[fraction(group).first].get(), parameters[fraction(group).second].get(), bits);
      for (const bool lower : {true, false}) {
        const Rational& border = lower ? region.sides[group].lower : region.sides[group].upper;
        bridge::RealBall end(border, bits);
        ComplexBall distance = value;
        arb_sub(distance.real(), distance.real(), end.get(), bits);
        if (!lower) arb_neg(distance.real(), distance.real());
        require(distance, group, border);
      }
    }
    return result;
  }

  /// The curve lies in the surface; `certified` tells whether that is proven.
  void add_contained_curve(bool certified = true) {
    const PatchTest is_within_patch = [&](const HomogeneousParameters& parameters, const PointOnCurve& point) {
      return is_within(parameters, point);
    };
    ContainedParts parts = contained_parts(curve_, surface_, borders_, is_within_patch, options_, context_);
    for (Overlap& overlap : parts.stretches) {
      overlap.certified = overlap.certified && certified;
      if (!overlap.certified) result_.status = Status::numeric;
      result_.overlap.push_back(std::move(overlap));
    }
    add_touching_points(parts, certified);
  }

  /// Where a curve in the surface meets the patch in one point alone, in a corner, at its own end or tangent to a
  /// border: those of the isolated crossings that are in the patch.
  void add_touching_points(const ContainedParts& parts, bool certified) {
    if (parts.isolated.empty()) return;
    ParameterRoots ends(parts.crossings, Wanted::real, context_);
    const CurveCounts counts = result_.counts;
    const auto fill_touching = [&](CurveSolution& solution, const PointOnCurve& point) {
      const bool is_candidate = std::any_of(parts.isolated.begin(), parts.isolated.end(), [&](std::size_t i) {
        return point.exact_t ? ends.compare(i, *point.exact_t) == 0 : point.roots != nullptr && point.index == i;
      });
      if (!is_candidate) return Filling::left_out;
      const Filling filling = fill(solution, point, true);
      if (filling == Filling::done && !(parts.certified && certified)) {
        solution.certified = false;
        solution.reason = "which parts of the curve lie in the patch is not proven";
      }
      return filling;
    };
    add_condition_roots(curve_, {parts.crossings, 0}, 1, true, options_, context_, fill_touching, result_);
    // These are no solutions of an equation.
    result_.counts = counts;
  }

  /// Whether a general point of the curve has parameters on the surface, and not only a base point in its kernel.
  bool is_contained() {
    PointOnCurve point;
    point.precision_bits = 256;
    for (const Rational& coordinate : curve_.map.at(Rational(symbolic::Integer(355), symbolic::Integer(113)))) {
      ComplexBall& ball = point.coordinates.emplace_back();
      arb_set_fmpq(ball.real(), coordinate.get(), point.precision_bits);
    }
    const auto found = surface_.inversion_for(1).preimages(point.coordinates, surface_.matrix().rows(),
                                                           surface_.degree().map_degree, point.precision_bits);
    return found && std::any_of(found->parameters.begin(), found->parameters.end(),
                                [&](const HomogeneousParameters& p) { return !is_base_point(p, point); });
  }

  const CurvePiece& curve_;
  PreparedSurface& surface_;
  const Options& options_;
  const Context& context_;
  CurveResult& result_;
  SurfaceBorders borders_;
  ParameterForm minors_;
};

}  // namespace

void intersect_pieces(const CurvePiece& curve, PreparedSurface& surface, const Options& options, const Context& context,
                      CurveResult& result) {
  PiecePair(curve, surface, options, context, result).run();
}

}  // namespace eliminant::intersect
