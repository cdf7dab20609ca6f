// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/common_points.hpp>

#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/plane_curves/parameter_roots.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using Coordinates = std::vector<ComplexBall>;

ComplexBall minor(const Coordinates& a, const Coordinates& b, std::size_t j, std::size_t pivot, long precision_bits) {
  ComplexBall value;
  ComplexBall product;
  acb_mul(value.get(), a[j].get(), b[pivot].get(), precision_bits);
  acb_mul(product.get(), a[pivot].get(), b[j].get(), precision_bits);
  acb_sub(value.get(), value.get(), product.get(), precision_bits);
  return value;
}

constexpr auto never = [](std::size_t) { return false; };

/// The parameter and the point of a solution on a curve.
std::optional<CurveSolution> print_on_curve(const symbolic::RationalCurve& curve, const ComplexBall& t,
                                            const Options& options, long precision_bits) {
  CurveSolution solution;
  solution.radius_exponent = -options.digits;
  solution.certified = options.certify;
  Parameter printed_t = print_value(t, options.digits, solution.radius_exponent);
  if (!printed_t) return std::nullopt;
  solution.t = std::move(printed_t);
  Coordinates point;
  for (const symbolic::UnivariatePolynomial& f : curve.coordinates()) point.push_back(evaluate(f, t, precision_bits));
  auto printed = print_point(point, options.digits, precision_bits, solution.radius_exponent, never);
  if (!printed) return std::nullopt;
  solution.point = *std::move(printed);
  return solution;
}

}  // namespace

std::optional<std::array<std::size_t, 2>> chart_variables(const bridge::BallSurface& surface,
                                                          const bridge::HomogeneousParameters& parameters) {
  std::vector<std::size_t> variables;
  for (const std::vector<std::size_t>& group : surface.groups()) {
    bool normalized = false;
    for (const std::size_t k : group) {
      if (!normalized && acb_is_one(parameters[k].get()) != 0)
        normalized = true;
      else
        variables.push_back(k);
    }
    if (!normalized) return std::nullopt;
  }
  return std::array<std::size_t, 2>{variables[0], variables[1]};
}

int newton_steps(long precision_bits) {
  constexpr long after_one_step = 90;
  int steps = 1;
  for (long reached = after_one_step; reached < precision_bits; reached *= 2) ++steps;
  return steps;
}

std::optional<CurveSolution> print_common_point(const bridge::BallSurface& surface,
                                                const symbolic::RationalCurve& curve,
                                                const bridge::HomogeneousParameters& parameters, const ComplexBall& t,
                                                const Options& options, long precision_bits) {
  std::optional<CurveSolution> printed = print_on_curve(curve, t, options, precision_bits);
  if (!printed) return std::nullopt;
  CurveSolution& solution = *printed;
  std::vector<Parameter>& on_surface = solution.surface_parameters.emplace_back();
  if (!surface.is_tensor_product()) {
    const auto triple = print_point(parameters, options.digits, precision_bits, solution.radius_exponent, never);
    if (!triple) return std::nullopt;
    on_surface.assign(triple->begin(), triple->end());
    return printed;
  }
  for (const std::vector<std::size_t>& group : surface.groups()) {
    ComplexBall value;
    acb_div(value.get(), parameters[group[0]].get(), parameters[group[1]].get(), precision_bits);
    Parameter parameter = print_value(value, options.digits, solution.radius_exponent);
    if (!parameter) return std::nullopt;
    on_surface.push_back(std::move(parameter));
  }
  return printed;
}

std::optional<CurveSolution> print_common_point(const symbolic::RationalCurve& first, const ComplexBall& t,
                                                const ComplexBall& u, const Options& options, long precision_bits) {
  std::optional<CurveSolution> solution = print_on_curve(first, t, options, precision_bits);
  if (!solution) return std::nullopt;
  solution->u = print_value(u, options.digits, solution->radius_exponent);
  if (!*solution->u) return std::nullopt;
  return solution;
}

bridge::System common_point_system(const symbolic::RationalCurve& first, const symbolic::RationalCurve& second) {
  const auto with_derivatives = [](const symbolic::RationalCurve& curve) {
    std::vector<symbolic::UnivariatePolynomial> derivatives;
    for (const symbolic::UnivariatePolynomial& f : curve.coordinates()) derivatives.push_back(f.derivative());
    return [&curve, derivatives](const ComplexBall& at, long precision_bits) {
      std::array<Coordinates, 2> result;
      for (std::size_t k = 0; k < curve.coordinates().size(); ++k) {
        result[0].push_back(evaluate(curve.coordinates()[k], at, precision_bits));
        result[1].push_back(evaluate(derivatives[k], at, precision_bits));
      }
      return result;
    };
  };
  return [a = with_derivatives(first), b = with_derivatives(second)](const std::vector<ComplexBall>& at,
                                                                     long precision_bits) {
    const std::array<Coordinates, 2> p = a(at[0], precision_bits);
    const std::array<Coordinates, 2> q = b(at[1], precision_bits);
    constexpr std::size_t weight = 2;
    bridge::SystemValue result;
    for (std::size_t k = 0; k < weight; ++k) {
      result.values.push_back(minor(p[0], q[0], k, weight, precision_bits));
      result.jacobian.push_back(
          {minor(p[1], q[0], k, weight, precision_bits), minor(p[0], q[1], k, weight, precision_bits)});
    }
    return result;
  };
}

bridge::System common_point_system(const bridge::BallSurface& surface, const symbolic::RationalCurve& curve,
                                   const bridge::HomogeneousParameters& parameters,
                                   std::array<std::size_t, 2> variables, std::size_t pivot) {
  std::vector<symbolic::UnivariatePolynomial> derivatives;
  for (const symbolic::UnivariatePolynomial& f : curve.coordinates()) derivatives.push_back(f.derivative());
  return [&surface, &curve, derivatives, parameters, variables, pivot](const std::vector<ComplexBall>& at,
                                                                       long precision_bits) {
    bridge::HomogeneousParameters here = parameters;
    for (std::size_t k = 0; k < 2; ++k) here[variables[k]] = at[k];
    const bridge::BallSurface::Jet jet = surface.jet_at(here, {variables[0], variables[1]}, precision_bits);
    const Coordinates& on_surface = jet.point;
    const std::vector<Coordinates>& partials = jet.derivatives;
    Coordinates on_curve;
    Coordinates tangent;
    for (std::size_t k = 0; k < 4; ++k) {
      on_curve.push_back(evaluate(curve.coordinates()[k], at[2], precision_bits));
      tangent.push_back(evaluate(derivatives[k], at[2], precision_bits));
    }
    bridge::SystemValue result;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == pivot) continue;
      result.values.push_back(minor(on_surface, on_curve, j, pivot, precision_bits));
      result.jacobian.push_back({minor(partials[0], on_curve, j, pivot, precision_bits),
                                 minor(partials[1], on_curve, j, pivot, precision_bits),
                                 minor(on_surface, tangent, j, pivot, precision_bits)});
    }
    return result;
  };
}

}  // namespace eliminant::intersect
