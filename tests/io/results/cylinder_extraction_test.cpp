// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/io/input/problem_echo.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/pictures/html_report.hpp>
#include <eliminant/io/pictures/result_picture.hpp>
#include <eliminant/io/pictures/svg_picture.hpp>
#include <eliminant/io/results/cylinder_extraction_csv.hpp>
#include <eliminant/io/results/cylinder_extraction_json.hpp>
#include <eliminant/io/results/cylinder_extraction_text.hpp>

using namespace eliminant;
using namespace eliminant::io;

namespace {

intersect::CylinderExtractionResult one_cylinder() {
  intersect::CylinderExtractionResult result;
  result.cloud = "a <b>.ply";
  result.counts = {10, 1, 7, 4096, 3};
  result.cylinders.push_back({{0, 0.6, 0.8}, {1, -2, 3}, 0.5, 4, 7, 0.001234567});
  result.distance = 0.01;
  result.min_radius = 0.05;
  result.max_radius = 2;
  result.min_inliers = 5;
  result.confidence = 0.99123;
  result.warnings = {"2 of 12 points of the cloud are not finite and were left out"};
  return result;
}

ProblemFile read(const std::string& fields, const std::string& folder = ELIMINANT_EXAMPLES) {
  ReadSettings settings;
  settings.folder = folder;
  return read_problem("{\"problem\": \"cylinder_extraction\", " + fields + "}", ProblemSyntax::json, settings);
}

std::string refusal(const std::string& fields) {
  try {
    read(fields);
  } catch (const InvalidInput& error) {
    CHECK(error.place().line == 1);
    CHECK(!error.expected().empty());
    return error.what();
  }
  return "accepted";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("cylinder_extraction: fields of a problem, the cloud beside the problem file") {
  const ProblemFile file =
      read(R"("cloud": "two_pipes.csv", "distance": "1/50", "min_radius": 0.25, "max_radius": "2", "min_inliers": 60, )"
           R"("confidence": "0.999")");
  const auto& problem = std::get<intersect::CylinderExtractionProblem>(file.problem);
  CHECK(problem.points.size() == 700);
  CHECK(problem.cloud == "two_pipes.csv");
  CHECK(problem.distance == 0.02);
  CHECK(problem.min_radius == 0.25);
  CHECK(problem.max_radius == 2.0);
  CHECK(problem.min_inliers == std::size_t{60});
  CHECK(problem.confidence == 0.999);
  CHECK(problem.warnings.empty());
  // What is echoed is read as the same problem.
  ReadSettings settings;
  settings.folder = ELIMINANT_EXAMPLES;
  const auto again = read_problem(echo_problem(file, {}), ProblemSyntax::json, settings);
  const auto& same = std::get<intersect::CylinderExtractionProblem>(again.problem);
  CHECK(same.points == problem.points);
  CHECK(same.distance == problem.distance);
  CHECK(same.min_radius == problem.min_radius);
  CHECK(same.max_radius == problem.max_radius);
  CHECK(same.min_inliers == problem.min_inliers);
  CHECK(same.confidence == problem.confidence);
}

TEST_CASE("cylinder_extraction: bad fields are refused with their place") {
  const std::string cloud = R"("cloud": "two_pipes.csv", )";
  CHECK(refusal(R"("distance": "0.01")") == "the field \"cloud\" is missing");
  CHECK(refusal(R"("cloud": "two_pipes.csv")") == "the field \"distance\" is missing");
  CHECK(refusal(cloud + R"("distance": "-1")") == "\"distance\" is -1");
  CHECK(refusal(cloud + R"("distance": 0)") == "\"distance\" is 0");
  CHECK(refusal(cloud + R"("distance": "1e400")") == "\"distance\" is 1e400");
  CHECK(contains(refusal(cloud + R"("distance": [1])"), "\"distance\" is an array"));
  CHECK(contains(refusal(cloud + R"("distance": "much")"), "\"distance\""));
  CHECK(refusal(cloud + R"("distance": 1, "min_radius": 3, "max_radius": 2)") ==
        "\"min_radius\" is larger than \"max_radius\"");
  CHECK(refusal(cloud + R"("distance": 1, "min_inliers": 4)") == "\"min_inliers\" is 4");
  CHECK(refusal(cloud + R"("distance": 1, "min_inliers": 7.5)") == "\"min_inliers\" is 7.5");
  CHECK(refusal(cloud + R"("distance": 1, "confidence": 1)") == "\"confidence\" is not below 1");
  CHECK(refusal(cloud + R"("distance": 1, "confidence": 0)") == "\"confidence\" is 0");
  CHECK(contains(refusal(R"("cloud": "no such file", "distance": 1)"), "no such file' cannot be opened"));
  CHECK(contains(refusal(R"("cloud": "", "distance": 1)"), "\"cloud\" is no name of a file"));
  CHECK(contains(refusal(R"("cloud": 7, "distance": 1)"), "\"cloud\""));
  CHECK(contains(refusal(R"("cloud": "two_pipes.json", "distance": 1)"), "two_pipes.json': line 1: "));
  CHECK(contains(refusal(cloud + R"("distance": 1, "radius": 1)"), "unknown field \"radius\""));
}

TEST_CASE("cylinder_extraction: the result as JSON, text and CSV") {
  const std::string json = cylinder_extraction_json(one_cylinder(), ProblemId(7L), 15);
  CHECK(contains(json, R"("problem": "cylinder_extraction")"));
  CHECK(contains(json, R"("id": 7)"));
  CHECK(contains(json, R"("status": "numeric")"));
  CHECK(contains(json, R"("counts": {"points": 10, "cylinders": 1, "on_cylinders": 7})"));
  CHECK(contains(json, R"("direction": ["0", "0.6", "0.8"])"));
  CHECK(contains(json, R"("axis_point": ["1", "-2", "3"])"));
  CHECK(contains(json, R"("inliers": 7)"));
  CHECK(contains(json, R"("residual": "0.00123457")"));
  CHECK(contains(json, R"("confidence": "0.9912")"));
  CHECK(contains(json, "left out"));
  CHECK(cylinder_extraction_csv(one_cylinder(), 15) ==
        "direction_x,direction_y,direction_z,x,y,z,radius,length,inliers,residual\n"
        "0,0.6,0.8,1,-2,3,0.5,4,7,0.001234567\n");
  const std::string text = cylinder_extraction_text(one_cylinder());
  CHECK(text ==
        "Status: numeric: computed, not proven complete\n\nCloud a <b>.ply\n"
        "   10  points\n  = 7  on 1 cylinder\n  + 3  elsewhere\n\n"
        "Looked for: radius 0.05 to 2, 5 points or more within 0.01\n\n"
        "  #  direction      middle of the axis  radius  length  points  residual\n"
        "  1  (0, 0.6, 0.8)  (1, -2, 3)          0.5     4            7  0.00123\n");
  intersect::CylinderExtractionResult none;
  none.limit = "the time limit was reached during search";
  none.status = intersect::Status::incomplete;
  CHECK(contains(cylinder_extraction_text(none), "Status: incomplete: the time limit"));
  CHECK(contains(cylinder_extraction_text(none), "No cylinder was found."));
  CHECK(contains(cylinder_extraction_json(none, {}, 15), R"("cylinders": [])"));
}

TEST_CASE("cylinder_extraction: the picture has three views with the outlines of each cylinder") {
  const Picture picture = result_picture(cylinder_extraction_json(one_cylinder(), {}, 15));
  REQUIRE(picture.panels.size() == 3);
  for (const PicturePanel& panel : picture.panels) {
    // Two circles and two lines; seen from the front and from above the axis is no point.
    CHECK(panel.curves.size() == 4);
    CHECK(panel.equal_scales);
  }
  // From above: the lines are parallel to y, at the distance of the radius from x = 1, and 4 * 0.6 long.
  const PictureCurve& line = picture.panels[1].curves[2];
  REQUIRE(line.points.size() == 2);
  CHECK(std::abs(line.points[0][0] - 1) == doctest::Approx(0.5));
  CHECK(line.points[0][0] == doctest::Approx(line.points[1][0]));
  CHECK(std::abs(line.points[0][1] - line.points[1][1]) == doctest::Approx(2.4));
  REQUIRE(picture.tables.size() == 1);
  CHECK(picture.tables[0].rows.size() == 1);
  CHECK(contains(html_report(picture), "<table>"));
  CHECK(contains(svg_picture(picture), "From the front"));
  // Seen along the axis only the circles remain.
  auto upright = one_cylinder();
  upright.cylinders[0].direction = {0, 0, 1};
  CHECK(result_picture(cylinder_extraction_json(upright, {}, 15)).panels[1].curves.size() == 2);
}
