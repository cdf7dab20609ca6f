// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/run_batch.hpp>

#include <poll.h>

#include <cstdio>
#include <vector>

#include <eliminant/batch/interruption.hpp>

namespace eliminant::batch {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void say(const std::string& line) { std::fprintf(stderr, "eliminant: %s\n", line.c_str()); }

std::string counted(std::uint64_t number, const char* what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

}  // namespace

void BatchReport::begin(const BatchJob& job) const {
  if (!settings_.quiet && job.resumed() > 0) say("resuming after " + counted(job.resumed(), "result"));
}

void BatchReport::update(const BatchJob& job) {
  if (!settings_.progress || seconds_since(last_) < 1) return;
  last_ = std::chrono::steady_clock::now();
  say_progress(job);
}

void BatchReport::say_progress(const BatchJob& job) const {
  const double elapsed = seconds_since(begin_);
  const double rate = static_cast<double>(job.written() - job.resumed()) / elapsed;
  char text[64];
  std::snprintf(text, sizeof text, "%.1f s, %.*f per second", elapsed, rate < 10 ? 2 : 0, rate);
  say(counted(job.written(), "result") + " in " + text);
}

int BatchReport::end(const BatchJob& job, bool interrupted) const {
  if (settings_.progress) say_progress(job);
  if (settings_.progress && job.errors() > 0) say(counted(job.errors(), "error"));
  if (interrupted) {
    say("interrupted after " + counted(job.written(), "result") +
        (settings_.output ? "; --resume continues after them" : ""));
    return 3;
  }
  if (!settings_.quiet && job.incomplete() > 0)
    say("warning: a limit ended " + counted(job.incomplete(), "problem") + ": status incomplete");
  return job.incomplete() > 0 ? 3 : 0;
}

int run_batch(const BatchSettings& settings, const Solver& solver) {
  const Interruption interruption;
  // The workers come first: they hold neither input nor output.
  WorkerPool pool(settings.workers, solver);
  LineReader lines(settings.input, settings.shard);
  ResultFile output(settings.output, settings.resume, settings.description);
  BatchJob job(lines, output, too_long_result);
  BatchReport report(settings);
  report.begin(job);
  while (!interruption.requested()) {
    while (pool.has_idle_worker()) {
      auto task = job.take();
      if (!task) break;
      pool.start(std::move(*task));
    }
    job.write();
    if (job.done()) break;
    std::vector<pollfd> awaited;
    if (pool.has_idle_worker() && job.awaited() >= 0) awaited.push_back({job.awaited(), POLLIN, 0});
    // A signal that comes just before it is found after this time.
    for (Outcome& outcome : pool.wait(200, awaited)) job.finish(std::move(outcome));
    job.write();
    report.update(job);
  }
  const bool interrupted = !job.done();
  output.finish();
  return report.end(job, interrupted);
}

}  // namespace eliminant::batch
