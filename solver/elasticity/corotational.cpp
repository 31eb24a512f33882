// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/corotational.h"

#include <algorithm>

#include "solver/elasticity/lanes.h"
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

using LaneMat3 = Eigen::Matrix3<Lanes>;

void set_lane(const Mat3& one, int lane, LaneMat3& lanes) {
  for (int k = 0; k < 9; ++k) lanes(k).value[lane] = one(k);
}

Mat3 one_of(const LaneMat3& lanes, int lane) {
  return lanes.unaryExpr([lane](const Lanes& entry) { return entry[lane]; });
}

// As many elements side by side as there are lanes; where fewer are left, the last again.
struct ElementGroup {
  const Element* of[Lanes::kCount];

  ElementGroup(const Element* first, std::size_t count) {
    for (std::size_t lane = 0; lane < Lanes::kCount; ++lane) {
      of[lane] = first + std::min(lane, count - 1);
    }
  }

  Lanes all(Real Element::*what) const {
    Lanes lanes;
    for (int lane = 0; lane < Lanes::kCount; ++lane) lanes.value[lane] = of[lane]->*what;
    return lanes;
  }
  bool any_damping() const {
    return std::any_of(of, of + Lanes::kCount,
                       [](const Element* element) { return element->damping_time > 0.0; });
  }
};

// Of a group: the matrices that `make` gives for each of its elements.
template <class Make>
LaneMat3 side_by_side(const ElementGroup& group, const Make& make) {
  LaneMat3 m;
  for (int lane = 0; lane < Lanes::kCount; ++lane) set_lane(make(*group.of[lane]), lane, m);
  return m;
}

LaneMat3 inverse_rest_edges(const ElementGroup& group) {
  return side_by_side(group, [](const Element& element) { return inverse_rest_edges(element); });
}

template <class Field>
LaneMat3 differences(const ElementGroup& group, const Field& field) {
  return side_by_side(group, [&](const Element& element) { return differences(element, field); });
}

// V (2μ E + λ tr(E) I)
[[gnu::always_inline]] inline LaneMat3 hooke(const ElementGroup& group, const LaneMat3& strain) {
  LaneMat3 stress = (2 * group.all(&Element::mu_volume)) * strain;
  const Lanes pressure = group.all(&Element::lambda_volume) * strain.trace();
  for (int k = 0; k < 3; ++k) stress(k, k) += pressure;
  return stress;
}

// `elastic_stress` of one lane by singular values.
[[gnu::noinline]] void flat_stress(const Element& element, int lane, const LaneMat3& f, LaneMat3& a,
                                   LaneMat3& b) {
  const Mat3 one = one_of(f, lane);
  const Mat3 r = polar_rotation_by_svd(one);
  const Real stretch = r.cwiseProduct(one).sum();
  const Real two_mu = 2 * element.mu_volume;
  set_lane(two_mu * Mat3::Identity(), lane, a);
  set_lane((element.lambda_volume * (stretch - 3) - two_mu) * r, lane, b);
}

// V (2μ(F − R) + λ(tr S − 3)R), which is V R (2μ(S − I) + λ tr(S − I) I) without the product RᵀF,
// as F a + b with a symmetric.
[[gnu::always_inline]] inline void elastic_stress(const ElementGroup& group, const LaneMat3& f,
                                                  LaneMat3& a, LaneMat3& b) {
  const Lanes two_mu = 2 * group.all(&Element::mu_volume);
  const LaneMat3 c = gram(f), cof = cofactor(f);
  const Lanes j = f.col(0).dot(cof.col(0));
  const PolarTerms<Lanes> r = polar_terms(c, j);
  const Lanes k = group.all(&Element::lambda_volume) * (r.stretch - 3) - two_mu;
  a = (k * r.gram) * c;
  for (int i = 0; i < 3; ++i) a(i, i) += two_mu + k * r.f;
  b = (k * r.cofactor) * cof;
  // No number is flat too.
  for (int lane = 0; lane < Lanes::kCount; ++lane) {
    if (!(j[lane] > kFlattest)) [[unlikely]]
      flat_stress(*group.of[lane], lane, f, a, b);
  }
}

void add_corner_forces(const Element& element, const Mat3& corner, std::vector<Vec3>& force) {
  for (int k = 0; k < 3; ++k)
    force[static_cast<std::size_t>(element.vertex[k + 1])] += corner.col(k);
  force[static_cast<std::size_t>(element.vertex[0])] -= corner.rowwise().sum();
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
  constexpr std::size_t kLanes = Lanes::kCount;
  for (std::size_t e = 0; e < elements.size(); e += kLanes) {
    const std::size_t count = std::min(kLanes, elements.size() - e);
    const ElementGroup group(&elements[e], count);
    const LaneMat3 inverse = inverse_rest_edges(group);
    const LaneMat3 f = differences(group, x) * inverse;
    // V P = F a + b
    LaneMat3 a, b;
    elastic_stress(group, f, a, b);
    if (group.any_damping()) {
      const LaneMat3 rate = f.transpose() * (differences(group, v) * inverse);
      const LaneMat3 strain_rate = Real(0.5) * (rate + rate.transpose());
      a += group.all(&Element::damping_time) * hooke(group, strain_rate);
    }
    const LaneMat3 stress = f * a + b;
    const LaneMat3 corner = -stress * inverse.transpose();
    for (std::size_t lane = 0; lane < count; ++lane) {
      add_corner_forces(*group.of[lane], one_of(corner, static_cast<int>(lane)), force);
    }
  }
}

double elastic_energy(const std::vector<Element>& elements, const std::vector<Position>& position) {
  const auto x = [&](int v) -> const Vec3& { return position[static_cast<std::size_t>(v)].x; };
  double energy = 0.0;
  for (const Element& element : elements) {
    const Mat3 f = differences(element, x) * inverse_rest_edges(element);
    const Mat3 strain = polar_rotation(f).transpose() * f - Mat3::Identity();
    energy += element.mu_volume * strain.squaredNorm() +
              Real(0.5) * element.lambda_volume * strain.trace() * strain.trace();
  }
  return energy;
}

}  // namespace stiction
