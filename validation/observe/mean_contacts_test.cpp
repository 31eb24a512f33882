// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/mean_contacts.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

ContactSample contact(std::int64_t point, double force, double x) {
  ContactSample sample;
  sample.point = point;
  sample.normal_force = force;
  sample.position = Vec3(x, 0.0, 0.0);
  sample.normal = Vec3::UnitZ();
  return sample;
}

TEST(MeanContacts, ForcesAndPlacesByForce) {
  MeanContacts contacts;
  contacts.add({contact(3, 1.0, 0.0), contact(5, 2.0, 7.0)});
  contacts.add({contact(3, 3.0, 1.0)});
  contacts.add({contact(5, 0.0, 99.0)});
  const auto mean = contacts.mean();
  ASSERT_EQ(mean.size(), 2U);
  EXPECT_EQ(mean[0].point, 3);
  EXPECT_NEAR(mean[0].normal_force, 4.0 / 3.0, 1e-15);
  EXPECT_NEAR(mean[0].position.x(), 0.75, 1e-15);
  EXPECT_EQ(mean[1].point, 5);
  EXPECT_NEAR(mean[1].normal_force, 2.0 / 3.0, 1e-15);
  EXPECT_EQ(mean[1].position.x(), 7.0);
}

TEST(MeanContacts, TellsBodiesFromObstaclesOfTheSameNumber) {
  MeanContacts contacts;
  ContactSample against = contact(3, 1.0, 0.0);
  against.against_body = true;
  contacts.add({contact(3, 1.0, 0.0), against});
  EXPECT_EQ(contacts.mean().size(), 2U);
}

TEST(MeanContacts, NothingLookedAtIsNothing) { EXPECT_TRUE(MeanContacts().mean().empty()); }

}  // namespace
}  // namespace stiction
