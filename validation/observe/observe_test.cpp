// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/observe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace stiction {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Two samples of whole numbers, so that nothing is rounded.
Sample early() {
  Sample sample;
  sample.time = 1.0;
  sample.motion = {Vec3(1, 2, 3), Vec3(0, 4, 0)};
  return sample;
}

Sample late() {
  Sample sample;
  sample.time = 3.0;
  sample.motion = {Vec3(5, 2, 0), Vec3(3, 4, 0), Eigen::Quaterniond(0, 1, 0, 0), Vec3(6, 1, 1)};
  sample.energies = {.kinetic = 7.0, .gravity = -2.0, .elastic = 1.0};
  ContactSample contact;
  contact.normal.setConstant(kNaN);  // unused
  contact.gap = -0.25;
  contact.normal_force = 4.0;
  contact.friction_force = Vec3(-2, 0, 0);
  contact.slip = Vec3(3, 4, 0);
  contact.obstacle = 7;
  sample.contacts = {contact, contact};
  sample.contacts[1].gap = 0.5;
  sample.contacts[1].friction_force = Vec3(-1, 5, 0);
  sample.contacts[1].slip = Vec3::Zero();
  return sample;
}

struct Seen {
  const char* name;
  double value;
};

class ObservableOfTwoSamples : public testing::TestWithParam<Seen> {};

TEST_P(ObservableOfTwoSamples, IsWhatOneComputesByHand) {
  for (const Observable& observable : observables()) {
    if (observable.name != GetParam().name) continue;
    Sample from = early();
    // What an observable doesn't say that it uses is not there.
    if (!observable.over_window) from.motion = {Vec3::Constant(kNaN), Vec3::Constant(kNaN)};
    const Vec3 direction = observable.in_direction ? Vec3(1, 0, 0) : Vec3::Constant(kNaN).eval();
    EXPECT_EQ(observable.measure(from, late(), direction), GetParam().value);
    return;
  }
  FAIL() << "there is no observable " << GetParam().name;
}

const Seen kSeen[] = {{"position", 5.0},        {"velocity", 3.0},     {"speed", 5.0},
                      {"displacement", 4.0},    {"drift", 5.0},        {"mean-velocity", 2.0},
                      {"acceleration", 1.5},    {"rotation", 180.0},   {"angular-velocity", 6.0},
                      {"kinetic-energy", 7.0},  {"total-energy", 6.0}, {"normal-force", 8.0},
                      {"friction-force", -3.0}, {"slip", 5.0},         {"penetration", 0.25},
                      {"contacts", 2.0}};

INSTANTIATE_TEST_SUITE_P(Names, ObservableOfTwoSamples, testing::ValuesIn(kSeen),
                         [](const auto& one) {
                           std::string name = one.param.name;
                           for (char& letter : name) letter = letter == '-' ? '_' : letter;
                           return name;
                         });

TEST(Observables, AreAllTestedAboveAndHaveNamesUnitsAndMeanings) {
  std::set<std::string> tested;
  for (const Seen& seen : kSeen) tested.insert(seen.name);
  std::set<std::string> names;
  for (const Observable& observable : observables()) {
    EXPECT_TRUE(names.insert(observable.name).second) << observable.name << " is there twice";
    EXPECT_FALSE(observable.unit.empty()) << observable.name;
    EXPECT_FALSE(observable.meaning.empty()) << observable.name;
  }
  EXPECT_EQ(names, tested);
}

TEST(Observables, RotationIsAboutTheDirectionAlone) {
  const auto turned = [](double degrees, const Vec3& axis) {
    Sample sample;
    const double angle = degrees * std::numbers::pi / 180.0;
    sample.motion.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
    return sample;
  };
  const auto rotation = std::find_if(observables().begin(), observables().end(),
                                     [](const Observable& one) { return one.name == "rotation"; });
  const Sample from = turned(30.0, Vec3::UnitZ());
  EXPECT_NEAR(rotation->measure(from, turned(-20.0, Vec3::UnitZ()), Vec3::UnitZ()), -50.0, 1e-12);
  EXPECT_NEAR(rotation->measure(from, turned(200.0, Vec3::UnitZ()), Vec3::UnitZ()), 170.0, 1e-12);
  EXPECT_NEAR(rotation->measure(from, turned(220.0, Vec3::UnitZ()), Vec3::UnitZ()), -170.0, 1e-12);
  EXPECT_NEAR(rotation->measure(from, turned(90.0, Vec3::UnitZ()), Vec3::UnitX()), 0.0, 1e-12);
}

TEST(Observables, FrictionOfABodyWithItselfIsNoForceOnIt) {
  Sample sample = late();
  for (ContactSample& contact : sample.contacts) {
    contact.against_body = true;
    contact.obstacle = contact.body;
  }
  for (const Observable& observable : observables()) {
    if (observable.name != "friction-force") continue;
    EXPECT_EQ(observable.measure(sample, sample, Vec3::UnitX()), 0.0);
  }
}

TEST(Observables, OfABodyWithoutContactsForcesAreZeroAndASlipIsNoNumber) {
  Sample free = late();
  free.contacts.clear();
  for (const Observable& observable : observables()) {
    for (const char* name : {"slip", "penetration"}) {
      if (observable.name == name) {
        EXPECT_TRUE(std::isnan(observable.measure(free, free, Vec3::UnitX()))) << name;
      }
    }
    for (const char* name : {"normal-force", "friction-force", "contacts"}) {
      if (observable.name == name) {
        EXPECT_EQ(observable.measure(free, free, Vec3::UnitX()), 0.0) << name;
      }
    }
  }
}

}  // namespace
}  // namespace stiction
