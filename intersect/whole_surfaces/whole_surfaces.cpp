// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/whole_surfaces.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/intersect/overlaps/equal_surfaces.hpp>
#include <eliminant/intersect/whole_surfaces/contracted_lines.hpp>
#include <eliminant/intersect/whole_surfaces/whole_curve.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::BezoutianEliminant;
using symbolic::ComponentKind;
using symbolic::DeterminantVanishing;
using Clock = std::chrono::steady_clock;

const std::array<const char*, 4> names{"u", "v", "s", "t"};

constexpr const char* contracted =
    "a curve of parameters is contracted to a common point; whether that lies on the curve is not proven";

/// Changes of a projective line; the first leaves everything as it is.
constexpr std::array<ProjectiveChange, 6> changes{
    {{1, 0, 0, 1}, {2, 1, -1, 2}, {1, 3, -2, 1}, {3, -1, 2, 3}, {1, -2, 3, 2}, {3, 4, -4, 5}}};

class WholeIntersection {
 public:
  WholeIntersection(const Options& options, const Context& context) : options_(options), context_(context) {
    symbolic::install_flint_error_handler();
  }

  /// With the parameters of the projection that prove the most.
  SurfaceResult of_two(const symbolic::RationalSurface& first, const symbolic::RationalSurface& second) {
    const auto start = Clock::now();
    std::optional<SurfaceResult> best;
    for (const unsigned exchanged : {0U, 1U, 2U, 3U}) {
      begin(first, second, exchanged);
      if (eliminant_.vanishing != DeterminantVanishing::overlap && exchanged != 3 && best && !is_one_to_one()) continue;
      solve();
      const bool is_better = !best || (best->status == Status::numeric && result_.status != Status::numeric);
      if (is_better) best = std::move(result_);
      if (best->status != Status::numeric || !options_.certify) break;
    }
    best->seconds.front().second = std::chrono::duration<double>(Clock::now() - start).count();
    return *std::move(best);
  }

  SurfaceResult of_one(const symbolic::RationalSurface& surface) {
    result_.problem = "self_intersection";
    surfaces_.emplace(PreparedSurfaces{surface, surface, true});
    eliminant_ = symbolic::self_intersection_eliminant(surface, options_.seed, context_);
    solve();
    return std::move(result_);
  }

 private:
  /// The parameters that the projection keeps: with bit 0 v in place of u, with bit 1 s in place of t.
  void begin(const symbolic::RationalSurface& first, const symbolic::RationalSurface& second, unsigned exchanged) {
    result_ = SurfaceResult();
    proven_ = true;
    components_are_changed_ = false;
    const bool exchange_first = (exchanged & 1U) != 0;
    const bool exchange_second = (exchanged & 2U) != 0;
    surfaces_.emplace(PreparedSurfaces{exchange_first ? exchange_parameters(first) : first,
                                       exchange_second ? exchange_parameters(second) : second});
    if (exchange_first) std::swap(surfaces_->source[0], surfaces_->source[1]);
    if (exchange_second) std::swap(surfaces_->source[2], surfaces_->source[3]);
    eliminant_ = symbolic::intersection_eliminant(surfaces_->first, surfaces_->second, options_.seed, context_);
  }

  /// Points of the projection have one common point above them in general, and nothing is hidden.
  bool is_one_to_one() const {
    return eliminant_.stationary.empty() &&
           std::all_of(eliminant_.components.begin(), eliminant_.components.end(), [](const auto& component) {
             return component.kind != ComponentKind::curve ||
                    (component.meetings == 1 && component.multiplicity == 1 && !component.infinite_parameters);
           });
  }

  /// False where the factor, in one variable, has no real root.
  static bool may_be_real(const symbolic::Polynomial& factor) {
    const std::size_t variable = factor.degree(0) > 0 ? 0 : 1;
    if (factor.degree(1 - variable) > 0) return true;
    const symbolic::UnivariatePolynomial p =
        symbolic::hide_variable(factor, variable).leading_coefficient().primitive_part();
    const Context context;
    return !bridge::IsolatedRoots::real(p, context).balls().empty();
  }

  void doubt(const std::string& reason) {
    proven_ = false;
    if (std::find(result_.warnings.begin(), result_.warnings.end(), reason) != result_.warnings.end()) return;
    result_.warnings.push_back(reason);
  }

  /// The bidegree of the determinant, unless it vanishes at infinite parameters.
  std::array<long, 2> full_degrees() const {
    const auto [m, n] = surfaces_->first.bidegree();
    const auto [k, l] = surfaces_->second.bidegree();
    if (surfaces_->with_itself) return {2 * m * m * n - 4 * m + 2, 2 * m * n * n - 4 * n + 2};
    return {2 * m * n * k, 2 * l * n * k};
  }

  bool hides_components_at_infinity() const {
    const auto full = full_degrees();
    return eliminant_.determinant.degree(0) != full[0] || eliminant_.determinant.degree(1) != full[1];
  }

  bool are_polynomial() const { return is_polynomial(surfaces_->first) && is_polynomial(surfaces_->second); }

  /// Parameters in which nothing particular happens where they are infinite.
  void choose_parameters() {
    if (are_polynomial()) return;
    const BezoutianEliminant of_original = eliminant_;
    const bool hides = hides_components_at_infinity();
    for (const ProjectiveChange& change : changes) {
      surfaces_->change = {change, ProjectiveChange{change.d, change.b, change.c, change.a}};
      if (hides && !change.is_identity()) {
        const symbolic::RationalSurface first = surfaces_->changed_first();
        eliminant_ = surfaces_->with_itself ? symbolic::self_intersection_eliminant(first, options_.seed, context_)
                                            : symbolic::intersection_eliminant(first, surfaces_->changed_second(),
                                                                               options_.seed, context_);
        components_are_changed_ = true;
        if (hides_components_at_infinity()) continue;
      } else if (!change.is_identity()) {
        eliminant_.curve =
            change_parameters(of_original.curve, {of_original.curve.degree(0), of_original.curve.degree(1)},
                              surfaces_->change)
                .primitive_part();
      } else if (hides) {
        continue;
      }
      if (eliminant_.curve.is_constant() || is_general_at_infinity(eliminant_.curve)) return;
    }
    doubt("no parameters were found for which the projection is in general position at infinity");
  }

  /// The factors of the determinant that are no projections of curves, in the parameters of the projection.
  symbolic::Polynomial extraneous() const {
    symbolic::Polynomial product = symbolic::Polynomial::constant(2, 1);
    for (const symbolic::EliminantComponent& component : eliminant_.components)
      if (component.kind != ComponentKind::curve) product = product * component.factor;
    if (components_are_changed_) return product;
    return change_parameters(product, {product.degree(0), product.degree(1)}, surfaces_->change).primitive_part();
  }

  void report_projection() {
    std::vector<std::string> kept{names[surfaces_->source[0]], names[surfaces_->source[3]]};
    if (surfaces_->with_itself) kept = {"u", "v"};
    result_.projection = SurfaceProjection{std::move(kept), eliminant_};
    result_.engine.method = "eliminant";
    result_.engine.matrix = "bezoutian";
    result_.engine.matrix_size = static_cast<long>(eliminant_.size);
    result_.engine.seed = options_.seed;
  }

  /// Above a general point of a simple factor the matrix has corank one, so that there is one common point at most.
  void judge_components() {
    for (const symbolic::EliminantComponent& component : eliminant_.components) {
      if (component.kind == ComponentKind::curve) {
        if (component.infinite_parameters) doubt("a parameter is infinite all along a component of the curve");
        if (component.meetings != 1) doubt("above a component of the projection there are several common points");
        if (component.multiplicity > 1 && component.meetings == 1)
          doubt("a component of the projection is multiple: the surfaces may be tangent along it");
      } else if (!component.proven) {
        doubt("what is above a factor of the eliminant was seen modulo primes, not proven: " +
              std::string(symbolic::explanation(component.kind)));
      } else if (component.kind == ComponentKind::contracted_curve && may_be_real(component.factor)) {
        doubt(contracted);
      }
    }
    if (!surfaces_->with_itself && !(contracts_nothing_to(surfaces_->first, surfaces_->second, context_) &&
                                     contracts_nothing_to(surfaces_->second, surfaces_->first, context_)))
      doubt(contracted);
    if (!eliminant_.stationary.empty())
      doubt("common curves may be hidden: along them both parameters of the projection are constant");
  }

  void solve() {
    const auto start = Clock::now();
    report_projection();
    if (eliminant_.vanishing != DeterminantVanishing::no) {
      treat_vanishing();
      if (eliminant_.vanishing == DeterminantVanishing::overlap) {
        result_.seconds = {{"total", std::chrono::duration<double>(Clock::now() - start).count()}};
        return;
      }
    }
    choose_parameters();
    judge_components();
    const auto chosen = Clock::now();
    if (!eliminant_.curve.is_constant()) {
      const symbolic::Polynomial others = extraneous();
      WholeCurve curve(*surfaces_, eliminant_.curve, others, options_, context_);
      proven_ = curve.find(result_) && proven_;
    }
    count();
    result_.status = proven_ && options_.certify ? Status::certified : Status::numeric;
    const auto seconds = [](auto from, auto to) { return std::chrono::duration<double>(to - from).count(); };
    result_.seconds = {{"total", seconds(start, Clock::now())},
                       {"projection", seconds(start, chosen)},
                       {"curve", seconds(chosen, Clock::now())}};
  }

  /// Both maps have one surface as image.
  void add_overlap() {
    if (options_.certify && !have_common_real_part(surfaces_->first, surfaces_->second, options_, context_)) {
      doubt("both images are parts of one surface; whether their real points have an area in common is not known");
    } else {
      SurfaceComponent overlap;
      overlap.kind = SurfaceComponentKind::overlap;
      overlap.certified = options_.certify;
      result_.components.push_back(std::move(overlap));
      result_.status = Status::infinite;
      result_.rest_status = options_.certify ? Status::certified : Status::numeric;
    }
    count();
  }

  void treat_vanishing() {
    const std::string reason(symbolic::explanation(eliminant_.vanishing));
    if (eliminant_.vanishing == DeterminantVanishing::overlap) {
      add_overlap();
      return;
    }
    doubt("the eliminant vanishes identically: " + reason);
  }

  void count() {
    std::stable_sort(result_.components.begin(), result_.components.end(), [](const auto& a, const auto& b) {
      return std::pair(a.kind, smallest(a)) < std::pair(b.kind, smallest(b));
    });
    result_.counts.curves = of_kind(SurfaceComponentKind::curve);
    result_.counts.loops = of_kind(SurfaceComponentKind::loop);
    result_.counts.points = of_kind(SurfaceComponentKind::point);
    result_.counts.overlaps = of_kind(SurfaceComponentKind::overlap);
    result_.counts.singular = result_.singular_points.size();
    if (!options_.certify)
      for (SurfaceComponent& component : result_.components) component.certified = false;
  }

  static std::array<double, 4> smallest(const SurfaceComponent& component) {
    std::array<double, 4> least{};
    least.fill(INFINITY);
    for (const SurfacePoint& point : component.points) least = std::min(least, point.parameters);
    return least;
  }

  unsigned long of_kind(SurfaceComponentKind kind) const {
    return static_cast<unsigned long>(
        std::count_if(result_.components.begin(), result_.components.end(),
                      [&](const SurfaceComponent& component) { return component.kind == kind; }));
  }

  const Options& options_;
  const Context& context_;
  std::optional<PreparedSurfaces> surfaces_;
  BezoutianEliminant eliminant_;
  SurfaceResult result_;
  bool components_are_changed_ = false;
  bool proven_ = true;
};

}  // namespace

SurfaceResult intersect_whole_surfaces(const symbolic::RationalSurface& first, const symbolic::RationalSurface& second,
                                       const Options& options, const Context& context) {
  return WholeIntersection(options, context).of_two(first, second);
}

SurfaceResult intersect_whole_surface_with_itself(const symbolic::RationalSurface& surface, const Options& options,
                                                  const Context& context) {
  return WholeIntersection(options, context).of_one(surface);
}

}  // namespace eliminant::intersect
