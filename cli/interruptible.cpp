// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/interruptible.hpp>

#include <atomic>
#include <csignal>

namespace eliminant::cli {

namespace {

// What a signal handler may touch.
std::atomic<Context*> interrupted_context{nullptr};

void cancel_computation(int signal) {
  if (Context* const context = interrupted_context.load()) context->cancel();
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruptible::Interruptible(Context& context) {
  interrupted_context = &context;
  std::signal(SIGINT, cancel_computation);
}

Interruptible::~Interruptible() { interrupted_context = nullptr; }

}  // namespace eliminant::cli
