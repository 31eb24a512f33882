// SPDX-License-Identifier: BSD-3-Clause
#include "solver/contact/held_velocities.h"

#include <gtest/gtest.h>

#include <vector>

#include "solver/lanes/lane_width.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr Real kImpulse[] = {0.37, -0.11, 0.93};  // N s

std::vector<Velocity> some_velocities() {
  std::vector<Velocity> velocity;
  const auto numbers = test::noise(6, 1.0, 3);
  for (int v = 0; v < 6; ++v) velocity.push_back({numbers.col(v).cast<Real>(), Real(0.3 + v)});
  return velocity;
}

PairContact some_contact(bool of_triangle) {
  PairContact contact;
  contact.vertex = 4;
  const std::int32_t corner[] = {5, 0, 3, of_triangle ? 3 : 1};
  const Real weight[] = {Real(0.21), Real(0.43), Real(0.36), Real(of_triangle ? 0.0 : -0.07)};
  for (int k = 0; k < 4; ++k) {
    contact.partner[k] = corner[k];
    contact.weight[k] = weight[k];
  }
  contact.normal = Vec3(0.48, -0.6, 0.64);
  contact.depth = test::kNaN;  // it stands behind the normal, and goes through no sum
  return contact;
}

// Sum by sum, in memory.
void push(const PairContact& contact, const Vec3& impulse, bool react,
          std::vector<Velocity>& velocity) {
  Velocity& own = velocity[static_cast<std::size_t>(contact.vertex)];
  own.v += own.inverse_mass * impulse;
  for (int k = 0; react && k < 4; ++k) {
    Velocity& other = velocity[static_cast<std::size_t>(contact.partner[k])];
    other.v -= contact.weight[k] * other.inverse_mass * impulse;
  }
}

void expect_same(const std::vector<Velocity>& held, const std::vector<Velocity>& wanted,
                 int width) {
  for (std::size_t v = 0; v < held.size(); ++v) {
    EXPECT_EQ(held[v].v, wanted[v].v) << "vertex " << v << ", width " << width;
    EXPECT_EQ(held[v].inverse_mass, wanted[v].inverse_mass);
  }
}

TEST(HeldVelocities, HaveTheBitsOfThoseInMemory) {
  const Vec3 impulse(kImpulse[0], kImpulse[1], kImpulse[2]);
  for (const int width : lane_widths()) {
    for (const bool of_triangle : {false, true}) {
      for (const bool react : {false, true}) {
        const PairContact contact = some_contact(of_triangle);
        std::vector<Velocity> held = some_velocities(), wanted = some_velocities();
        Vec3 slip = Vec3::Zero();
        in_registers(
            width, [&]() __attribute__((always_inline)) {
              HeldVelocities velocities(contact, held);
              slip = vector_cast<Vec3>(velocities.slip());
              // Its fourth number is nobody's.
              velocities.push(PackedVec3(FourNumbers{impulse.x(), impulse.y(), impulse.z(), 7}),
                              react);
            });
        EXPECT_EQ(slip, slip_of(contact, wanted));
        push(contact, impulse, react, wanted);
        expect_same(held, wanted, width);
      }
    }
  }
}

TEST(HeldVelocities, OfEdgesHaveTheBitsOfThoseInMemory) {
  EdgeContact contact;
  const std::int32_t corner[] = {5, 0, 3, 1};
  const Real weight[] = {Real(0.21), Real(0.43), Real(0.43), Real(-0.07)};
  for (int k = 0; k < 4; ++k) {
    contact.partner[k] = corner[k];
    contact.weight[k] = weight[k];
  }
  contact.vertex[0] = 4;
  contact.vertex[1] = 2;
  contact.own_weight[0] = Real(0.3);
  contact.own_weight[1] = Real(0.7);
  contact.normal = Vec3(0.48, -0.6, 0.64);
  contact.depth = test::kNaN;
  const Vec3 impulse(kImpulse[0], kImpulse[1], kImpulse[2]);
  for (const int width : lane_widths()) {
    std::vector<Velocity> held = some_velocities(), wanted = some_velocities();
    Vec3 slip = Vec3::Zero();
    in_registers(
        width, [&]() __attribute__((always_inline)) {
          HeldEdgeVelocities velocities(contact, held);
          slip = vector_cast<Vec3>(velocities.slip());
          velocities.push(impulse);
        });
    EXPECT_EQ(slip, slip_of(contact, wanted));
    const auto add = [&](std::int32_t vertex, Real share) {
      Velocity& velocity = wanted[static_cast<std::size_t>(vertex)];
      velocity.v += share * velocity.inverse_mass * impulse;
    };
    for (int k = 0; k < 2; ++k) add(contact.vertex[k], contact.own_weight[k]);
    for (int k = 0; k < 4; ++k) add(contact.partner[k], -contact.weight[k]);
    expect_same(held, wanted, width);
  }
}

}  // namespace
}  // namespace stiction
