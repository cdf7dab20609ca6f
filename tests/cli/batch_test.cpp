// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#ifdef ELIMINANT_PROGRAM

#include <cli/program.hpp>
#include <eliminant/io/input/json_text.hpp>
#include <support/batch_runs.hpp>

using eliminant::io::JsonDocument;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::string line;
  std::istringstream stream(text);
  while (std::getline(stream, line)) lines.push_back(line);
  return lines;
}

std::string field(const std::string& line, const char* name) {
  const JsonDocument document(line);
  const auto* const value = document.root().find(name);
  return value == nullptr ? "absent" : value->text;
}

std::string error_field(const std::string& line, const char* name) {
  const JsonDocument document(line);
  return document.root().find("error")->find(name)->text;
}

std::vector<std::string> batch_command(const std::string& input, const std::string& output, const char* workers) {
  return {ELIMINANT_PROGRAM, "batch", input, "-o", output, "--threads", workers, "--resume", "--quiet"};
}

// Two curves whose exact solution takes a computation of many seconds.
std::string slow_problem() {
  std::string p;
  std::string q;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; i + j <= 40; ++j) {
      const std::string monomial = "*x^" + std::to_string(i) + "*y^" + std::to_string(j);
      p += (p.empty() ? "" : "+") + std::to_string(i * 7 % 11 + j * 5 % 13 + 1) + monomial;
      q += (q.empty() ? "" : "+") + std::to_string(i * 3 % 17 + j * j % 7 + 1) + monomial;
    }
  return "{\"problem\": \"plane_curves\", \"id\": \"slow\", \"p\": \"" + p + "\", \"q\": \"" + q + "\"}\n";
}

const std::string quick_problem = "{\"problem\": \"plane_curves\", \"p\": \"x^2 - 2\", \"q\": \"x - y\"}\n";

}  // namespace

TEST_CASE("batch: each line has its result, in order, and a bad one costs that line only") {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "problems",
      "{\"problem\": \"plane_curves\", \"id\": \"first\", \"p\": \"x - 1\", \"q\": \"y\"}\n"
      "\n"
      "{\"problem\": \"plane_curves\", \"id\": \"half\", \"p\": \"x +* 1\", \"q\": \"y\"}\n"
      "[1, 2\n"
      "{\"problem\": \"plane_curves\", \"p\": \"\xFF\", \"q\": \"y\"}\n"
      "{\"problem\": \"unheard\"}\n"
      "{\"problem\": \"curve_topology\", \"id\": 6, \"p\": \"x^2 + y^2 - 1\"}\n"
      "{\"problem\": \"implicitize\", \"curve\": {\"parameter\": \"t\", \"x\": \"t^2\", \"y\": \"t^3\"}}\n"
      "{\"problem\": \"curve_curve\", \"first\": {\"implicit\": \"x\"}, \"second\": {\"implicit\": \"y\"}}\n"
      "{\"problem\": \"self_intersection\", \"curve\": {\"parameter\": \"t\", \"x\": \"t^2 - 1\", \"y\": \"t^3 - "
      "t\"}}\n"
      "{\"problem\": \"curve_surface\", \"curve\": {\"parameter\": \"t\", \"x\": \"t\", \"y\": \"0\", \"z\": \"0\"}, "
      "\"surface\": {\"implicit\": \"x^2 + y^2 + z^2 - 1\"}}\n"
      "{\"problem\": \"surface_surface\", \"first\": {\"bezier\": {\"degree\": [1, 1], \"control_points\": "
      "[[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]}}, \"second\": {\"implicit\": \"x - 1/2\"}}");
  const Outcome outcome = run_program(folder, "batch '" + path + "'");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const std::vector<std::string> lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 11);
  const std::vector<std::string> kinds{"plane_curves",
                                       "plane_curves",
                                       "",
                                       "",
                                       "unheard",
                                       "curve_topology",
                                       "implicitize",
                                       "curve_curve",
                                       "self_intersection",
                                       "curve_surface",
                                       "surface_surface"};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CAPTURE(lines[i]);
    CHECK(field(lines[i], "problem") == kinds[i]);
    CHECK(field(lines[i], "status") == (i >= 1 && i <= 4 ? "error" : "certified"));
    CHECK(field(lines[i], "seconds") == "absent");
  }
  CHECK(field(lines[0], "id") == "first");
  CHECK(field(lines[1], "id") == "half");
  CHECK(field(lines[5], "id") == "6");
  // The line is that of the file.
  const std::vector<std::string> error_lines{"3", "4", "5", "6"};
  for (std::size_t i = 0; i < 4; ++i) CHECK(error_field(lines[i + 1], "line") == error_lines[i]);
  CHECK(error_field(lines[1], "column") == "52");
}

TEST_CASE("batch: the example has the results that stand beside it") {
  const TemporaryFolder folder;
  const std::string problems = std::string(ELIMINANT_EXAMPLES) + "/batch.ndjson";
  std::ifstream expected(std::string(ELIMINANT_EXAMPLES) + "/batch.expected.ndjson");
  CHECK(run_program(folder, "batch '" + problems + "'").out ==
        std::string(std::istreambuf_iterator<char>(expected), std::istreambuf_iterator<char>()));
}

TEST_CASE("batch: a line is what solve prints, but for its layout and what depends on the machine") {
  const TemporaryFolder folder;
  const std::string problem =
      "{\"problem\": \"plane_curves\", \"id\": \"a \\\"b\\\",  c\", \"p\": \"x^2 + y^2 - 3\", \"q\": \"x*y - 1\"}\n";
  const std::string path = folder.write("problem.json", problem);
  const std::string line = run_program(folder, "batch --timings --digits 30 '" + path + "'").out;
  CHECK(contains(line, "\"seconds\": {\"total\": "));
  CHECK(contains(line, "\"largest_error_before_refinement\": "));
  std::string solved = run_program(folder, "solve --format json --digits 30 '" + path + "'").out;
  std::string joined;
  for (const std::string& part : lines_of(solved)) {
    if (contains(part, "\"seconds\": ") || contains(part, "\"largest_error_before_refinement\": ")) continue;
    const std::string text = part.substr(std::min(part.find_first_not_of(' '), part.size()));
    joined += (joined.empty() || joined.back() != ',' ? "" : " ") + text;
  }
  CHECK(run_program(folder, "batch --digits 30 '" + path + "'").out == joined + "\n");
}

TEST_CASE("batch: options of a problem are its own, and the command line wins") {
  const TemporaryFolder folder;
  const std::string line =
      "{\"problem\": \"plane_curves\", \"p\": \"x^2 - 2\", \"q\": \"y\", \"options\": {\"digits\": 5, \"format\": "
      "\"csv\"}}\n";
  const std::string path = folder.write("problems", line + quick_problem);
  const auto own = lines_of(run_program(folder, "batch '" + path + "'").out);
  REQUIRE(own.size() == 2);
  CHECK(contains(own[0], "\"1.4142\""));
  CHECK(contains(own[1], "\"1.4142135623731\""));
  const auto common = lines_of(run_program(folder, "batch --digits 3 '" + path + "'").out);
  REQUIRE(common.size() == 2);
  CHECK(contains(common[0], "\"1.41\""));
  CHECK(contains(common[1], "\"1.41\""));
}

TEST_CASE("batch: the same bytes for any number of workers, from a file and from a pipe") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", batch_problems(300));
  const Outcome one = run_program(folder, "batch '" + path + "'");
  CHECK(one.status == 0);
  CHECK(lines_of(one.out).size() == 323);
  for (const char* workers : {"2", "3"}) {
    CAPTURE(workers);
    const Outcome outcome = run_program(folder, "batch '" + path + "' --threads " + workers);
    CHECK(outcome.out == one.out);
    const std::string piped = "cat '" + path + "' | '" + ELIMINANT_PROGRAM + "' batch - --threads " + workers + " >'" +
                              folder.file("piped") + "'";
    CHECK(std::system(piped.c_str()) == 0);
    CHECK(folder.read("piped") == one.out);
  }
}

TEST_CASE("batch: the results of all parts together are those of the whole") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", batch_problems(60));
  const std::string whole = run_program(folder, "batch '" + path + "'").out;
  std::string joined;
  for (const char* part : {"1/3", "2/3", "3/3"})
    joined += run_program(folder, "batch '" + path + "' --shard " + part).out;
  CHECK(joined == whole);
}

TEST_CASE("batch: limits hold within calls that do not look at the clock, for one problem alone") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", quick_problem + slow_problem() + quick_problem);
  SUBCASE("of time") {
    const Outcome outcome = run_program(folder, "batch '" + path + "' --time-limit 0.3");
    CHECK(outcome.status == 3);
    const auto lines = lines_of(outcome.out);
    REQUIRE(lines.size() == 3);
    CHECK(field(lines[0], "status") == "certified");
    CHECK(field(lines[1], "status") == "incomplete");
    CHECK(field(lines[1], "id") == "slow");
    CHECK(error_field(lines[1], "kind") == "limit");
    CHECK(contains(error_field(lines[1], "message"), "the time limit was reached"));
    CHECK(field(lines[2], "status") == "certified");
  }
  SUBCASE("of memory") {
    const Outcome outcome = run_program(folder, "batch '" + path + "' --memory-limit 60 --threads 2");
    CHECK(outcome.status == 3);
    const auto lines = lines_of(outcome.out);
    REQUIRE(lines.size() == 3);
    CHECK(field(lines[0], "status") == "certified");
    CHECK(field(lines[1], "status") == "incomplete");
    CHECK(error_field(lines[1], "kind") == "limit");
    CHECK(error_field(lines[1], "message") == "the memory is exhausted");
    CHECK(field(lines[2], "status") == "certified");
  }
  SUBCASE("of so little memory that nothing can be done") {
    for (const char* limit : {"1", "2", "3"})
      for (const char* workers : {"1", "2"}) {
        const Outcome outcome =
            run_program(folder, "batch '" + path + "' --memory-limit " + limit + " --threads " + workers);
        CAPTURE(limit);
        CAPTURE(workers);
        CHECK(outcome.status == 3);
        const auto lines = lines_of(outcome.out);
        REQUIRE(lines.size() == 3);
        CHECK(field(lines[1], "status") == "incomplete");
        CHECK(error_field(lines[1], "kind") == "limit");
      }
  }
}

TEST_CASE("batch: killed at any moment and resumed it ends with the same file") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", batch_problems(600));
  REQUIRE(RunningProgram(batch_command(path, folder.file("whole"), "2")).wait() == 0);
  const std::string whole = folder.read("whole");
  std::mt19937 random(3);
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(RunningProgram(batch_command(path, folder.file("again"), "2")).wait() == 0);
  const auto elapsed = std::chrono::steady_clock::now() - begin;
  const int milliseconds = static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(elapsed).count());
  for (int i = 0; i < 20; ++i) {
    const std::string output = "out" + std::to_string(i);
    const int moment = static_cast<int>(random() % static_cast<unsigned>(milliseconds));
    CAPTURE(moment);
    {
      RunningProgram program(batch_command(path, folder.file(output), "2"));
      sleep_milliseconds(moment);
      if (i % 2 == 0) {
        kill(program.process(), SIGKILL);
        program.wait();
      } else {
        // One worker: the program goes on.
        for (const pid_t worker : children_of(program.process())) {
          kill(worker, SIGKILL);
          break;
        }
        CHECK(program.wait() == 0);
        CHECK(folder.read(output) == whole);
      }
    }
    REQUIRE(RunningProgram(batch_command(path, folder.file(output), "3")).wait() == 0);
    CHECK(folder.read(output) == whole);
  }
}

TEST_CASE("batch: workers end with the program, however that ends") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", slow_problem() + slow_problem());
  RunningProgram program(batch_command(path, folder.file("out"), "2"));
  std::vector<pid_t> workers;
  for (int i = 0; i < 500 && workers.size() < 2; ++i) {
    sleep_milliseconds(10);
    workers = children_of(program.process());
  }
  REQUIRE(workers.size() == 2);
  kill(program.process(), SIGKILL);
  program.wait();
  // The init process of a container may leave them as zombies; they hold nothing then.
  const auto runs = [](pid_t process) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    if (!std::getline(stat, text)) return false;
    return text.substr(text.rfind(") ") + 2, 1) != "Z";
  };
  for (const pid_t worker : workers) {
    for (int i = 0; i < 500 && runs(worker); ++i) sleep_milliseconds(10);
    CHECK_FALSE(runs(worker));
  }
}

TEST_CASE("batch: an interrupted run keeps its results and says that it is not complete") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", quick_problem + slow_problem());
  for (const int signal : {SIGINT, SIGTERM}) {
    CAPTURE(signal);
    RunningProgram program(batch_command(path, folder.file("results"), "1"));
    for (int i = 0; i < 500 && folder.read("results").empty(); ++i) sleep_milliseconds(10);
    kill(program.process(), signal);
    CHECK(program.wait() == 3);
    CHECK(lines_of(folder.read("results")).size() == 1);
    std::filesystem::remove(folder.file("results"));
  }
}

TEST_CASE("batch: an output that becomes full keeps what fits, and is resumed") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", batch_problems(300));
  const std::string whole = run_program(folder, "batch '" + path + "'").out;
  const std::string command = "batch '" + path + "' -o '" + folder.file("results") + "' --resume";
  // The limit of the size of a file stands for the end of a disk.
  const std::string limited = "ulimit -f 100; '" + std::string(ELIMINANT_PROGRAM) + "' " + command + " 2>'" +
                              folder.file("message") + "'; exit $?";
  const int status = std::system(limited.c_str());
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
  CHECK(contains(folder.read("message"), "cannot write '" + folder.file("results") + "': File too large"));
  const std::string kept = folder.read("results");
  CHECK(kept.size() > 50'000);
  CHECK(kept == whole.substr(0, kept.size()));
  CHECK(run_program(folder, command).status == 0);
  CHECK(folder.read("results") == whole);
}

TEST_CASE("batch: two runs do not write one output") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", quick_problem + slow_problem());
  const RunningProgram program(batch_command(path, folder.file("results"), "1"));
  for (int i = 0; i < 500 && folder.read("results").empty(); ++i) sleep_milliseconds(10);
  const std::string before = folder.read("results");
  for (const char* option : {"", " --resume"}) {
    const Outcome outcome = run_program(folder, "batch '" + path + "' -o '" + folder.file("results") + "'" + option);
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.err, "another run is writing it"));
    CHECK(folder.read("results") == before);
  }
}

TEST_CASE("batch: no input is overwritten, by whatever name") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", quick_problem);
  folder.write("results.state", quick_problem);
  const auto refused = [&](const std::string& arguments) {
    const Outcome outcome = run_program(folder, arguments);
    CAPTURE(arguments);
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "would be overwritten"));
    CHECK(folder.read("problems") == quick_problem);
    CHECK(folder.read("results.state") == quick_problem);
  };
  refused("batch '" + path + "' -o '" + path + "'");
  refused("batch '" + path + "' --resume -o '" + folder.file("./problems") + "'");
  refused("batch '" + folder.file("results.state") + "' -o '" + folder.file("results") + "'");
  refused("solve '" + path + "' -o '" + path + "'");
  refused("batch - -o '" + path + "' <'" + path + "'");
}

TEST_CASE("batch: an output that cannot be written, or not be continued, is said in a sentence") {
  const TemporaryFolder folder;
  const std::string path = folder.write("problems", quick_problem);
  const auto check = [&](const std::string& arguments, int status, const char* message) {
    const Outcome outcome = run_program(folder, "batch " + arguments);
    CAPTURE(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.status == status);
    CHECK(contains(outcome.err, message));
  };
  const std::string problems = "'" + path + "' ";
  check(problems + "-o /dev/full", 1, "cannot write '/dev/full': No space left on device");
  check(problems + ">/dev/full", 1, "cannot write standard output: No space left on device");
  check(problems + "-o '" + folder.file("missing/out") + "'", 1, "cannot write '");
  check(problems + "-o '" + folder.file(".") + "'", 1, "cannot write '");
  check(problems + "-o /dev/null --resume", 2, "cannot be continued");
  check(problems + "--resume", 2, "-o FILE");
  check(problems + "--format csv", 2, "batch writes JSON");
  check(problems + "--echo", 2, "--echo does not go with batch");
  check(problems + "--shard 3/2", 2, "1 <= I <= N");
  check(problems + "--digits 0", 2, "digits");
  check("- --shard 1/2 <'" + path + "'", 2, "cannot be cut into parts");
  check("'" + folder.file("nothing") + "'", 2, "cannot be opened");
  check("'" + folder.file(".") + "'", 2, "is a directory");
  folder.write("results", "{}\n");
  check(problems + "--resume -o '" + folder.file("results") + "'", 2, "there is no '");
  check(problems + "-o '" + folder.file("results") + "'", 0, "");
  check(problems + "--resume --digits 20 -o '" + folder.file("results") + "'", 2, "belongs to another run");
  CHECK(lines_of(folder.read("results")).size() == 1);
}

#endif
