// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/whole_curve.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/bridge/certificates/krawczyk_system.hpp>

namespace eliminant::intersect {

bool WholeCurve::is_at_infinity(const TopologyVertex& vertex) const {
  if (!are_polynomial()) return false;
  // The coefficients of the highest powers of v and s, the points for v = inf and s = inf, are parallel.
  const long n = surfaces_.first.bidegree()[1];
  const long m = surfaces_.second.bidegree()[0];
  if (n < 2 || m < 2) return false;
  const auto leading = [](const symbolic::Polynomial& p, std::size_t eliminated, long degree) {
    const auto hidden = symbolic::hide_variable(p, 1 - eliminated);
    return hidden.degree() == degree ? hidden.leading_coefficient() : symbolic::UnivariatePolynomial();
  };
  std::array<std::array<symbolic::UnivariatePolynomial, 3>, 2> points;
  for (std::size_t c = 0; c < 3; ++c) {
    // Integer coefficients: no denominators that differ.
    points[0][c] = leading(surfaces_.first.coordinates()[c], 1, n);
    points[1][c] = leading(surfaces_.second.coordinates()[c], 0, m);
  }
  const auto evaluate = [](const symbolic::UnivariatePolynomial& p, const bridge::ComplexBall& at, long precision) {
    bridge::ComplexBall result;
    for (long i = p.degree(); i >= 0; --i) {
      acb_mul(result.get(), result.get(), at.get(), precision);
      acb_add_fmpz(result.get(), result.get(), p.coefficient(i).get(), precision);
    }
    return result;
  };
  const long precision = 160;
  for (std::size_t k = 0; k < 3; ++k) {
    const bridge::System system = [&](const std::vector<bridge::ComplexBall>& at, long bits) {
      bridge::SystemValue value{{}, {}};
      for (std::size_t c = 0; c < 3; ++c) {
        if (c == k) continue;
        const auto product = [&](const auto& a, const auto& b, const auto& d, const auto& e) {
          bridge::ComplexBall first = evaluate(a, at[0], bits);
          const bridge::ComplexBall second = evaluate(b, at[1], bits);
          bridge::ComplexBall third = evaluate(d, at[0], bits);
          const bridge::ComplexBall fourth = evaluate(e, at[1], bits);
          acb_mul(first.get(), first.get(), second.get(), bits);
          acb_submul(first.get(), third.get(), fourth.get(), bits);
          return first;
        };
        const auto& [a, b] = points;
        value.values.push_back(product(a[k], b[c], a[c], b[k]));
        value.jacobian.push_back({product(a[k].derivative(), b[c], a[c].derivative(), b[k]),
                                  product(a[k], b[c].derivative(), a[c], b[k].derivative())});
      }
      return value;
    };
    const auto zero = bridge::enclose_system_zero(system, {vertex.x.ball, vertex.y.ball}, precision);
    if (!zero) continue;
    if (acb_contains_zero(evaluate(points[0][k], (*zero)[0], precision).get()) != 0) continue;
    if (acb_contains_zero(evaluate(points[1][k], (*zero)[1], precision).get()) != 0) continue;
    // The printed box holds one point with D = D_t = 0, and both sheets touch the plane at infinity here: it is that.
    const double radius = std::pow(10.0, static_cast<double>(vertex.radius_exponent));
    bool near = true;
    for (const auto& [coordinate, ball] : {std::pair(&vertex.x, &(*zero)[0]), std::pair(&vertex.y, &(*zero)[1])}) {
      bridge::ComplexBall distance;
      acb_sub(distance.get(), ball->get(), coordinate->ball.get(), precision);
      bridge::Magnitude bound;
      acb_get_mag(bound.get(), distance.get());
      near = near && mag_get_d(bound.get()) < radius / 4;
    }
    if (near) return true;
  }
  return false;
}

WholeCurve::VertexState& WholeCurve::state(std::size_t index, SurfaceResult& result) {
  const auto [place, is_new] = states_.try_emplace(index);
  VertexState& state = place->second;
  if (!is_new) return state;
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  if (vertex.kind == VertexKind::infinity) {
    state.at_infinity = are_polynomial();
    return state;
  }
  state.at_infinity = is_at_infinity(vertex);
  if (state.at_infinity) return state;
  if (vertex.milnor_number == 0) return state;
  std::array<DoubleInterval, 2> kept = arcs_.enclosure(index);
  std::array<bool, 2> inverted{};
  for (std::size_t i = 0; i < 2; ++i) {
    inverted[i] = !(arcs_.from_chart(i, false).inverse()(kept[i]).magnitude() <= 1);
    kept[i] = arcs_.from_chart(i, inverted[i]).inverse()(kept[i]);
  }
  state.lift = lifts_.above(vertex, inverted, kept);
  if (state.lift.lift == VertexLift::one_point) add_singular_point(index, state, result);
  return state;
}

void WholeCurve::add_singular_point(std::size_t index, VertexState& state, SurfaceResult& result) {
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  const FibreBox& box = *state.lift.box;
  const SpaceBox point = pair_.point(box.inverted, box.box);
  SurfaceSingularPoint singular;
  singular.at = presented({box.inverted, box.box});
  singular.half_branches = vertex.half_branches();
  singular.kind = singular.half_branches == 0   ? SurfaceSingularity::contact
                  : singular.half_branches == 2 ? SurfaceSingularity::cusp
                                                : SurfaceSingularity::crossing;
  for (const DoubleInterval& side : box.box) singular.radius = std::max(singular.radius, width(side));
  bool finite = true;
  for (const DoubleInterval& x : point) {
    finite = finite && x.is_finite();
    singular.radius = std::max(singular.radius, width(x));
  }
  if (!finite) {
    state.lift.lift = VertexLift::undecided;
    doubt(result, "whether a singular point lies at infinity is not proven");
    return;
  }
  singular.certified = vertex.certified;
  if (!singular.certified) singular.reason = "the singular point of the projection is not proven";
  // Of one surface a point shows twice, with both preimages exchanged.
  const auto is_same = [&](const SurfaceSingularPoint& other) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double a = singular.at.parameters[i];
      const double b = other.at.parameters[(i + 2) % 4];
      if (a != b && !(std::fabs(a - b) <= 2 * (singular.radius + other.radius) * (1 + std::fabs(a)))) return false;
    }
    return true;
  };
  if (surfaces_.with_itself)
    for (std::size_t k = 0; k < result.singular_points.size(); ++k)
      if (result.singular_points[k].kind == singular.kind && is_same(result.singular_points[k])) {
        state.singular_point = k;
        state.repeats = true;
        return;
      }
  state.singular_point = result.singular_points.size();
  result.singular_points.push_back(std::move(singular));
}

void WholeCurve::finish_vertices(SurfaceResult& result) {
  const TopologyResult& topology = arcs_.topology();
  for (std::size_t k = 0; k < topology.vertices.size(); ++k) {
    const TopologyVertex& vertex = topology.vertices[k];
    if (vertex.kind == VertexKind::infinity || vertex.milnor_number == 0) continue;
    VertexState& found = state(k, result);
    const std::string place = "(" + vertex.x.real + ", " + vertex.y.real + ")";
    if (found.at_infinity) {
      ++result.counts.excluded;
    } else if (found.singular_point) {
      if (vertex.half_branches() == 0 && !found.repeats) {
        SurfaceComponent component;
        component.kind = SurfaceComponentKind::point;
        component.points = {result.singular_points[*found.singular_point].at};
        component.start.kind = component.end.kind = BranchEndKind::singular;
        component.start.singular_point = component.end.singular_point = found.singular_point;
        component.error = result.singular_points[*found.singular_point].radius;
        component.tangential = true;
        component.certified = result.singular_points[*found.singular_point].certified;
        result.components.push_back(std::move(component));
      }
      if (found.branches != vertex.half_branches()) {
        doubt(result, "not all branches at the singular point above " + place + " were followed to it");
      }
    } else if (found.lift.lift == VertexLift::complex && vertex.half_branches() == 0) {
      ++result.counts.excluded;
    } else if (found.lift.lift != VertexLift::branches || found.branches != 0) {
      doubt(result, "what lies above the point " + place + " of the projection is not proven");
    }
  }
}

BranchEnd WholeCurve::branch_end(const Branch& branch, std::size_t which, SurfaceResult& result, std::string& reason) {
  BranchEnd found;
  if (branch.pinch_points[which]) {
    found.kind = BranchEndKind::singular;
    found.singular_point = branch.pinch_points[which];
    return found;
  }
  found.kind = BranchEndKind::unknown;
  const std::optional<ArcEnd>& end = branch.ends[which];
  if (end) {
    const std::size_t vertex = arcs_.arcs()[end->arc].ends[end->end];
    const VertexState& there = state(vertex, result);
    if (there.at_infinity) {
      found.kind = BranchEndKind::infinity;
      return found;
    }
    if (there.singular_point) {
      found.kind = BranchEndKind::singular;
      found.singular_point = there.singular_point;
      return found;
    }
  }
  reason = "the branch could not be followed beyond one of its ends";
  doubt(result, "a branch could not be followed to its end");
  return found;
}

}  // namespace eliminant::intersect
