// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/height_series.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;
using symbolic::Rational;

namespace {

const std::array<Rational, 2> at{ratio(1, 2), ratio(1, 3)};

PlaneSeries<Rational> heights(const PatchText& first, const PatchText& second, bool polynomial) {
  return height_series(taylor_at(patch_net(first), at, 4), taylor_at(patch_net(second), at, 4), 4, polynomial).height;
}

}  // namespace

TEST_CASE("Height series: of two graphs it is the difference, term by term") {
  const PlaneSeries<Rational> h = heights(
      {"u", "v", "u*v"}, {"u", "v", "u*v - 3*(u - 1/2)^2 + 5*(u - 1/2)*(v - 1/3)^2 - 7*(u - 1/2)^3*(v - 1/3)"}, true);
  for (std::size_t i = 0; i <= 4; ++i)
    for (std::size_t j = 0; i + j <= 4; ++j) {
      CAPTURE(i);
      CAPTURE(j);
      const long expected = i == 2 && j == 0 ? 3 : i == 1 && j == 2 ? -5 : i == 3 && j == 1 ? 7 : 0;
      CHECK(h.at(i, j) == Rational(expected));
    }
}

TEST_CASE("Height series: the second patch is followed in its own parameters") {
  // The same graph in parameters p, q with x = p + p^2 - q^2 and so on: no difference at all.
  const std::string x = "(1/2 + (u - 1/2) + (u - 1/2)^2 - (v - 1/3)^2)";
  const std::string y = "(1/3 + 2*(v - 1/3) - (u - 1/2)*(v - 1/3))";
  const PatchText second{x, y, x + "*" + y};
  const PlaneSeries<Rational> zero = heights({"u", "v", "u*v"}, second, true);
  const PlaneSeries<Rational> crosswise = heights({"u", "v", "u*v"}, second, false);
  for (std::size_t i = 0; i <= 4; ++i)
    for (std::size_t j = 0; i + j <= 4; ++j) {
      CHECK(zero.at(i, j).is_zero());
      CHECK(crosswise.at(i, j).is_zero());
    }
}

TEST_CASE("Height series: along every line it is the contact series, of rational patches") {
  const PatchText first{"u", "v", "u*v", "1 + u"};
  const PatchText second{"u + (u - 1/2)^2", "v", "u*v + (v - 1/3)^3 - u*(u - 1/2)*(v - 1/3)",
                         "1 + u - 2*(u - 1/2)*(v - 1/3)"};
  const TaylorTable<Rational> a = taylor_at(patch_net(first), at, 4);
  const TaylorTable<Rational> b = taylor_at(patch_net(second), at, 4);
  const PlaneSeries<Rational> h = height_series(a, b, 4, false).height;
  for (const auto& [p, q] : {std::pair{Rational(1), Rational(0)}, std::pair{Rational(2), Rational(-3)}}) {
    TaylorTable<Rational> line(1, 4);
    const auto power = [](const Rational& x, std::size_t n) {
      Rational result(1);
      for (std::size_t k = 0; k < n; ++k) result = result * x;
      return result;
    };
    for (std::size_t i = 0; i <= 4; ++i)
      for (std::size_t j = 0; i + j <= 4; ++j)
        for (std::size_t k = 0; k < 4; ++k)
          line.at(i + j)[k] = line.at(i + j)[k] + a.at(i, j)[k] * power(p, i) * power(q, j);
    const ContactSeries<Rational> expected = contact_series(line, b, 2);
    for (std::size_t n = 1; n <= 4; ++n) {
      Rational sum(0);
      for (std::size_t j = 0; j <= n; ++j) sum = sum + h.at(n - j, j) * power(p, n - j) * power(q, j);
      CHECK(sum == expected.difference[n]);
    }
  }
}
