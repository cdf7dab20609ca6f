// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <ctime>

#include <pcl/features/normal_3d.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/sac_segmentation.h>

#include "cylinder_solvers.hpp"

namespace eliminant::comparisons {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

constexpr int neighbours = 24;
constexpr int most_iterations = 5000;

Normals::Ptr normals_of(const Cloud::Ptr& cloud) {
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(neighbours);
  auto normals = std::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

}  // namespace

CylinderAnswer pcl_cylinders(const test::PipeScene& scene, double limit_seconds) {
  const std::clock_t start = std::clock();
  const auto elapsed = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
  auto cloud = std::make_shared<Cloud>();
  for (const auto& [x, y, z] : scene.points)
    cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  auto normals = normals_of(cloud);
  const std::size_t fewest = std::max<std::size_t>(50, scene.points.size() / 500);
  CylinderAnswer answer;
  while (cloud->size() >= fewest) {
    if (elapsed() > limit_seconds) {
      answer.stopped = true;
      break;
    }
    pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> search;
    search.setModelType(pcl::SACMODEL_CYLINDER);
    search.setMethodType(pcl::SAC_RANSAC);
    search.setOptimizeCoefficients(true);
    search.setNormalDistanceWeight(0.1);
    search.setMaxIterations(most_iterations);
    search.setProbability(0.99);
    search.setDistanceThreshold(scene.distance);
    search.setRadiusLimits(0.9 * scene.recipe.smallest_radius, 1.1 * scene.recipe.largest_radius);
    search.setInputCloud(cloud);
    search.setInputNormals(normals);
    auto inliers = std::make_shared<pcl::PointIndices>();
    pcl::ModelCoefficients model;
    search.segment(*inliers, model);
    if (inliers->indices.size() < fewest || model.values.size() < 7) break;
    const auto value = [&](std::size_t i) { return static_cast<double>(model.values[i]); };
    answer.cylinders.push_back({{value(3), value(4), value(5)}, {value(0), value(1), value(2)}, value(6), 0});
    const auto remove = [&](auto& points) {
      using Points = typename std::decay_t<decltype(*points)>;
      pcl::ExtractIndices<typename Points::PointType> extract;
      extract.setInputCloud(points);
      extract.setIndices(inliers);
      extract.setNegative(true);
      auto rest = std::make_shared<Points>();
      extract.filter(*rest);
      points = rest;
    };
    remove(cloud);
    remove(normals);
  }
  answer.seconds = elapsed();
  return answer;
}

}  // namespace eliminant::comparisons
