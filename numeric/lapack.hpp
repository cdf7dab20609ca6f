// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>

// The LAPACK routines used, declared here because Debian's and Ubuntu's C interface is an optional package.
extern "C" {
/// Generalized eigenvalues and right eigenvectors of a real pencil by the QZ algorithm [MolerStewart1973].
void dggev_(const char* jobvl, const char* jobvr, const int* n, double* a, const int* lda, double* b, const int* ldb,
            double* alphar, double* alphai, double* beta, double* vl, const int* ldvl, double* vr, const int* ldvr,
            double* work, const int* lwork, int* info);
/// Eigenvalues and right eigenvectors of a real matrix, balanced, by the QR algorithm.
void dgeev_(const char* jobvl, const char* jobvr, const int* n, double* a, const int* lda, double* wr, double* wi,
            double* vl, const int* ldvl, double* vr, const int* ldvr, double* work, const int* lwork, int* info);
/// Balancing; reduction to Hessenberg form; its eigenvalues by the multishift and by the plain QR algorithm.
void dgebal_(const char* job, const int* n, double* a, const int* lda, int* ilo, int* ihi, double* scale, int* info);
void dgehrd_(const int* n, const int* ilo, const int* ihi, double* a, const int* lda, double* tau, double* work,
             const int* lwork, int* info);
void dhseqr_(const char* job, const char* compz, const int* n, const int* ilo, const int* ihi, double* h,
             const int* ldh, double* wr, double* wi, double* z, const int* ldz, double* work, const int* lwork,
             int* info);
void dlahqr_(const int* wantt, const int* wantz, const int* n, const int* ilo, const int* ihi, double* h,
             const int* ldh, double* wr, double* wi, const int* iloz, const int* ihiz, double* z, const int* ldz,
             int* info);
/// Eigenvectors of a Hessenberg matrix to chosen eigenvalues by inverse iteration; the way back through dgehrd, dgebal.
void dhsein_(const char* side, const char* eigsrc, const char* initv, int* select, const int* n, const double* h,
             const int* ldh, double* wr, const double* wi, double* vl, const int* ldvl, double* vr, const int* ldvr,
             const int* mm, int* m, double* work, int* ifaill, int* ifailr, int* info);
void dormhr_(const char* side, const char* trans, const int* m, const int* n, const int* ilo, const int* ihi,
             const double* a, const int* lda, const double* tau, double* c, const int* ldc, double* work,
             const int* lwork, int* info);
void dgebak_(const char* job, const char* side, const int* n, const int* ilo, const int* ihi, const double* scale,
             const int* m, double* v, const int* ldv, int* info);
/// Schur form of a complex matrix; reordering it, with condition numbers [BaiDemmelMcKenney1993].
void zgees_(const char* jobvs, const char* sort, int (*select)(const std::complex<double>*), const int* n,
            std::complex<double>* a, const int* lda, int* sdim, std::complex<double>* w, std::complex<double>* vs,
            const int* ldvs, std::complex<double>* work, const int* lwork, double* rwork, int* bwork, int* info);
void ztrsen_(const char* job, const char* compq, const int* select, const int* n, std::complex<double>* t,
             const int* ldt, std::complex<double>* q, const int* ldq, std::complex<double>* w, int* m, double* s,
             double* sep, std::complex<double>* work, const int* lwork, int* info);
/// LU factorisation with partial pivoting, and the solution of linear systems by it.
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda, const int* ipiv,
             double* b, const int* ldb, int* info);
/// QR factorisation, and products with its orthogonal factor.
void dgeqrf_(const int* m, const int* n, double* a, const int* lda, double* tau, double* work, const int* lwork,
             int* info);
void dormqr_(const char* side, const char* trans, const int* m, const int* n, const int* k, const double* a,
             const int* lda, const double* tau, double* c, const int* ldc, double* work, const int* lwork, int* info);
/// C <- alpha A B + beta C (BLAS).
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* b, const int* ldb, const double* beta, double* c,
            const int* ldc);
}

namespace eliminant::numeric {

/// Asks OpenBLAS, where that is the library behind LAPACK, to use the calling thread only: at the sizes met here its
/// helper threads burn processor time without being faster. A process-wide setting, so it is for programs to call.
void use_one_blas_thread();

/// Lets OpenBLAS take the working memory now that it would take at its first product, and keeps: where a limit of the
/// address space refuses that, it asks again for ever. To be called before such a limit is set.
void reserve_blas_memory();

}  // namespace eliminant::numeric
