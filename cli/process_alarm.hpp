// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace eliminant::cli {

/// How long a computation may go on beyond its time limit, in seconds, before it is ended from outside: stages end by
/// themselves at their next look at the clock.
double hard_limit(double seconds);

/// Lets SIGALRM end this process when the object has not been destroyed after some seconds: the time limit of a worker
/// process, also within calls that never come back. A later one takes the place of an earlier one.
class ProcessAlarm {
 public:
  explicit ProcessAlarm(double seconds);
  ProcessAlarm(const ProcessAlarm&) = delete;
  ProcessAlarm& operator=(const ProcessAlarm&) = delete;
  ~ProcessAlarm();
};

}  // namespace eliminant::cli
