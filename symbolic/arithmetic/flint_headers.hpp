// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The one place where the two supported FLINT families differ: FLINT 2.9 with Arb 2.23 as a library of its own
// (headers <arb.h>), and FLINT 3, which contains Arb (headers <flint/arb.h>). FLINT 3 declares its conversions to MPFR,
// which bridge/ needs, only where <mpfr.h> came first.
#include <mpfr.h>

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mpoly.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <flint/fmpz_poly_mat.h>
#include <flint/fmpz_vec.h>
#include <flint/nmod.h>
#include <flint/nmod_mat.h>
#include <flint/nmod_poly.h>
#include <flint/nmod_vec.h>
#include <flint/ulong_extras.h>
#if __has_include(<flint/nmod_poly_factor.h>)
#include <flint/nmod_poly_factor.h>
#endif
#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/acb_mat.h>
#include <flint/acb_poly.h>
#include <flint/arb.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/arb_poly.h>
#else
#include <acb.h>
#include <acb_mat.h>
#include <acb_poly.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
#include <arb_poly.h>
#endif
