// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>

namespace eliminant::cli {

/// While this object lives, the first Ctrl-C cancels `context`; the second one ends the process in the usual way.
class Interruptible {
 public:
  explicit Interruptible(Context& context);
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible();
};

}  // namespace eliminant::cli
