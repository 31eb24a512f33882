// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/corotational.h"

#include "solver/elasticity/rotation.h"

namespace stiction {

namespace {

// Columns a₁ − a₀, a₂ − a₀, a₃ − a₀ of a vertex field.
template <class Field>
Mat3 differences(const Element& element, const Field& field) {
  const Vec3& a0 = field(element.vertex[0]);
  Mat3 d;
  for (int k = 0; k < 3; ++k) d.col(k) = field(element.vertex[k + 1]) - a0;
  return d;
}

Mat3 inverse_rest_edges(const Element& element) {
  return Eigen::Map<const Mat3>(element.inverse_rest_edges);
}

// V (2μ E + λ tr(E) I)
[[gnu::always_inline]] inline Mat3 hooke(const Element& element, const Mat3& strain) {
  Mat3 stress = 2.0 * element.mu_volume * strain;
  stress.diagonal().array() += element.lambda_volume * strain.trace();
  return stress;
}

}  // namespace

void add_corotational_forces(const std::vector<Element>& elements, const State& state,
                             std::vector<Vec3>& force) {
  const auto x = [&](int v) -> const Vec3& {
    return state.position[static_cast<std::size_t>(v)].x;
  };
  const auto v = [&](int k) -> const Vec3& {
    return state.velocity[static_cast<std::size_t>(k)].v;
  };
  for (const Element& element : elements) {
    const Mat3 inverse = inverse_rest_edges(element);
    const Mat3 f = differences(element, x) * inverse;
    const Mat3 r = polar_rotation(f);
    Mat3 stress = r * hooke(element, r.transpose() * f - Mat3::Identity());
    if (element.damping_time > 0.0) {
      const Mat3 rate = f.transpose() * (differences(element, v) * inverse);
      const Mat3 strain_rate = 0.5 * (rate + rate.transpose());
      stress += element.damping_time * (f * hooke(element, strain_rate));
    }
    const Mat3 corner = -stress * inverse.transpose();
    for (int k = 0; k < 3; ++k)
      force[static_cast<std::size_t>(element.vertex[k + 1])] += corner.col(k);
    force[static_cast<std::size_t>(element.vertex[0])] -= corner.rowwise().sum();
  }
}

double elastic_energy(const std::vector<Element>& elements, const std::vector<Position>& position) {
  const auto x = [&](int v) -> const Vec3& { return position[static_cast<std::size_t>(v)].x; };
  double energy = 0.0;
  for (const Element& element : elements) {
    const Mat3 f = differences(element, x) * inverse_rest_edges(element);
    const Mat3 strain = polar_rotation(f).transpose() * f - Mat3::Identity();
    energy += element.mu_volume * strain.squaredNorm() +
              0.5 * element.lambda_volume * strain.trace() * strain.trace();
  }
  return energy;
}

}  // namespace stiction
