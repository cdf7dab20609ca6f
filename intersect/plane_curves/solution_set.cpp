// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/certificates/representation_points.hpp>
#include <eliminant/intersect/plane_curves/solution_set.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/arithmetic/rational_univariate.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using bridge::PlaneBall;

/// Beyond this no input within the size limits is still unresolved; it only bounds what a mistake could cost.
constexpr long precision_ceiling = 1L << 24;

long part_radius_log2(arb_srcptr part) {
  if (mag_is_special(arb_radref(part)) != 0) return mag_is_inf(arb_radref(part)) ? precision_ceiling : -(1L << 40);
  return static_cast<long>(fmpz_get_si(MAG_EXPREF(arb_radref(part))));
}

/// g with g(y) = 0 exactly when (value, y) is a solution (axis 0), or (y, value) (axis 1); 1 when there is none.
symbolic::UnivariatePolynomial solutions_on_line(const symbolic::Polynomial& p, const symbolic::Polynomial& q,
                                                 std::size_t axis, const symbolic::Rational& value) {
  const auto restrict_to_line = [&](const symbolic::Polynomial& curve) {
    const symbolic::HiddenVariablePolynomial rows = symbolic::hide_variable(curve, axis);
    symbolic::RationalUnivariate restricted;
    symbolic::Rational coefficient;
    for (std::size_t j = 0; j < rows.coefficients.size(); ++j) {
      fmpz_poly_evaluate_fmpq(coefficient.get(), rows.coefficients[j].get(), value.get());
      fmpq_poly_set_coeff_fmpq(restricted.get(), static_cast<slong>(j), coefficient.get());
    }
    return restricted.numerator();
  };
  return symbolic::gcd(restrict_to_line(p), restrict_to_line(q));
}

symbolic::Polynomial scaled(const symbolic::Polynomial& p, const bridge::PowerOfTwoScaling& scaling) {
  return symbolic::scale_by_powers_of_two(p, scaling.x_log2, scaling.y_log2).primitive_part();
}

}  // namespace

long radius_log2(const PlaneBall& box) {
  return std::max({part_radius_log2(box.x.real()), part_radius_log2(box.x.imaginary()), part_radius_log2(box.y.real()),
                   part_radius_log2(box.y.imaginary())});
}

bool disjoint(const PlaneBall& a, const PlaneBall& b) {
  return !acb_overlaps(a.x.get(), b.x.get()) || !acb_overlaps(a.y.get(), b.y.get());
}

SolutionSet::SolutionSet(const symbolic::Polynomial& p, const symbolic::Polynomial& q, Wanted wanted,
                         const Context& context)
    : p_(p),
      q_(q),
      scaling_(bridge::choose_scaling(p, q)),
      scaled_p_(scaled(p, scaling_)),
      scaled_q_(scaled(q, scaling_)),
      rounded_p_(bridge::RoundedCurve::round(scaled(p, scaling_))),
      rounded_q_(bridge::RoundedCurve::round(scaled(q, scaling_))),
      wanted_(wanted),
      context_(context) {}

long SolutionSet::scaled_target(long radius_log2) const {
  return radius_log2 - std::max(scaling_.x_log2, scaling_.y_log2) - 1;
}

std::optional<bridge::DiscCertificate> SolutionSet::certify_in_doubles(const PlaneBall& scaled_start) const {
  if (!rounded_p_ || !rounded_q_) return std::nullopt;
  const auto to_double = [](const ComplexBall& z) {
    return std::complex<double>(arf_get_d(arb_midref(z.real()), ARF_RND_NEAR),
                                arf_get_d(arb_midref(z.imaginary()), ARF_RND_NEAR));
  };
  return bridge::disc_krawczyk_test(*rounded_p_, *rounded_q_, {to_double(scaled_start.x), to_double(scaled_start.y)});
}

PlaneBall SolutionSet::to_scaled(const PlaneBall& point) const {
  PlaneBall result = point;
  acb_mul_2exp_si(result.x.get(), result.x.get(), -scaling_.x_log2);
  acb_mul_2exp_si(result.y.get(), result.y.get(), -scaling_.y_log2);
  return result;
}

PlaneBall SolutionSet::from_scaled(const PlaneBall& point) const {
  PlaneBall result = point;
  acb_mul_2exp_si(result.x.get(), result.x.get(), scaling_.x_log2);
  acb_mul_2exp_si(result.y.get(), result.y.get(), scaling_.y_log2);
  return result;
}

void SolutionSet::store(EnclosedPoint& point, PlaneBall box, long target_log2) const {
  if (point.reality == Reality::real) {
    arb_zero(box.x.imaginary());
    arb_zero(box.y.imaginary());
  }
  const auto set_exact = [&](const std::optional<symbolic::Rational>& value, ComplexBall& coordinate) {
    if (!value) return;
    const auto size_bits = static_cast<long>(value->numerator().bit_length());
    acb_set_fmpq(coordinate.get(), value->get(), size_bits + std::max(0L, -target_log2) + 64);
  };
  set_exact(point.exact_x, box.x);
  set_exact(point.exact_y, box.y);
  point.box = std::move(box);
}

int SolutionSet::add_simple(const PlaneBall& start, long target_log2, long max_precision_bits,
                            long first_precision_bits) {
  context_.checkpoint("certifying");
  const PlaneBall scaled_start = to_scaled(start);
  EnclosedPoint candidate;
  candidate.disc = certify_in_doubles(scaled_start);
  std::optional<bridge::SimpleZero> zero;
  if (candidate.disc)
    zero = bridge::SimpleZero{bridge::region_of(*candidate.disc), bridge::region_of(*candidate.disc)};
  else if (max_precision_bits > 53)
    zero = bridge::enclose_simple_zero(scaled_p_, scaled_q_, scaled_start, scaled_target(target_log2),
                                       max_precision_bits, first_precision_bits);
  if (!zero) return 0;
  candidate.region = zero->region;
  candidate.box = from_scaled(zero->box);
  // The polydisc around a real point is its own mirror image, and so is its one zero.
  if (candidate.disc && candidate.disc->center.x.imag() == 0 && candidate.disc->center.y.imag() == 0) {
    arb_zero(candidate.box.x.imaginary());
    arb_zero(candidate.box.y.imaginary());
  }
  if (acb_is_real(candidate.box.x.get()) && acb_is_real(candidate.box.y.get())) candidate.reality = Reality::real;
  // Either the same zero, which one box around both proves, or another one, which tighter boxes prove.
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (candidate.disc && points_[i].disc && bridge::far_apart(*candidate.disc, *points_[i].disc)) continue;
    long precision_bits = 128;
    while (!disjoint(points_[i].box, candidate.box)) {
      if (bridge::enclose_same_zero(scaled_p_, scaled_q_, to_scaled(points_[i].box), to_scaled(candidate.box)))
        return 0;
      precision_bits *= 2;
      if (precision_bits > precision_ceiling) throw PrecisionExhausted("two solutions could not be told apart");
      enclose(candidate, -precision_bits);
      enclose(points_[i], -precision_bits);
    }
  }
  const bool non_real =
      !arb_contains_zero(candidate.box.x.imaginary()) || !arb_contains_zero(candidate.box.y.imaginary());
  if (!non_real) {
    points_.push_back(std::move(candidate));
    return 1;
  }
  // p and q are real: the conjugate is a solution too, and new, because it would have brought this one with it.
  candidate.reality = Reality::non_real;
  EnclosedPoint conjugate = candidate;
  acb_conj(conjugate.box.x.get(), conjugate.box.x.get());
  acb_conj(conjugate.box.y.get(), conjugate.box.y.get());
  acb_conj(conjugate.region.x.get(), conjugate.region.x.get());
  acb_conj(conjugate.region.y.get(), conjugate.region.y.get());
  if (conjugate.disc) conjugate.disc = bridge::conjugate(*conjugate.disc);
  points_.push_back(std::move(candidate));
  points_.push_back(std::move(conjugate));
  return 2;
}

void SolutionSet::set_representation(symbolic::UnivariateRepresentation representation) {
  classes_.clear();
  classes_.resize(representation.classes.size());
  representation_ = std::move(representation);
}

bridge::IsolatedRoots SolutionSet::isolate(const symbolic::UnivariatePolynomial& squarefree,
                                           const std::vector<ComplexBall>& approximations) const {
  return wanted_ == Wanted::real ? bridge::IsolatedRoots::real(squarefree, context_)
                                 : bridge::IsolatedRoots(squarefree, context_, approximations);
}

void SolutionSet::add_class(std::size_t class_index, const std::vector<PlaneBall>& approximations) {
  const symbolic::SquarefreeFactor& part = representation_->classes[class_index];
  bridge::IsolatedRoots& roots = classes_[class_index];
  std::vector<ComplexBall> values;
  for (const PlaneBall& point : approximations) {
    constexpr long precision_bits = 256;
    ComplexBall& t = values.emplace_back();
    acb_mul_si(t.get(), point.y.get(), representation_->shear, precision_bits);
    acb_add(t.get(), t.get(), point.x.get(), precision_bits);
  }
  roots = isolate(part.factor, values);
  constexpr long first_radius_log2 = -64;
  for (std::size_t root = 0; root < roots.balls().size(); ++root) {
    EnclosedPoint point;
    point.multiplicity = part.multiplicity;
    point.class_index = class_index;
    point.root_index = root;
    // The shear is rational and separates conjugate points: a solution is real exactly when its t is.
    point.reality = arb_is_zero(roots.balls()[root].imaginary()) ? Reality::real : Reality::non_real;
    acb_indeterminate(point.box.x.get());
    acb_indeterminate(point.box.y.get());
    enclose(point, first_radius_log2);
    points_.push_back(std::move(point));
  }
}

void SolutionSet::add_product(const std::vector<symbolic::SquarefreeFactor>& x_factors,
                              const std::vector<symbolic::SquarefreeFactor>& y_factors) {
  constexpr long first_bits = 80;
  const auto isolate_all = [&](const std::vector<symbolic::SquarefreeFactor>& factors,
                               std::vector<bridge::IsolatedRoots>& classes) {
    for (const symbolic::SquarefreeFactor& part : factors) {
      bridge::IsolatedRoots& roots = classes.emplace_back(isolate(part.factor));
      for (std::size_t i = 0; i < roots.balls().size(); ++i) roots.refine(i, first_bits, context_);
    }
  };
  isolate_all(x_factors, x_classes_);
  isolate_all(y_factors, y_classes_);
  for (std::size_t i = 0; i < x_factors.size(); ++i)
    for (std::size_t j = 0; j < y_factors.size(); ++j)
      for (std::size_t k = 0; k < x_classes_[i].balls().size(); ++k)
        for (std::size_t l = 0; l < y_classes_[j].balls().size(); ++l) {
          EnclosedPoint point;
          point.multiplicity = x_factors[i].multiplicity * y_factors[j].multiplicity;
          point.product = EnclosedPoint::ProductRoots{i, k, j, l};
          point.box = {x_classes_[i].balls()[k], y_classes_[j].balls()[l]};
          // A root that is not real has a non-zero imaginary part in its ball, and a real one an exact zero.
          const bool real = acb_is_real(point.box.x.get()) != 0 && acb_is_real(point.box.y.get()) != 0;
          point.reality = real ? Reality::real : Reality::non_real;
          points_.push_back(std::move(point));
        }
}

bool SolutionSet::enclose_product(EnclosedPoint& point, long target_log2) {
  const EnclosedPoint::ProductRoots roots = *point.product;
  for (long bits = std::max(64L, -target_log2 + 32); bits <= precision_ceiling; bits *= 2) {
    bridge::IsolatedRoots& x_roots = x_classes_[roots.x_factor];
    bridge::IsolatedRoots& y_roots = y_classes_[roots.y_factor];
    x_roots.refine(roots.x_root, bits, context_);
    y_roots.refine(roots.y_root, bits, context_);
    store(point, {x_roots.balls()[roots.x_root], y_roots.balls()[roots.y_root]}, target_log2);
    if (radius_log2(point.box) <= target_log2) return true;
  }
  return false;
}

void SolutionSet::decide_reality() {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    long precision_bits = 128;
    while (points_[i].reality == Reality::undecided) {
      context_.checkpoint("deciding reality");
      EnclosedPoint& point = points_[i];
      if (!arb_contains_zero(point.box.x.imaginary()) || !arb_contains_zero(point.box.y.imaginary())) {
        point.reality = Reality::non_real;
      } else if (bridge::zero_is_real(scaled_p_, scaled_q_, to_scaled(point.box))) {
        point.reality = Reality::real;
        store(point, PlaneBall(point.box), 0);
      } else {
        precision_bits *= 2;
        if (precision_bits > precision_ceiling)
          throw PrecisionExhausted("a solution could not be proven real or non-real");
        enclose(i, -precision_bits);
      }
    }
  }
}

void SolutionSet::enclose(std::size_t index, long target_log2) { enclose(points_[index], target_log2); }

void SolutionSet::enclose(EnclosedPoint& point, long target_log2) {
  if (radius_log2(point.box) <= target_log2) return;
  context_.checkpoint("refining");
  if (point.product) {
    if (!enclose_product(point, target_log2)) throw PrecisionExhausted("a solution could not be refined");
    return;
  }
  if (!point.class_index) {
    std::optional<PlaneBall> box;
    if (point.disc) box = bridge::enclose_zero(*point.disc, scaled_p_, scaled_q_, scaled_target(target_log2));
    if (!box) {
      std::optional<bridge::SimpleZero> zero =
          bridge::refine_simple_zero(scaled_p_, scaled_q_, point.region, scaled_target(target_log2), precision_ceiling);
      if (!zero) throw PrecisionExhausted("a simple solution could not be refined");
      point.region = std::move(zero->region);
      box = std::move(zero->box);
    }
    store(point, from_scaled(*box), target_log2);
    return;
  }
  for (long bits = std::max(64L, -target_log2 + 32); bits <= precision_ceiling; bits *= 2) {
    bridge::IsolatedRoots& roots = classes_[*point.class_index];
    roots.refine(point.root_index, bits, context_);
    const std::optional<PlaneBall> box =
        bridge::point_above(*representation_, point.multiplicity, roots.balls()[point.root_index], bits + 64);
    if (!box) continue;
    store(point, *box, target_log2);
    if (radius_log2(point.box) <= target_log2) return;
  }
  throw PrecisionExhausted("a multiple solution could not be refined");
}

void SolutionSet::find_exact_coordinate(std::size_t axis, const symbolic::Rational& value) {
  const symbolic::UnivariatePolynomial line = solutions_on_line(p_, q_, axis, value);
  if (line.degree() < 1) return;
  const auto coordinate = [&](EnclosedPoint& point, std::size_t which) -> ComplexBall& {
    return which == 0 ? point.box.x : point.box.y;
  };
  for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(line)) {
    for (long bits = 64;; bits *= 2) {
      if (bits > precision_ceiling) throw PrecisionExhausted("the solutions on a line could not be told apart");
      std::vector<ComplexBall> others = bridge::enclose_roots(part.factor, bits, context_);
      // Every (value, root) is a solution; it is the one point whose box it may lie in, if it belongs to the set.
      if (wanted_ == Wanted::real)
        std::erase_if(others, [](const ComplexBall& other) { return arb_is_zero(other.imaginary()) == 0; });
      std::vector<std::size_t> matches;
      bool ambiguous = false;
      for (const ComplexBall& other : others) {
        std::vector<std::size_t> near;
        for (std::size_t i = 0; i < points_.size(); ++i)
          if (acb_contains_fmpq(coordinate(points_[i], axis).get(), value.get()) &&
              acb_overlaps(coordinate(points_[i], 1 - axis).get(), other.get()))
            near.push_back(i);
        if (near.size() > 1) {
          ambiguous = true;
          for (const std::size_t i : near) enclose(i, -2 * bits);
        } else if (near.size() == 1) {
          matches.push_back(near.front());
        }
      }
      if (ambiguous) continue;
      for (const std::size_t i : matches) {
        EnclosedPoint& point = points_[i];
        (axis == 0 ? point.exact_x : point.exact_y) = value;
        store(point, PlaneBall(point.box), radius_log2(point.box));
      }
      break;
    }
  }
}

}  // namespace eliminant::intersect
