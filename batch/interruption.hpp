// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace eliminant::batch {

/// While this object lives, SIGINT and SIGTERM end no process but are noted; the second one ends it in the usual way. A
/// file that grows too large (SIGXFSZ) becomes an error of writing.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
  bool requested() const;
};

}  // namespace eliminant::batch
