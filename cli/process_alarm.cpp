// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/process_alarm.hpp>

#include <sys/time.h>

#include <algorithm>
#include <cmath>

namespace eliminant::cli {

namespace {

void set_alarm(double seconds) {
  // A limit of years is none, and must not overflow the clock; one of 0 would be none, too.
  const double limited = std::clamp(seconds, 1e-3, 1e8);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(std::floor(limited));
  timer.it_value.tv_usec = static_cast<suseconds_t>((limited - std::floor(limited)) * 1e6);
  setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

double hard_limit(double seconds) { return seconds + std::max(0.5, 0.1 * seconds); }

ProcessAlarm::ProcessAlarm(double seconds) { set_alarm(seconds); }

ProcessAlarm::~ProcessAlarm() {
  const itimerval none{};
  setitimer(ITIMER_REAL, &none, nullptr);
}

}  // namespace eliminant::cli
