// SPDX-License-Identifier: BSD-3-Clause
//
// eliminant batch over MPI: mpirun -n N eliminant-mpi FILE.ndjson -o OUT, with the options of eliminant batch.
#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/batch/foreman.hpp>
#include <eliminant/cli/answer.hpp>
#include <eliminant/cli/arguments.hpp>
#include <eliminant/cli/batch.hpp>
#include <eliminant/io/input/memory_limit.hpp>
#include <eliminant/io/results/error_report.hpp>
#include <eliminant/mpi/distributed_batch.hpp>

namespace {

using namespace eliminant;

struct World {
  World(int& argc, char**& argv) {
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() { MPI_Finalize(); }
  int rank = 0;
  int size = 1;
};

void say(const std::string& line) { std::fprintf(stderr, "eliminant-mpi: %s\n", line.c_str()); }

// What all ranks know alike, rank 0 says.
int answer_as_one(int argc, char** argv, int status, const std::function<void()>& answer) {
  const World world(argc, argv);
  if (world.rank == 0) answer();
  return world.rank == 0 ? status : 0;
}

int solve(int argc, char** argv, const cli::Arguments& arguments) {
  const batch::BatchSettings settings = cli::batch_settings(arguments);
  const batch::Solver solver = cli::batch_solver(arguments);
  // The process that forks the workers is forked itself before MPI has connections and threads that a fork may harm.
  batch::ChildProcess own([] {}, [&](batch::Channel& channel) { batch::serve(channel, settings.workers, solver); });
  const World world(argc, argv);
  try {
    if (world.rank == 0)
      return cli::with_reported_errors(arguments.file, [&] { return mpi::hand_out_batch(settings, own, world.size); });
    mpi::relay_batch(own);
    return 0;
  } catch (const io::OutputError& error) {
    say(error.what());
    return 1;
  } catch (const std::exception& error) {
    say(error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  std::vector<std::string> words{"batch"};
  words.insert(words.end(), argv + 1, argv + argc);
  if (words.size() == 2 && words[1] == "--version") words.erase(words.begin());
  try {
    io::prepare_arithmetic();
    const auto parsed = cli::parse_arguments(words);
    if (const auto* information = std::get_if<cli::Information>(&parsed))
      return answer_as_one(argc, argv, 0, [&] { cli::Answer(std::nullopt).write(information->text); });
    return solve(argc, argv, std::get<cli::Arguments>(parsed));
  } catch (const cli::UsageError& error) {
    return answer_as_one(argc, argv, 2, [&] { say(error.what()); });
  } catch (const std::exception& error) {
    const io::ErrorReport report = io::report_error(error);
    return answer_as_one(argc, argv, report.exit_status, [&] { say(io::error_line(report, "")); });
  }
}
