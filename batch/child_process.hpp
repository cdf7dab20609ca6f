// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <functional>
#include <memory>
#include <string>

#include <eliminant/batch/channel.hpp>

namespace eliminant::batch {

/// How a process ended.
struct Death {
  /// The signal that ended it, or 0.
  int signal = 0;
  int exit_status = 0;
};

/// "by signal 11 (Segmentation fault)" or "with exit status 1".
std::string in_words(const Death& death);

/// A process forked from this one, with a connection to it. It ends when this one ends, however that happens: it is
/// killed with its parent where the system can do that (Linux), and everywhere its connection is closed.
class ChildProcess {
 public:
  /// Runs `body` in the child, which ends when that returns. The child holds none of the connections of `before_body`'s
  /// owner: that is called first, and should close what the child is not to keep open. SIGINT and SIGTERM are left to
  /// the parent. To be called while no other thread runs. Throws io::OutputError when there can be no more processes.
  ChildProcess(const std::function<void()>& before_body, const std::function<void(Channel&)>& body);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Kills it, and waits for its end.
  ~ChildProcess();

  Channel& channel() { return *channel_; }
  /// Waits for its end, which has come or is about to.
  Death wait_for_death();

 private:
  pid_t process_ = -1;
  std::unique_ptr<Channel> channel_;
};

}  // namespace eliminant::batch
