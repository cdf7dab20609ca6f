// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/contact_conditions.hpp>

#include <array>

#include <Eigen/Geometry>

namespace eliminant::bridge {

namespace {

using Eigen::Vector3d;

Vector3d vector_of(const Array4d& a) { return {a[0], a[1], a[2]}; }

}  // namespace

ContactConditions contact_conditions(PatchJets& first, PatchJets& second, const Eigen::Vector4d& at) {
  const PatchJets::Value a = first.at(at[0], at[1]);
  const PatchJets::Value b = second.at(at[2], at[3]);
  const std::array<Vector3d, 2> da{vector_of(a.first[0]), vector_of(a.first[1])};
  const std::array<Vector3d, 2> db{vector_of(b.first[0]), vector_of(b.first[1])};
  const auto second_of = [](const PatchJets::Value& value, std::size_t i, std::size_t j) {
    return vector_of(value.second[i + j]);
  };
  const Vector3d difference = vector_of(a.point - b.point);
  const Vector3d normal = db[0].cross(db[1]);
  ContactConditions result;
  result.gap = normal.dot(difference) / normal.norm();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto row = static_cast<long>(i);
    result.value[row] = normal.dot(da[i]);
    result.value[2 + row] = difference.dot(db[i]);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto column = static_cast<long>(k);
      const Vector3d turning = second_of(b, 0, k).cross(db[1]) + db[0].cross(second_of(b, 1, k));
      result.jacobian(row, column) = normal.dot(second_of(a, i, k));
      result.jacobian(row, 2 + column) = turning.dot(da[i]);
      result.jacobian(2 + row, column) = da[k].dot(db[i]);
      result.jacobian(2 + row, 2 + column) = difference.dot(second_of(b, i, k)) - db[k].dot(db[i]);
    }
  }
  return result;
}

}  // namespace eliminant::bridge
