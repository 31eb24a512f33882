// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/corotational.h"

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

// Two elements side by side.
struct ElementPair {
  const Element& first;
  const Element& second;

  Lanes both(double Element::*what) const { return {first.*what, second.*what}; }
};

LaneMat3 side_by_side(const Mat3& first, const Mat3& second) {
  LaneMat3 m;
  for (int k = 0; k < 9; ++k) m(k) = {first(k), second(k)};
  return m;
}

LaneMat3 inverse_rest_edges(const ElementPair& pair) {
  return side_by_side(inverse_rest_edges(pair.first), inverse_rest_edges(pair.second));
}

template <class Field>
LaneMat3 differences(const ElementPair& pair, const Field& field) {
  return side_by_side(differences(pair.first, field), differences(pair.second, field));
}

Mat3 one_of(const LaneMat3& lanes, int lane) {
  return lanes.unaryExpr([lane](const Lanes& entry) { return entry[lane]; });
}

void set_lane(const Mat3& one, int lane, LaneMat3& lanes) {
  for (int k = 0; k < 9; ++k) lanes(k).value[lane] = one(k);
}

// V (2μ E + λ tr(E) I)
[[gnu::always_inline]] inline LaneMat3 hooke(const ElementPair& pair, const LaneMat3& strain) {
  LaneMat3 stress = (2.0 * pair.both(&Element::mu_volume)) * strain;
  const Lanes pressure = pair.both(&Element::lambda_volume) * strain.trace();
  for (int k = 0; k < 3; ++k) stress(k, k) += pressure;
  return stress;
}

// `elastic_stress` of one lane by singular values.
[[gnu::noinline]] void flat_stress(const Element& element, int lane, const LaneMat3& f, LaneMat3& a,
                                   LaneMat3& b) {
  const Mat3 one = one_of(f, lane);
  const Mat3 r = polar_rotation_by_svd(one);
  const double stretch = r.cwiseProduct(one).sum();
  const double two_mu = 2.0 * element.mu_volume;
  set_lane(two_mu * Mat3::Identity(), lane, a);
  set_lane((element.lambda_volume * (stretch - 3.0) - two_mu) * r, lane, b);
}

// V (2μ(F − R) + λ(tr S − 3)R), which is V R (2μ(S − I) + λ tr(S − I) I) without the product RᵀF,
// as F a + b with a symmetric.
[[gnu::always_inline]] inline void elastic_stress(const ElementPair& pair, const LaneMat3& f,
                                                  LaneMat3& a, LaneMat3& b) {
  const Lanes two_mu = 2.0 * pair.both(&Element::mu_volume);
  const LaneMat3 c = gram(f), cof = cofactor(f);
  const Lanes j = f.col(0).dot(cof.col(0));
  const PolarTerms<Lanes> r = polar_terms(c, j);
  const Lanes k = pair.both(&Element::lambda_volume) * (r.stretch - 3.0) - two_mu;
  a = (k * r.gram) * c;
  for (int i = 0; i < 3; ++i) a(i, i) += two_mu + k * r.f;
  b = (k * r.cofactor) * cof;
  // No number is flat too.
  if (!(j[0] > kFlattest)) [[unlikely]]
    flat_stress(pair.first, 0, f, a, b);
  if (!(j[1] > kFlattest)) [[unlikely]]
    flat_stress(pair.second, 1, f, a, b);
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
  for (std::size_t e = 0; e < elements.size(); e += 2) {
    const bool alone = e + 1 == elements.size();
    const ElementPair pair{elements[e], elements[alone ? e : e + 1]};
    const LaneMat3 inverse = inverse_rest_edges(pair);
    const LaneMat3 f = differences(pair, x) * inverse;
    // V P = F a + b
    LaneMat3 a, b;
    elastic_stress(pair, f, a, b);
    if (pair.first.damping_time > 0.0 || pair.second.damping_time > 0.0) {
      const LaneMat3 rate = f.transpose() * (differences(pair, v) * inverse);
      const LaneMat3 strain_rate = 0.5 * (rate + rate.transpose());
      a += pair.both(&Element::damping_time) * hooke(pair, strain_rate);
    }
    const LaneMat3 stress = f * a + b;
    const LaneMat3 corner = -stress * inverse.transpose();
    add_corner_forces(pair.first, one_of(corner, 0), force);
    if (!alone) add_corner_forces(pair.second, one_of(corner, 1), force);
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
