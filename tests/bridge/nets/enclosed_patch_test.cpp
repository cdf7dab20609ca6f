// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/exact_jets.hpp>

#include <eliminant/bridge/nets/enclosed_patch.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

ContactFrame plain_frame() {
  ContactFrame frame;
  for (std::size_t k = 0; k < 3; ++k) frame.columns[k][static_cast<long>(k)] = 1;
  return frame;
}

bool holds(const DoubleInterval& interval, double value) { return interval.lower <= value && value <= interval.upper; }

const std::vector<PatchText> patches{
    {"u + u*v", "v^2 - u/3", "u^2 - 3*u*v + v/7"},
    {"1 - u^2", "2*u", "v*(1 + u^2)", "1 + u^2"},
    {"u^2 + v", "u*v^3 - 5", "2*v^2 - u^3", "3 + u - u*v^2/2"},
};

}  // namespace

TEST_CASE("Enclosed patch: values and derivatives of every point of the box are enclosed, also with weights") {
  for (const PatchText& text : patches) {
    CAPTURE(text.z);
    const ExactNet net = patch_net(text);
    // From 1/4 to 1/2, and from 5/8 to 1.
    const EnclosedPatch patch(taylor_on_box(in_doubles(net), plain_frame(), {{0.25, 0.625, 0}, {0.5, 1, 0}}, 0, 2));
    for (long i = 0; i <= 6; ++i)
      for (long j = 0; j <= 6; ++j) {
        const ExactJet exact(net, ratio(1, 4) + ratio(i, 24), ratio(5, 8) + ratio(j, 16));
        for (std::size_t k = 0; k < 3; ++k) {
          CHECK(holds(patch.value[k], exact.derivative(0, 0, k)));
          for (std::size_t q = 0; q < 2; ++q) CHECK(holds(patch.first[q][k], exact.derivative(1 - q, q, k)));
          for (std::size_t q = 0; q < 3; ++q) CHECK(holds(patch.second[q][k], exact.derivative(2 - q, q, k)));
        }
      }
  }
}

TEST_CASE("Enclosed patch: enclosures narrow with the box") {
  for (const PatchText& text : patches) {
    CAPTURE(text.z);
    const ControlNet net = in_doubles(patch_net(text));
    for (const double half : {0x1p-6, 0x1p-10, 0x1p-14}) {
      const EnclosedPatch patch(
          taylor_on_box(net, plain_frame(), {{0.5 - half, 0.25 - half, 0}, {0.5 + half, 0.25 + half, 0}}, 0, 2));
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(patch.value[k].upper - patch.value[k].lower < 100 * half);
        for (const auto& first : patch.first) CHECK(first[k].upper - first[k].lower < 100 * half);
        for (const auto& second : patch.second) CHECK(second[k].upper - second[k].lower < 400 * half);
      }
    }
  }
}
