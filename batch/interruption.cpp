// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/interruption.hpp>

#include <csignal>

namespace eliminant::batch {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

// Without SA_RESTART: poll() is to end at once.
void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
  interrupted = 0;
  handle(SIGINT, interrupt);
  handle(SIGTERM, interrupt);
  handle(SIGXFSZ, SIG_IGN);
}

Interruption::~Interruption() {
  handle(SIGINT, SIG_DFL);
  handle(SIGTERM, SIG_DFL);
}

bool Interruption::requested() const { return interrupted != 0; }

}  // namespace eliminant::batch
