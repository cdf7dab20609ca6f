// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The LAPACK routines used, declared here because Debian's and Ubuntu's C interface is an optional package.
extern "C" {
/// Generalized eigenvalues and right eigenvectors of a real pencil by the QZ algorithm [MolerStewart1973].
void dggev_(const char* jobvl, const char* jobvr, const int* n, double* a, const int* lda, double* b, const int* ldb,
            double* alphar, double* alphai, double* beta, double* vl, const int* ldvl, double* vr, const int* ldvr,
            double* work, const int* lwork, int* info);
/// Eigenvalues and right eigenvectors of a real matrix, balanced, by the QR algorithm.
void dgeev_(const char* jobvl, const char* jobvr, const int* n, double* a, const int* lda, double* wr, double* wi,
            double* vl, const int* ldvl, double* vr, const int* ldvr, double* work, const int* lwork, int* info);
/// LU factorisation with partial pivoting.
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
}

namespace eliminant::numeric {

/// Asks OpenBLAS, where that is the library behind LAPACK, to use the calling thread only: at the sizes met here its
/// helper threads burn processor time without being faster. A process-wide setting, so it is for programs to call.
void use_one_blas_thread();

}  // namespace eliminant::numeric
