// SPDX-License-Identifier: BSD-3-Clause
#include <support/bezier_families.hpp>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <support/bezier_contacts.hpp>

namespace eliminant::test {

namespace {

class Collection {
 public:
  explicit Collection(std::string only) : only_(std::move(only)) {}

  /// `make` draws one case; the numbers of a family do not depend on the others.
  void add(const std::string& family, unsigned long count, const std::function<BezierCase(Random&)>& make) {
    if (!only_.empty() && only_ != family) return;
    std::uint64_t seed = 2026;
    for (const char letter : family) seed = 31 * seed + static_cast<unsigned char>(letter);
    Random random(seed);
    for (unsigned long index = 0; index < count; ++index) {
      cases_.push_back(make(random));
      cases_.back().family = family;
      cases_.back().index = index;
    }
  }

  std::vector<BezierCase> take() { return std::move(cases_); }

 private:
  std::string only_;
  std::vector<BezierCase> cases_;
};

constexpr std::array<long, 3> push_exponents{13, 20, 27};

/// Six of each contact: three distances to both sides.
void add_pushed(Collection& all, const std::string& family, unsigned long contacts, bool plane,
                const std::function<Contact(Random&)>& make) {
  std::optional<Contact> contact;
  unsigned long step = 0;
  all.add(family, contacts * 2 * push_exponents.size(), [&, plane](Random& random) {
    if (step % (2 * push_exponents.size()) == 0) contact = make(random);
    const unsigned long which = step++ % (2 * push_exponents.size());
    return pushed_off(family, *contact, plane, push_exponents[which / 2], which % 2 == 0);
  });
}

void add_general(Collection& all) {
  const auto across = [&](const std::string& family, unsigned long count, std::size_t degree, std::size_t bidegree,
                          bool rational) {
    all.add(family, count, [=](Random& random) {
      Drawing drawing{random, 1024, rational, false};
      const RationalPolygon curve = drawing.polygon(degree);
      return binary_case({}, curve, drawing.net(bidegree, bidegree));
    });
  };
  across("segment x bicubic", 50, 1, 3, false);
  across("cubic x bicubic", 50, 3, 3, false);
  across("rational cubic x rational bicubic", 40, 3, 3, true);
  across("degree 8 x bidegree (5,5)", 20, 8, 5, false);
}

void add_borders(Collection& all) {
  // A cubic moved so that it meets S(u, v) at t0.
  const auto through = [](Random& random, const std::function<std::vector<Rational>(Random&)>& on_patch,
                          const std::function<Rational(Random&)>& on_curve) {
    Drawing drawing{random, 256, false, false};
    const RationalNet net = drawing.net(3, 3);
    const Rational t0 = on_curve(random);
    const RationalPolygon curve = moved_through(drawing.polygon(3), t0, values(homogeneous_map(net), on_patch(random)));
    BezierCase result = binary_case({}, curve, net);
    result.planted.push_back(planted_at(t0, 1));
    return result;
  };
  const auto corner = [](Random& random) {
    return std::vector<Rational>{Rational(random.between(0, 1)), Rational(random.between(0, 1))};
  };
  const auto border = [](Random& random) {
    std::vector<Rational> point{eighth(random), Rational(random.between(0, 1))};
    if (random.between(0, 1) == 0) std::swap(point[0], point[1]);
    return point;
  };
  const auto inner = [](Random& random) { return std::vector<Rational>{eighth(random), eighth(random)}; };
  const auto end = [](Random& random) { return Rational(random.between(0, 1)); };
  all.add("through a corner", 12, [&](Random& random) { return through(random, corner, eighth); });
  all.add("through a border", 12, [&](Random& random) { return through(random, border, eighth); });
  all.add("ending on a border", 12, [&](Random& random) { return through(random, border, end); });
  all.add("ending in a corner", 8, [&](Random& random) { return through(random, corner, end); });
  all.add("ending on the patch", 20, [&](Random& random) { return through(random, inner, end); });
}

void add_contained(Collection& all) {
  // S(line): most lines stay in the domain, some enter it at 1/4 and leave it at 3/4.
  const auto image = [](Random& random, bool rational, const std::vector<Polynomial>& path, std::size_t degree,
                        bool leaves) {
    Drawing drawing{random, 64, rational, false};
    const RationalNet net = drawing.net(3, 3);
    BezierCase result = binary_case({}, control_polygon(composed(homogeneous_map(net), path), degree), net);
    result.overlap = leaves ? std::array{0.25, 0.75} : std::array{0.0, 1.0};
    return result;
  };
  const Polynomial leaving = in_t({fraction(-1, 2), Rational(2)});
  unsigned long turn = 0;
  all.add("along a border", 12, [&](Random& random) {
    const bool leaves = ++turn % 3 == 0;
    std::vector<Polynomial> path{leaves ? leaving : t_power(1), Polynomial::constant(1, random.between(0, 1))};
    if (turn % 2 == 0) std::swap(path[0], path[1]);
    return image(random, turn % 4 == 0, path, 3, leaves);
  });
  all.add("on the patch", 15, [&](Random& random) {
    const bool leaves = ++turn % 3 == 0;
    const Rational v0 = eighth(random);
    const Rational v1 = eighth(random);
    std::vector<Polynomial> path{leaves ? leaving : in_t({fraction(1, 8), fraction(3, 4)}), in_t({v0, v1 - v0})};
    if (turn % 2 == 0) std::swap(path[0], path[1]);
    return image(random, turn % 4 == 0, path, 6, leaves);
  });
}

void add_contacts(Collection& all) {
  const auto drawing = [](Random& random, long resolution, bool rational, bool plane) {
    return Drawing{random, resolution, rational, plane};
  };
  std::size_t turn = 0;
  const auto next = [&]() -> const Quadratic& { return quadratics[turn++ % quadratics.size()]; };
  const std::string order_2 = "contact of order 2";
  const std::string order_3 = "contact of order 3";
  all.add(order_2, 17,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), 2), false); });
  all.add(order_3, 17,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), 3), false); });
  for (const unsigned long order : {2UL, 3UL}) {
    const std::string of_order = "contact of order " + std::to_string(order);
    all.add(of_order + " on a border", 8, [&](Random& r) {
      return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), order, Place::border), false);
    });
    all.add(of_order + " at an end", 8, [&](Random& r) {
      return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), order, Place::end), false);
    });
  }
  all.add("rational contact of order 2", 8,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 64, true, false), 2), false); });
  all.add("rational contact of order 3", 8,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 64, true, false), 3), false); });
  all.add("irrational contact of order 2", 20,
          [&](Random& r) { return case_of({}, contact_at_root(drawing(r, 64, false, false), next(), 2), false); });
  all.add("irrational contact of order 3", 18,
          [&](Random& r) { return case_of({}, flat_contact_at_root(drawing(r, 64, false, false), next()), false); });
  all.add("irrational contact of order 3, quintic", 6,
          [&](Random& r) { return case_of({}, contact_at_root(drawing(r, 64, false, false), next(), 3), false); });
  add_pushed(all, "pushed contact of order 2", 4, false,
             [&](Random& r) { return contact_at_dyadic(drawing(r, 256, false, false), 2); });
  add_pushed(all, "pushed contact of order 3", 4, false,
             [&](Random& r) { return contact_at_dyadic(drawing(r, 256, false, false), 3); });
  add_pushed(all, "pushed irrational contact of order 2", 3, false,
             [&](Random& r) { return contact_at_root(drawing(r, 64, false, false), next(), 2); });
  add_pushed(all, "pushed irrational contact of order 3", 2, false,
             [&](Random& r) { return flat_contact_at_root(drawing(r, 64, false, false), next()); });
}

void add_plane(Collection& all) {
  const auto pairs = [&](const std::string& family, unsigned long count, std::size_t degree, bool rational) {
    all.add(family, count, [=](Random& random) {
      Drawing drawing{random, 1024, rational, true};
      const RationalPolygon first = drawing.polygon(degree);
      return plane_case({}, first, drawing.polygon(degree));
    });
  };
  pairs("plane cubic x cubic", 60, 3, false);
  pairs("plane rational cubic x cubic", 20, 3, true);
  pairs("plane degree 8 x 8", 30, 8, false);

  std::size_t turn = 0;
  const auto next = [&]() -> const Quadratic& { return quadratics[turn++ % quadratics.size()]; };
  const auto drawing = [](Random& random) { return Drawing{random, 64, false, true}; };
  for (const unsigned long order : {2UL, 3UL}) {
    const std::string of_order = "contact of order " + std::to_string(order);
    all.add("plane " + of_order, 12,
            [&](Random& r) { return case_of({}, plane_contact_at_dyadic(drawing(r), order, 3), true); });
    all.add("plane " + of_order + ", degree 8", 4,
            [&](Random& r) { return case_of({}, plane_contact_at_dyadic(drawing(r), order, 8), true); });
    all.add("plane irrational " + of_order, 10,
            [&](Random& r) { return case_of({}, plane_contact_at_root(drawing(r), next(), order), true); });
    add_pushed(all, "plane pushed " + of_order, 4, true,
               [&](Random& r) { return plane_contact_at_dyadic(drawing(r), order, 3); });
    add_pushed(all, "plane pushed irrational " + of_order, 2, true,
               [&](Random& r) { return plane_contact_at_root(drawing(r), next(), order); });
  }

  all.add("plane common end point", 20, [&](Random& random) {
    Drawing drawing{random, 1024, random.between(0, 2) == 0, true};
    RationalPolygon first = drawing.polygon(3);
    RationalPolygon second = drawing.polygon(3);
    const bool tangent = random.between(0, 3) == 0;
    second.front() = first.front();
    if (tangent) second[1] = first[1];
    if (random.between(0, 1) == 0) std::reverse(second.begin(), second.end());
    const bool at_end = random.between(0, 1) == 0;
    if (at_end) std::reverse(first.begin(), first.end());
    BezierCase result = plane_case({}, first, second);
    result.planted.push_back(planted_at(at_end ? 1 : 0, tangent ? 2 : 1));
    return result;
  });
  // The first is the arc of the second from 1/4 to 5/4, or from 1/4 to 3/4.
  all.add("plane common arc", 10, [&](Random& random) {
    Drawing drawing{random, 256, random.between(0, 1) == 0, true};
    const RationalPolygon second = drawing.wave(3);
    const bool leaves = random.between(0, 1) == 0;
    const Polynomial arc = in_t({fraction(1, 4), leaves ? Rational(1) : fraction(1, 2)});
    BezierCase result = plane_case({}, control_polygon(composed(curve_map(second), {arc}), 3), second);
    result.overlap = {0, leaves ? 0.75 : 1};
    return result;
  });
}

std::vector<BezierCase> collected(const std::string& only) {
  Collection all(only);
  add_general(all);
  add_borders(all);
  add_contained(all);
  add_contacts(all);
  add_plane(all);
  return all.take();
}

/// [x, y, z, w] with the weight apart.
std::string point_text(const HomogeneousPoint& point) {
  const Rational weight = exact_rational(point.back());
  std::string result = "[";
  for (std::size_t k = 0; k + 1 < coordinates; ++k)
    result += '"' + (exact_rational(point[k]) / weight).to_string() + "\", ";
  return result + '"' + weight.to_string() + "\"]";
}

std::string polygon_text(const ControlPolygon& polygon) {
  std::string result = "[";
  for (const HomogeneousPoint& point : polygon) result += (result.size() > 1 ? ", " : "") + point_text(point);
  return result + "]";
}

std::string curve_text(const ControlPolygon& polygon) {
  return "{\"bezier\": {\"degree\": " + std::to_string(polygon.size() - 1) +
         ", \"control_points\": " + polygon_text(polygon) + "}}";
}

}  // namespace

std::vector<BezierCase> bezier_cases() { return collected({}); }

std::vector<BezierCase> bezier_cases(const std::string& family) { return collected(family); }

BezierCase reversed(BezierCase bezier) {
  std::reverse(bezier.curve.begin(), bezier.curve.end());
  for (PlantedParameter& planted : bezier.planted) {
    // p(1 - t), by Horner's rule.
    std::vector<long> turned;
    for (auto coefficient = planted.polynomial.rbegin(); coefficient != planted.polynomial.rend(); ++coefficient) {
      // Times 1 - t, plus the coefficient.
      turned.push_back(0);
      for (std::size_t i = turned.size(); i-- > 1;) turned[i] -= turned[i - 1];
      turned[0] += *coefficient;
    }
    planted.polynomial = turned;
    planted.approximation = 1 - planted.approximation;
  }
  if (bezier.overlap) bezier.overlap = std::array{1 - (*bezier.overlap)[1], 1 - (*bezier.overlap)[0]};
  if (bezier.pushed) bezier.pushed->parameter = 1 - bezier.pushed->parameter;
  return bezier;
}

BezierCase second_reversed(BezierCase bezier) {
  std::reverse(bezier.patch.begin(), bezier.patch.end());
  std::reverse(bezier.second.begin(), bezier.second.end());
  return bezier;
}

BezierCase swapped(BezierCase bezier) {
  std::swap(bezier.curve, bezier.second);
  bezier.planted.clear();
  bezier.overlap.reset();
  bezier.pushed.reset();
  return bezier;
}

std::string problem_json(const BezierCase& bezier) {
  if (bezier.in_plane())
    return "{\"problem\": \"curve_curve\", \"first\": " + curve_text(bezier.curve) +
           ", \"second\": " + curve_text(bezier.second) + "}\n";
  std::string rows = "[";
  for (const ControlPolygon& row : bezier.patch) rows += (rows.size() > 1 ? ", " : "") + polygon_text(row);
  return "{\"problem\": \"curve_surface\", \"curve\": " + curve_text(bezier.curve) +
         ", \"surface\": {\"bezier\": {\"degree\": [" + std::to_string(bezier.patch.size() - 1) + ", " +
         std::to_string(bezier.patch.front().size() - 1) + "], \"control_points\": " + rows + "]}}}\n";
}

}  // namespace eliminant::test
