// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

/// The solvers that are compared. Each takes two curves and gives a run that may be repeated: the polynomials are in
/// the solver's own form before it begins, and no run uses what an earlier one computed.
namespace eliminant::comparisons {

/// One term of a polynomial in Z[x, y]; plain, as the headers of the solvers cannot be included together.
struct Term {
  std::string coefficient;
  unsigned long exponent_x = 0;
  unsigned long exponent_y = 0;
};

struct Curves {
  std::vector<Term> p;
  std::vector<Term> q;
};

struct RunOutcome {
  long found = 0;         ///< distinct solutions; for PARI values of x
  bool complete = false;  ///< all that the solver is asked for came, as its declaration below says
};

using Run = std::function<RunOutcome()>;

/// All complex solutions with multiplicities, 15 digits; complete when `certified`.
Run eliminant_complex(const Curves& curves);
/// The real ones of them, complete when `certified`.
Run eliminant_real(const Curves& curves);

/// Algebraic_kernel_d_2 over Gmpz: all real solutions, isolated but without digits; complete when each has a
/// multiplicity.
Run cgal_real(const Curves& curves);

/// polresultant by y, polroots of it at 38 digits: x of all complex solutions, with multiplicity; neither y nor proof.
Run pari_complex(const Curves& curves);
/// polresultant by y, polrootsreal of it at 38 digits: its real zeros, once each; no y. Such a zero can belong to
/// solutions that are not real, or lie at infinity.
Run pari_real(const Curves& curves);

/// Name and version.
std::string cgal_version();
std::string pari_version();

}  // namespace eliminant::comparisons
