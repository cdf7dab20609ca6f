// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/child_process.hpp>

#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <eliminant/io/results/error_report.hpp>

namespace eliminant::batch {

namespace {

void end_with_parent([[maybe_unused]] pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The parent may have ended before the request.
  if (getppid() != parent) std::_Exit(1);
#endif
}

[[noreturn]] void run_child(pid_t parent, int socket, const std::function<void()>& before_body,
                            const std::function<void(Channel&)>& body) {
  end_with_parent(parent);
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  // What the parent does about errors of its own is not for the child.
  for (const int signal : {SIGALRM, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) std::signal(signal, SIG_DFL);
  int status = 0;
  try {
    before_body();
    Channel channel(socket);
    body(channel);
  } catch (...) {
    status = 1;
  }
  // Without the destructors and buffers of the parent.
  std::_Exit(status);
}

}  // namespace

std::string in_words(const Death& death) {
  if (death.signal == 0) return "with exit status " + std::to_string(death.exit_status);
  return "by signal " + std::to_string(death.signal) + " (" + strsignal(death.signal) + ")";
}

ChildProcess::ChildProcess(const std::function<void()>& before_body, const std::function<void(Channel&)>& body) {
  const std::array<int, 2> ends = connected_sockets();
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    run_child(parent, ends[1], before_body, body);
  }
  const int error = errno;
  close(ends[1]);
  channel_ = std::make_unique<Channel>(ends[0]);
  if (process_ < 0) throw io::OutputError("cannot start a worker process: " + std::string(std::strerror(error)));
}

ChildProcess::~ChildProcess() {
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
}

Death ChildProcess::wait_for_death() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  if (WIFSIGNALED(status)) return {WTERMSIG(status), 0};
  return {0, WEXITSTATUS(status)};
}

}  // namespace eliminant::batch
