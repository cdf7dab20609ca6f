// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/run.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <variant>

#include <eliminant/base/context.hpp>
#include <eliminant/cli/hard_stop.hpp>
#include <eliminant/cli/interruptible.hpp>
#include <eliminant/cli/printed_result.hpp>
#include <eliminant/cli/process_alarm.hpp>
#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/intersect/curve_surface/implicitize.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/intersect/curves/self_intersection.hpp>
#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>
#include <eliminant/intersect/plane_curves/certificate_check.hpp>
#include <eliminant/intersect/plane_curves/match_candidates.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/io/input/candidates_file.hpp>
#include <eliminant/io/input/input_text.hpp>
#include <eliminant/io/input/memory_limit.hpp>
#include <eliminant/io/input/plane_curves_input.hpp>
#include <eliminant/io/input/problem_echo.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/input/stated_kind.hpp>
#include <eliminant/io/point_clouds/ply_file.hpp>
#include <eliminant/io/results/certificate_json.hpp>
#include <eliminant/io/results/error_report.hpp>
#include <eliminant/io/results/implicitize_json.hpp>
#include <eliminant/io/results/implicitize_text.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/surface_result_words.hpp>
#include <eliminant/io/results/verdict.hpp>

namespace eliminant::cli {

namespace {

const char* kind_of(const intersect::PlaneCurvesProblem& /*problem*/) { return "plane_curves"; }
const char* kind_of(const intersect::CurveSurfaceProblem& /*problem*/) { return "curve_surface"; }
const char* kind_of(const intersect::CurveCurveProblem& /*problem*/) { return "curve_curve"; }
const char* kind_of(const intersect::SelfIntersectionProblem& /*problem*/) { return "self_intersection"; }
const char* kind_of(const intersect::ImplicitizeProblem& /*problem*/) { return "implicitize"; }
const char* kind_of(const intersect::CurveTopologyProblem& /*problem*/) { return "curve_topology"; }
const char* kind_of(const intersect::SurfaceSurfaceProblem& /*problem*/) { return "surface_surface"; }
const char* kind_of(const intersect::SurfaceSelfIntersectionProblem& /*problem*/) { return "self_intersection"; }
const char* kind_of(const intersect::CylindersProblem& /*problem*/) { return "cylinders"; }
const char* kind_of(const intersect::CylinderExtractionProblem& /*problem*/) { return "cylinder_extraction"; }

// One run; its members are what is known of the problem when an error comes. A run of the program reads a file and
// writes the answer; one of a batch has its text, says nothing and keeps the answer.
class Run {
 public:
  explicit Run(const Arguments& arguments)
      : arguments_(arguments),
        answer_(arguments.output),
        certificate_(arguments.command == Arguments::Command::verify ? std::nullopt : arguments.certificate) {
    if (arguments.labels) labels_.emplace(arguments.labels);
    io::apply_options(options_, arguments.settings);
  }

  Run(const Arguments& arguments, const BatchLine& line)
      : arguments_(arguments), line_(&line), answer_(std::nullopt), certificate_(std::nullopt) {
    io::apply_options(options_, arguments.settings);
  }

  // The answer of one of a batch.
  LineResult result() {
    const io::KeptMemoryLimit kept;
    {
      std::optional<ProcessAlarm> alarm;
      if (options_.time_limit_seconds) alarm.emplace(hard_limit(*options_.time_limit_seconds));
      run();
    }
    return {io::json_on_one_line(given_), memory_exhausted_};
  }

  int run() {
    try {
      if (options_.memory_limit_megabytes) io::limit_memory(*options_.memory_limit_megabytes);
      const io::ProblemFile file = read();
      id_ = file.id;
      kind_ = std::visit([](const auto& problem) { return kind_of(problem); }, file.problem);
      options_ = {};
      io::apply_options(options_, file.options);
      io::apply_options(options_, arguments_.settings);
      if (line_ != nullptr) be_one_of_many();
      if (options_.memory_limit_megabytes) io::limit_memory(*options_.memory_limit_megabytes);
      if (arguments_.echo) {
        give(io::echo_problem(file, options_));
        return 0;
      }
      const bool verifying = arguments_.command == Arguments::Command::verify;
      if (arguments_.command == Arguments::Command::implicitize && kind_ != "implicitize")
        throw InvalidInput("implicitize is for one curve or surface, the problem is of the kind " + *kind_,
                           "a problem of the kind implicitize, or the command solve");
      if (labels_ && kind_ != "cylinder_extraction")
        throw InvalidInput("--labels does not go with " + *kind_, "a problem of the kind cylinder_extraction");
      keep_cloud(file);
      return std::visit([&](const auto& problem) { return verifying ? verify(problem) : solve(problem); },
                        file.problem);
    } catch (const io::OutputError&) {
      throw;
    } catch (const std::exception& error) {
      memory_exhausted_ = io::is_exhausted_memory(error);
      return fail(io::report_error(error));
    }
  }

 private:
  // What a batch has decided for all its problems.
  void be_one_of_many() {
    options_.format = io::Format::json;
    options_.solve.threads = 1;
  }

  void say(const std::string& line) const {
    if (line_ == nullptr) std::fprintf(stderr, "eliminant: %s\n", line.c_str());
  }

  io::ProblemFile read() {
    io::ReadSettings settings;
    if (arguments_.variables) {
      settings.variables = io::split_at_commas(*arguments_.variables);
      io::require_two_variables(*settings.variables, {});
    }
    if (arguments_.command == Arguments::Command::curves) {
      source_ = "command line";
      kind_ = "plane_curves";
      io::require_text(arguments_.p, "P");
      io::require_text(arguments_.q, "Q");
      return io::problem_from_arguments(arguments_.p, arguments_.q, arguments_.box, settings);
    }
    settings.bare_geometry = arguments_.command == Arguments::Command::implicitize;
    if (arguments_.file != "-") settings.folder = std::filesystem::path(arguments_.file).parent_path().string();
    if (line_ != nullptr) {
      io::require_text(line_->text, "the line");
      return read(line_->text, io::ProblemSyntax::json, settings);
    }
    const std::string text = io::read_text(arguments_.file);
    source_ = arguments_.file == "-" ? "standard input" : arguments_.file;
    return read(text, io::problem_syntax(arguments_.file, text), settings);
  }

  io::ProblemFile read(const std::string& text, io::ProblemSyntax syntax, const io::ReadSettings& settings) {
    try {
      return io::read_problem(text, syntax, settings, &id_);
    } catch (...) {
      kind_ = io::stated_kind(text, syntax);
      if (!kind_ && settings.bare_geometry) kind_ = "implicitize";
      throw;
    }
  }

  // Computes with everything that watches over it.
  template <class Compute>
  auto watched(Compute compute) {
    Context context;
    if (arguments_.progress) {
      say("threads: " + std::to_string(options_.solve.threads));
      context.on_progress([this](std::string_view stage) { say(std::string(stage)); });
    }
    std::unique_ptr<HardStop> hard_stop;
    std::optional<ProcessAlarm> alarm;
    if (options_.time_limit_seconds) {
      const double limit = *options_.time_limit_seconds;
      context.limit_seconds(std::min(limit, 1e8));
      if (line_ != nullptr)
        alarm.emplace(hard_limit(limit));
      else
        hard_stop = std::make_unique<HardStop>(hard_limit(limit), [this] { stop_hard(); });
    }
    std::optional<Interruptible> interruptible;
    if (line_ == nullptr) interruptible.emplace(context);
    solving_ = true;
    auto result = compute(context);
    solving_ = false;
    if (line_ != nullptr && !arguments_.timings) {
      // Lines depend on the problem alone: not on the run, nor on the processor, by which linear algebra rounds.
      if constexpr (requires { result.seconds.clear(); }) result.seconds.clear();
      if constexpr (requires { result.engine.largest_error_before_refinement; })
        result.engine.largest_error_before_refinement.reset();
    }
    return result;
  }

  int solve(const intersect::PlaneCurvesProblem& problem) {
    options_.solve.certificate = arguments_.certificate.has_value();
    const intersect::Result result = watched(
        [&](const Context& context) { return intersect::intersect_plane_curves(problem, options_.solve, context); });
    announce(result, result.common_component ? "the curves have a common component" : "");
    if (result.certificate) certificate_.write(io::certificate_json(*result.certificate));
    give(printed(result, options_, id_));
    return exit_status(result.status);
  }

  int solve(const intersect::CurveSurfaceProblem& problem) {
    refuse_certificate();
    const intersect::CurveResult result = watched(
        [&](const Context& context) { return intersect::intersect_curve_surface(problem, options_.solve, context); });
    announce(result, result.status == intersect::Status::infinite ? "the curve lies in the surface" : "");
    give(printed(result, options_, id_));
    return exit_status(result.status);
  }

  int solve(const intersect::CurveCurveProblem& problem) {
    refuse_certificate();
    const intersect::CurveResult result = watched(
        [&](const Context& context) { return intersect::intersect_curve_curve(problem, options_.solve, context); });
    announce(result, result.status == intersect::Status::infinite ? "the curves coincide" : "");
    give(printed(result, options_, id_));
    return exit_status(result.status);
  }

  int solve(const intersect::SelfIntersectionProblem& problem) {
    refuse_certificate();
    const intersect::CurveResult result = watched([&](const Context& context) {
      return intersect::intersect_curve_with_itself(problem, options_.solve, context);
    });
    announce(result,
             result.status == intersect::Status::infinite ? "a part of the curve is traced more than once" : "");
    give(printed(result, options_, id_));
    return exit_status(result.status);
  }

  int solve(const intersect::ImplicitizeProblem& problem) {
    refuse_certificate();
    if (options_.format == io::Format::csv)
      throw InvalidInput("implicitize cannot answer in the format csv", "--format text or json");
    const intersect::ImplicitizeResult result =
        watched([&](const Context& context) { return intersect::implicitize(problem, options_.solve, context); });
    announce(result, "");
    give(options_.format == io::Format::json ? io::implicitize_json(result, id_) : io::implicitize_text(result));
    return exit_status(result.status);
  }

  int solve(const intersect::CurveTopologyProblem& problem) {
    refuse_certificate();
    const intersect::TopologyResult result =
        watched([&](const Context& context) { return intersect::curve_topology(problem, options_.solve, context); });
    announce(result, "");
    give(printed(result, options_, id_));
    return exit_status(result.status);
  }

  int solve(const intersect::SurfaceSurfaceProblem& problem) {
    refuse_certificate();
    return answer(watched([&](const Context& context) {
                    return intersect::intersect_surface_surface(problem, options_.solve, context);
                  }),
                  io::domains_of(problem));
  }

  int solve(const intersect::SurfaceSelfIntersectionProblem& problem) {
    refuse_certificate();
    return answer(watched([&](const Context& context) {
                    return intersect::intersect_surface_with_itself(problem, options_.solve, context);
                  }),
                  io::domains_of(problem));
  }

  int solve(const intersect::CylindersProblem& problem) {
    refuse_certificate();
    const intersect::CylindersResult result =
        watched([&](const Context& context) { return intersect::cylinders_through(problem, options_.solve, context); });
    announce(result,
             result.status == intersect::Status::infinite ? "infinitely many cylinders pass through the points" : "");
    give(printed(result, options_, id_));
    return exit_status(result.status);
  }

  /// The labels may not replace the scan.
  void keep_cloud(const io::ProblemFile& file) const {
    const auto* const problem = std::get_if<intersect::CylinderExtractionProblem>(&file.problem);
    if (problem == nullptr || !arguments_.labels) return;
    std::error_code none;
    const std::filesystem::path folder = std::filesystem::path(arguments_.file).parent_path();
    if (std::filesystem::equivalent(folder / problem->cloud, *arguments_.labels, none))
      throw InvalidInput("--labels would overwrite the cloud", "the name of another file");
  }

  int solve(const intersect::CylinderExtractionProblem& problem) {
    refuse_certificate();
    const intersect::CylinderExtractionResult result =
        watched([&](const Context& context) { return intersect::extract_cylinders(problem, options_.solve, context); });
    announce(result, "");
    if (labels_) labels_->write(io::labelled_ply(problem.points, result.labels));
    give(printed(result, options_, id_));
    return exit_status(result.status);
  }

  int answer(const intersect::SurfaceResult& result, const io::SurfaceDomains& domains) {
    announce(result, "");
    give(printed(result, domains, options_, id_));
    return exit_status(result.status);
  }

  static int exit_status(intersect::Status status) { return status == intersect::Status::incomplete ? 3 : 0; }

  // Says on standard error what is no part of the answer; `infinite` is what a table cannot show, or empty.
  template <class AnyResult>
  void announce(const AnyResult& result, const std::string& infinite) const {
    if (!arguments_.quiet)
      for (const std::string& warning : result.warnings) say("warning: " + warning);
    if (!arguments_.quiet && options_.format == io::Format::csv && !infinite.empty())
      say("warning: " + infinite + ", which CSV cannot show");
    if (result.limit) say(io::error_line(io::report_error(LimitReached(*result.limit)), source_));
  }

  void refuse_certificate() const {
    if (arguments_.certificate)
      throw InvalidInput(
          "--certificate does not go with " + *kind_ + ": certificates are written for plane_curves only",
          "a problem of the kind plane_curves, or no --certificate");
  }

  int verify(const intersect::PlaneCurvesProblem& problem) {
    if (options_.format == io::Format::csv)
      throw InvalidInput("verify cannot answer in the format csv", "--format text or json");
    const std::string path = arguments_.certificate ? *arguments_.certificate : *arguments_.candidates;
    const double tolerance = arguments_.tolerance ? io::tolerance(*arguments_.tolerance) : 1e-6;
    source_ = path == "-" ? "standard input" : path;
    const std::string text = io::read_text(path);
    if (arguments_.certificate) {
      const intersect::Certificate certificate = io::read_certificate(text);
      const auto reasons =
          watched([&](const Context& context) { return intersect::check_certificate(problem, certificate, context); });
      give(io::certificate_verdict(reasons, id_, options_.format));
      return 0;
    }
    const io::CandidatesFile file = io::read_candidates(text);
    intersect::Options options = options_.solve;
    if (file.real_only && options.field == intersect::Field::automatic) options.field = intersect::Field::real;
    const intersect::CandidateReport report = watched([&](const Context& context) {
      return intersect::match_candidates(problem, file.candidates, tolerance, options, context);
    });
    give(io::candidates_verdict(report, id_, options_.format));
    return 0;
  }

  template <class Problem>
  int verify(const Problem& problem) {
    throw InvalidInput(std::string("verify is for plane_curves, the problem is of the kind ") + kind_of(problem),
                       "a problem of the kind plane_curves");
  }

  // Says what went wrong and gives the answer that stands for it.
  int fail(io::ErrorReport report) {
    if (line_ != nullptr) {
      be_one_of_many();
      report.place.line = line_->number;
    }
    say(io::error_line(report, source_));
    const bool incomplete = (solving_ || memory_exhausted_) && report.exit_status == 3;
    if (options_.format == io::Format::json)
      give(io::error_json(report, kind_, id_, incomplete));
    else if (incomplete && options_.format == io::Format::text)
      give("Status: incomplete: " + report.message + "\n");
    return report.exit_status;
  }

  void give(const std::string& text) {
    if (line_ != nullptr)
      given_ = text;
    else if (answer_.claim())
      answer_.write(text);
  }

  void stop_hard() {
    int status = 3;
    try {
      if (answer_.claim()) {
        const io::ErrorReport report{"limit", 3, "the time limit was reached", {}, {}};
        say(io::error_line(report, source_));
        if (options_.format == io::Format::json) answer_.write(io::error_json(report, kind_, id_, true));
        if (options_.format == io::Format::text) answer_.write("Status: incomplete: " + report.message + "\n");
        std::_Exit(status);
      }
    } catch (const std::exception& error) {
      say(error.what());
      std::_Exit(1);
    }
  }

  const Arguments& arguments_;
  const BatchLine* line_ = nullptr;
  std::string given_;
  bool memory_exhausted_ = false;
  Answer answer_;
  Answer certificate_;
  std::optional<Answer> labels_;
  io::RunOptions options_;
  std::optional<std::string> kind_;
  std::optional<io::ProblemId> id_;
  std::string source_;
  bool solving_ = false;
};

}  // namespace

int run(const Arguments& arguments) { return Run(arguments).run(); }

LineResult result_line(const BatchLine& line, const Arguments& arguments) { return Run(arguments, line).result(); }

}  // namespace eliminant::cli
