// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/observe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace stiction {

namespace {

template <class Quantity>
double largest(const Sample& sample, const Quantity& quantity) {
  if (sample.contacts.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  for (const ContactSample& contact : sample.contacts) value = std::max(value, quantity(contact));
  return value;
}

template <class Quantity>
double summed(const Sample& sample, const Quantity& quantity) {
  double value = 0.0;
  for (const ContactSample& contact : sample.contacts) value += quantity(contact);
  return value;
}

// As the other one of its two bodies feels it.
ContactSample from_the_other_side(ContactSample contact) {
  std::swap(contact.body, contact.obstacle);
  contact.normal = -contact.normal;
  contact.friction_force = -contact.friction_force;
  contact.slip = -contact.slip;
  contact.arm = -contact.arm;
  return contact;
}

bool with(const ContactSample& contact, const std::optional<Partner>& partner) {
  return !partner ||
         (contact.obstacle == partner->index && contact.against_body == partner->is_body);
}

bool of_itself(const ContactSample& contact) {
  return contact.against_body && contact.obstacle == contact.body;
}

std::vector<ContactSample> contacts_of(const std::vector<ContactSample>& all,
                                       const Watched& watched) {
  std::vector<ContactSample> own;
  for (const ContactSample& contact : all) {
    if (contact.body == watched.body && with(contact, watched.against)) own.push_back(contact);
    if (!contact.against_body || contact.obstacle != watched.body || of_itself(contact)) continue;
    const ContactSample felt = from_the_other_side(contact);
    if (with(felt, watched.against)) own.push_back(felt);
  }
  return own;
}

// Place and velocity of what another motion is told over: of an obstacle as the problem plans it.
std::pair<Vec3, Vec3> frame_of(const Engine& engine, const Problem& problem, double time,
                               const Partner& partner) {
  if (partner.is_body) {
    const BodyMotion motion = engine.body(partner.index);
    return {motion.position, motion.velocity};
  }
  const Obstacle& obstacle = problem.obstacles[partner.index];
  const double step = engine.time_step();
  return {obstacle.point + obstacle.motion.at(time),
          obstacle.motion.mean_velocity(time - step, step)};
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace

Sample Moment::sample(const Watched& watched) {
  Sample sample{time_, engine_.body(watched.body), {}, {}};
  if (watched.energies) {
    if (!energies_) energies_ = engine_.energies();
    sample.energies = *energies_;
  }
  if (watched.contacts) {
    if (!contacts_) contacts_ = engine_.contacts();
    sample.contacts = contacts_of(*contacts_, watched);
  }
  if (watched.relative_to) {
    const auto [place, velocity] = frame_of(engine_, problem_, time_, *watched.relative_to);
    sample.motion.position -= place;
    sample.motion.velocity -= velocity;
  }
  return sample;
}

std::vector<ContactSample> contacts_if_told(const Engine& engine) {
  try {
    return engine.contacts();
  } catch (const NotApplicable&) {
    return {};
  }
}

double fastest_slip(const Engine& engine) {
  double fastest = 0.0;
  for (const ContactSample& contact : engine.contacts()) {
    fastest = std::max(fastest, contact.slip.norm());
  }
  return fastest;
}

const std::vector<Observable>& observables() {
  using S = const Sample&;
  using D = const Vec3&;
  using enum Subject;
  static const std::vector<Observable> all = {
      {"position", "m", "centre of mass along the direction", kCentre, false, true,
       [](S, S at, D d) { return d.dot(at.motion.position); }},
      {"velocity", "m/s", "of the centre of mass along the direction", kCentre, false, true,
       [](S, S at, D d) { return d.dot(at.motion.velocity); }},
      {"speed", "m/s", "magnitude of the velocity of the centre of mass", kCentre, false, false,
       [](S, S at, D) { return at.motion.velocity.norm(); }},
      {"displacement", "m", "of the centre of mass along the direction, between from and at",
       kCentre, true, true,
       [](S from, S at, D d) { return d.dot(at.motion.position - from.motion.position); }},
      {"drift", "m", "distance of the centre of mass between from and at", kCentre, true, false,
       [](S from, S at, D) { return (at.motion.position - from.motion.position).norm(); }},
      {"mean-velocity", "m/s", "displacement over time, between from and at", kCentre, true, true,
       [](S from, S at, D d) {
         return d.dot(at.motion.position - from.motion.position) / (at.time - from.time);
       }},
      {"acceleration", "m/s²", "mean along the direction, between from and at", kCentre, true, true,
       [](S from, S at, D d) {
         return d.dot(at.motion.velocity - from.motion.velocity) / (at.time - from.time);
       }},
      {"rotation", "deg",
       "by which the body has turned about the direction, between from and at; "
       "whole turns do not count",
       kTurn, true, true,
       [](S from, S at, D d) {
         const Eigen::Quaterniond turn = at.motion.rotation * from.motion.rotation.conjugate();
         const double angle = 2.0 * std::atan2(d.dot(turn.vec()), turn.w());
         return degrees(std::remainder(angle, 2.0 * std::numbers::pi));
       },
       360.0},
      {"angular-velocity", "rad/s", "about the direction", kTurn, false, true,
       [](S, S at, D d) { return d.dot(at.motion.angular_velocity); }},
      {"kinetic-energy", "J", "of the whole scene", kScene, false, false,
       [](S, S at, D) { return at.energies.kinetic; }},
      {"total-energy", "J", "of the whole scene: kinetic, elastic and gravity", kScene, false,
       false,
       [](S, S at, D) { return at.energies.kinetic + at.energies.elastic + at.energies.gravity; }},
      {"normal-force", "N", "sum over the body's contacts, of magnitudes, whatever their normals",
       kContacts, false, false,
       [](S, S at, D) {
         return summed(at, [](const ContactSample& c) { return c.normal_force; });
       }},
      {"friction-force", "N", "on the body, sum over its contacts with others, along the direction",
       kContacts, false, true,
       [](S, S at, D d) {
         return summed(at, [&](const ContactSample& c) {
           return of_itself(c) ? 0.0 : d.dot(c.friction_force);
         });
       }},
      {"slip", "m/s",
       "fastest tangential slip of the body's contacts; without any there is none, and no check "
       "holds",
       kContacts, false, false,
       [](S, S at, D) { return largest(at, [](const ContactSample& c) { return c.slip.norm(); }); },
       0.0, true},
      {"penetration", "m",
       "deepest penetration of the body's contacts; without any there is none, and no check holds",
       kContacts, false, false,
       [](S, S at, D) { return largest(at, [](const ContactSample& c) { return -c.gap; }); }, 0.0,
       true},
      {"contacts", "1", "number of the body's contacts", kContacts, false, false,
       [](S, S at, D) { return static_cast<double>(at.contacts.size()); }},
  };
  return all;
}

ContactSlips slips_of(const std::vector<ContactSample>& contacts) {
  ContactSlips slips;
  for (const ContactSample& contact : contacts) {
    if (contact.normal_force == 0.0) continue;  // kept while it is open: nothing rubs
    const double slip = contact.slip.norm();
    slips.mean += slip;
    slips.fastest = std::max(slips.fastest, slip);
    ++slips.contacts;
    if (!contact.sticks) ++slips.sliding;
  }
  if (slips.contacts > 0) slips.mean /= slips.contacts;
  return slips;
}

}  // namespace stiction
