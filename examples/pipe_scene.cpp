// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a generated scene of pipes and the truth about it:
//   pipe_scene NUMBER CLOUD.ply TRUTH.csv PROBLEM.json
// NUMBER is 1 to 20 for the scenes of docs/cylinder-extraction.md, 21 for the one of 200,000 points. The cloud has the
// index of its pipe as label of each point.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <eliminant/io/point_clouds/ply_file.hpp>
#include <support/pipe_scenes.hpp>

namespace {

using namespace eliminant;

void write(const std::string& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

std::string truth_of(const test::PipeScene& scene) {
  std::string out = "direction_x,direction_y,direction_z,x,y,z,radius,length\n";
  for (const test::ScenePipe& pipe : scene.pipes) {
    for (const double number : pipe.direction) out += std::to_string(number) + ",";
    for (const double number : pipe.middle) out += std::to_string(number) + ",";
    out += std::to_string(pipe.radius) + "," + std::to_string(pipe.length) + "\n";
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::vector<test::SceneRecipe> recipes = test::acceptance_scenes();
    recipes.push_back(test::speed_scene());
    const long number = argc == 5 ? std::strtol(argv[1], nullptr, 10) : 0;
    if (number < 1 || number > static_cast<long>(recipes.size())) {
      std::fprintf(stderr, "usage: pipe_scene NUMBER CLOUD.ply TRUTH.csv PROBLEM.json, NUMBER from 1 to 21\n");
      return 2;
    }
    const test::PipeScene scene = test::pipe_scene(recipes[static_cast<std::size_t>(number - 1)]);
    const std::vector<std::int32_t> labels(scene.labels.begin(), scene.labels.end());
    write(argv[2], io::labelled_ply(scene.points, labels));
    write(argv[3], truth_of(scene));
    const std::string cloud = std::filesystem::absolute(argv[2]).string();
    write(argv[4], "{\"problem\": \"cylinder_extraction\", \"cloud\": \"" + cloud + "\", \"distance\": \"" +
                       std::to_string(scene.distance) + "\"}\n");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pipe_scene: %s\n", error.what());
    return 1;
  }
}
