// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <support/patch_case.hpp>

namespace eliminant::test {

/// All generated pairs, family after family, the same ones at every run. Most are z = f(x, y) and z = f - F over
/// rectangles, moved by a map of space, so that their intersection is the plane curve F = 0, with F planted; where the
/// first patch is a general one F is composed with it.
std::vector<PatchCase> patch_cases();

/// Those of one family; all where the name is empty.
std::vector<PatchCase> patch_cases(const std::string& family);

/// The other patch first.
PatchCase exchanged(PatchCase patches);

}  // namespace eliminant::test
