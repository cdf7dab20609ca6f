// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/arguments.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include <eliminant/cli/polynomial_arguments.hpp>
#include <eliminant/version.hpp>

namespace eliminant::cli {

namespace {

struct OptionText {
  const char* name;
  const char* value;
  const char* description;
};

// The options that a problem file may hold as well (io::option_names); their values are checked there, once for both.
constexpr std::array<OptionText, 11> valued_options{{
    {"format", "text|json|csv", "how the answer is printed (default text)"},
    {"digits", "N", "significant decimal digits of each coordinate (default 15)"},
    {"engine", "auto|pencil|exact|box", "how the solutions are found (default auto)"},
    {"matrix", "auto|sylvester|bezout|hybrid", "which resultant matrix (default auto)"},
    {"precision", "auto|53|128|256|512|1024", "bits of the numeric stage (default auto: climbs from 53)"},
    {"epsilon", "E", "threshold of the published numeric algorithm; never decides what is reported"},
    {"tolerance", "T", "of traced curves, relative to the size of the patches (default 1e-9)"},
    {"threads", "N", "worker threads, of batch worker processes (default 1); the answer does not depend on it"},
    {"time-limit", "S", "seconds until the computation ends with status incomplete"},
    {"memory-limit", "MB", "megabytes that a problem may take, beside the program itself"},
    {"seed", "N", "seed of the choice of primes (default 0); the answer does not depend on it"},
}};
constexpr std::array<OptionText, 6> switches{{
    {"real", "", "list the real solutions only"},
    {"complex", "", "list all complex solutions (default without a box)"},
    {"certify", "", "prove each solution and the completeness of the list (default)"},
    {"no-certify", "", "leave the proofs out"},
    {"equation", "", "implicitize: the implicit equation, too; two surfaces: the eliminant in full"},
    {"bspline", "", "fit B-splines to traced curves, too"},
}};

constexpr const char* tolerance_of_verify =
    "how far a candidate may be from its solution, each coordinate relative to max(1, its modulus) (default 1e-6)";

void add_common_options(CLI::App& app, Arguments& arguments) {
  for (const auto& [name, value, description] : valued_options) {
    const bool of_verify = app.get_name() == "verify" && std::string(name) == "tolerance";
    app.add_option_function<std::string>(
           std::string("--") + name,
           [&arguments, name = std::string(name)](const std::string& given) {
             arguments.settings.push_back({name, given, {}});
           },
           of_verify ? tolerance_of_verify : description)
        ->type_name(value);
  }
  for (const auto& [name, value, description] : switches)
    app.add_flag_callback(
        std::string("--") + name,
        [&arguments, name = std::string(name)] {
          arguments.settings.push_back({name, "true", {}});
        },
        description);
  app.add_option("--variables", arguments.variables, "names and order of the two variables")->type_name("x,y");
  app.add_option("-o,--output", arguments.output, "write the answer to FILE instead of standard output")
      ->type_name("FILE");
  app.add_option("--labels", arguments.labels,
                 "cylinder_extraction: write the cloud to FILE.ply, each point with the index of its cylinder")
      ->type_name("FILE");
  app.add_option("--certificate", arguments.certificate,
                 "plane curves: write a certificate of the result to FILE; verify: the certificate to check")
      ->type_name("FILE");
  app.add_flag("--echo", arguments.echo, "print the problem as understood (JSON, can be read back) and stop");
  CLI::Option* const progress = app.add_flag("--progress", arguments.progress, "report the stages on standard error");
  app.add_flag("--quiet", arguments.quiet, "no warnings on standard error")->excludes(progress);
}

CLI::App* add_batch(CLI::App& app, Arguments& arguments) {
  CLI::App* const batch =
      app.add_subcommand("batch", "solve many problems, one a line; the results, one a line, in order");
  batch->add_option("FILE", arguments.file, "problems in JSON, one a line; - is standard input")->required();
  batch->add_flag("--resume", arguments.resume, "keep the results that the output has, solve the others");
  batch->add_flag(
      "--timings", arguments.timings,
      "write the fields that differ from run to run or from machine to machine: seconds, accuracy before refinement");
  batch->add_option("--shard", arguments.shard, "solve part I of N of the file alone")->type_name("I/N");
  return batch;
}

// What batch does with the options of all commands.
void check_batch(const Arguments& arguments) {
  const auto refuse = [](const std::string& reason) { throw UsageError(reason + "; see eliminant batch --help"); };
  for (const io::OptionSetting& setting : arguments.settings)
    if (setting.name == "format" && setting.value != "json") refuse("batch writes JSON, not " + setting.value);
  if (arguments.echo) refuse("--echo does not go with batch");
  if (arguments.certificate) refuse("--certificate does not go with batch");
  if (arguments.labels) refuse("--labels does not go with batch");
  if (arguments.resume && !arguments.output) refuse("--resume continues the output of -o FILE");
}

// The option of verify is another one than that of the problem.
void take_tolerance(Arguments& arguments) {
  for (const io::OptionSetting& setting : arguments.settings)
    if (setting.name == "tolerance") arguments.tolerance = setting.value;
  std::erase_if(arguments.settings, [](const io::OptionSetting& setting) { return setting.name == "tolerance"; });
}

// No output may be an input, by whatever name: it would be gone before it was read.
void refuse_to_overwrite(const Arguments& arguments) {
  const auto is_same = [](const std::optional<std::string>& input, const std::optional<std::string>& output) {
    std::error_code none;
    return input && output && std::filesystem::is_regular_file(*output, none) &&
           std::filesystem::equivalent(*input == "-" ? "/dev/stdin" : *input, *output, none);
  };
  const bool writes_certificate = arguments.command != Arguments::Command::verify;
  const bool writes_state = arguments.command == Arguments::Command::batch && arguments.output;
  const std::optional<std::string> certificate = writes_certificate ? arguments.certificate : std::nullopt;
  const std::optional<std::string> state = writes_state ? std::optional(*arguments.output + ".state") : std::nullopt;
  for (const std::optional<std::string>& input : {std::optional(arguments.file), arguments.candidates})
    for (const std::optional<std::string>& output : {arguments.output, arguments.labels, certificate, state})
      if (is_same(input, output))
        throw UsageError("'" + *output + "' would be overwritten, and it is the input '" + *input + "'");
}

}  // namespace

std::variant<Arguments, Information> parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  CLI::App app("Intersections of curves and surfaces by resultant matrices.", "eliminant");
  app.set_version_flag("--version", "eliminant " + std::string(version));
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 answered, 1 internal error or output that cannot be written, 2 bad input or usage,\n"
      "3 a limit was reached. Example: eliminant curves \"x^2 + y^2 - 5\" \"x*y - 2\"");
  CLI::App* const solve = app.add_subcommand("solve", "solve the problem in a file (JSON, or .ms of msolve)");
  solve->add_option("FILE", arguments.file, "the problem; - is standard input")->required();
  CLI::App* const curves = app.add_subcommand("curves", "intersect the curves P = 0 and Q = 0");
  curves->add_option("P", arguments.p, "a polynomial, such as \"400*y^4 - 160*x^2*y^2 + 25/16\"")->required();
  curves->add_option("Q", arguments.q, "a polynomial; put -- before one that begins with two dashes")->required();
  curves->add_option("--box", arguments.box, "only the real solutions in this closed rectangle")
      ->type_name("[[a,b],[c,d]]");
  CLI::App* const verify =
      app.add_subcommand("verify", "check anybody's solutions, or a certificate, against the exact problem in a file");
  verify->add_option("PROBLEM", arguments.file, "the problem; - is standard input")->required();
  verify->add_option("CANDIDATES", arguments.candidates, "solutions: JSON like a result, or CSV x,y[,multiplicity]");
  CLI::App* const implicitize =
      app.add_subcommand("implicitize", "matrix representation of the rational curve or surface in a file");
  implicitize
      ->add_option("FILE", arguments.file,
                   "JSON: the problem implicitize, {\"curve\": ...}, {\"surface\": ...}, or a curve or surface itself")
      ->required();
  CLI::App* const batch = add_batch(app, arguments);
  for (CLI::App* command : {&app, solve, curves, verify, implicitize, batch}) add_common_options(*command, arguments);
  CLI::App* const report = app.add_subcommand("report", "a picture of the result in a file");
  report->add_option("RESULT", arguments.file, "a result in JSON; - is standard input")->required();
  report->add_option("-o,--output", arguments.output, "the picture: FILE.svg, or FILE.html with tables")
      ->type_name("FILE");

  // CLI11 takes the words from the back.
  std::vector<std::string> reversed = protect_polynomials(words, *curves);
  std::reverse(reversed.begin(), reversed.end());
  try {
    app.parse(reversed);
  } catch (const CLI::CallForVersion& call) {
    return Information{std::string(call.what()) + "\n"};
  } catch (const CLI::CallForHelp&) {
    return Information{app.help()};
  } catch (const CLI::CallForAllHelp&) {
    return Information{app.help("", CLI::AppFormatMode::All)};
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; see eliminant --help");
  }
  arguments.command = solve->parsed()         ? Arguments::Command::solve
                      : curves->parsed()      ? Arguments::Command::curves
                      : implicitize->parsed() ? Arguments::Command::implicitize
                      : report->parsed()      ? Arguments::Command::report
                      : batch->parsed()       ? Arguments::Command::batch
                                              : Arguments::Command::verify;
  if (report->parsed() &&
      !(arguments.output && (arguments.output->ends_with(".svg") || arguments.output->ends_with(".html"))))
    throw UsageError("report writes to -o FILE.svg or -o FILE.html; see eliminant report --help");
  if (batch->parsed()) check_batch(arguments);
  if (verify->parsed()) take_tolerance(arguments);
  if (verify->parsed() && arguments.candidates.has_value() == arguments.certificate.has_value())
    throw UsageError("verify checks either CANDIDATES or --certificate FILE; see eliminant verify --help");
  if (!verify->parsed() && arguments.certificate && arguments.certificate == arguments.output)
    throw UsageError("the answer and the certificate cannot go to the same file");
  if (arguments.labels && (arguments.labels == arguments.output || arguments.labels == arguments.certificate))
    throw UsageError("the answer, the certificate and the labels cannot go to the same file");
  refuse_to_overwrite(arguments);
  if (verify->parsed() && arguments.file == "-" && (arguments.candidates == "-" || arguments.certificate == "-"))
    throw UsageError("verify cannot read both files from standard input");
  return arguments;
}

io::Format format_in(const std::vector<std::string>& words) {
  io::Format format = io::Format::text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool json =
        words[i] == "--format=json" || (words[i] == "--format" && i + 1 < words.size() && words[i + 1] == "json");
    if (json) format = io::Format::json;
  }
  return format;
}

}  // namespace eliminant::cli
