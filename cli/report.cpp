// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/report.hpp>

#include <cstdio>
#include <exception>

#include <eliminant/cli/answer.hpp>
#include <eliminant/io/input/input_text.hpp>
#include <eliminant/io/pictures/html_report.hpp>
#include <eliminant/io/pictures/result_picture.hpp>
#include <eliminant/io/pictures/svg_picture.hpp>
#include <eliminant/io/results/error_report.hpp>

namespace eliminant::cli {

int report(const Arguments& arguments) {
  const Answer answer(arguments.output);
  std::string source;
  try {
    const std::string text = io::read_text(arguments.file);
    source = arguments.file == "-" ? "standard input" : arguments.file;
    const io::Picture picture = io::result_picture(text);
    answer.write(arguments.output->ends_with(".html") ? io::html_report(picture) : io::svg_picture(picture));
    return 0;
  } catch (const io::OutputError&) {
    throw;
  } catch (const std::exception& error) {
    const io::ErrorReport report = io::report_error(error);
    std::fprintf(stderr, "eliminant: %s\n", io::error_line(report, source).c_str());
    return report.exit_status;
  }
}

}  // namespace eliminant::cli
