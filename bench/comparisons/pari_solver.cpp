// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <string>
#include <vector>

#include <pari/pari.h>

#include "solvers.hpp"

namespace eliminant::comparisons {

namespace {

constexpr long wanted_digits = 38;

/// Once in the process: one thread, and a stack that may grow to 4 GB.
void start_pari() {
  static const bool started = [] {
    constexpr std::size_t stack_bytes = std::size_t{64} << 20U;
    constexpr std::size_t largest_stack_bytes = std::size_t{4} << 30U;
    pari_init(stack_bytes, 0);
    paristack_setsize(stack_bytes, largest_stack_bytes);
    setdefault("nbthreads", "1", d_SILENT);
    return true;
  }();
  static_cast<void>(started);
}

GEN pari_polynomial(const std::vector<Term>& polynomial) {
  std::string text = "0*x*y";
  for (const Term& term : polynomial)
    text +=
        "+(" + term.coefficient + ")*x^" + std::to_string(term.exponent_x) + "*y^" + std::to_string(term.exponent_y);
  return gclone(gp_read_str(text.c_str()));
}

Run resultant_roots(const Curves& curves, GEN (*roots_of)(GEN, long)) {
  start_pari();
  return [p = pari_polynomial(curves.p), q = pari_polynomial(curves.q), roots_of] {
    const pari_sp before = avma;
    const GEN resultant = polresultant0(p, q, fetch_user_var("y"), 0);
    const GEN found = roots_of(resultant, ndec2prec(wanted_digits));
    const RunOutcome outcome{glength(found), true};
    set_avma(before);
    return outcome;
  };
}

}  // namespace

Run pari_complex(const Curves& curves) { return resultant_roots(curves, roots); }

Run pari_real(const Curves& curves) {
  return resultant_roots(curves,
                         [](GEN resultant, long precision) { return realroots(resultant, nullptr, precision); });
}

std::string pari_version() {
  constexpr long digits_of_part = 8;
  const auto code = static_cast<unsigned long>(paricfg_version_code);
  const auto part = [&](unsigned index) {
    return std::to_string((code >> (index * digits_of_part)) & ((1UL << digits_of_part) - 1));
  };
  return "PARI " + part(2) + "." + part(1) + "." + part(0);
}

}  // namespace eliminant::comparisons
