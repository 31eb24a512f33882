// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/observe.h"

#include <algorithm>

namespace stiction {

namespace {

template <class Quantity>
double largest(const Sample& sample, const Quantity& quantity) {
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

}  // namespace

Sample sample_of(const Engine& engine, double time, std::size_t body) {
  Sample sample{time, engine.body(body), engine.energies(), {}};
  for (const ContactSample& contact : engine.contacts()) {
    if (contact.body == body) sample.contacts.push_back(contact);
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
  static const std::vector<Observable> all = {
      {"position", "m", "centre of mass along the direction", false, true, false,
       [](S, S at, D d) { return d.dot(at.motion.position); }},
      {"velocity", "m/s", "of the centre of mass along the direction", false, true, false,
       [](S, S at, D d) { return d.dot(at.motion.velocity); }},
      {"speed", "m/s", "magnitude of the velocity of the centre of mass", false, false, false,
       [](S, S at, D) { return at.motion.velocity.norm(); }},
      {"displacement", "m", "of the centre of mass along the direction, between from and at", true,
       true, false,
       [](S from, S at, D d) { return d.dot(at.motion.position - from.motion.position); }},
      {"drift", "m", "distance of the centre of mass between from and at", true, false, false,
       [](S from, S at, D) { return (at.motion.position - from.motion.position).norm(); }},
      {"mean-velocity", "m/s", "displacement over time, between from and at", true, true, false,
       [](S from, S at, D d) {
         return d.dot(at.motion.position - from.motion.position) / (at.time - from.time);
       }},
      {"acceleration", "m/s²", "mean along the direction, between from and at", true, true, false,
       [](S from, S at, D d) {
         return d.dot(at.motion.velocity - from.motion.velocity) / (at.time - from.time);
       }},
      {"kinetic-energy", "J", "of the whole scene", false, false, true,
       [](S, S at, D) { return at.energies.kinetic; }},
      {"total-energy", "J", "of the whole scene: kinetic, elastic and gravity", false, false, true,
       [](S, S at, D) { return at.energies.kinetic + at.energies.elastic + at.energies.gravity; }},
      {"normal-force", "N", "sum over the body's contacts", false, false, false,
       [](S, S at, D) {
         return summed(at, [](const ContactSample& c) { return c.normal_force; });
       }},
      {"friction-force", "N", "sum over the body's contacts, along the direction", false, true,
       false,
       [](S, S at, D d) {
         return summed(at, [&](const ContactSample& c) { return d.dot(c.friction_force); });
       }},
      {"slip", "m/s", "fastest tangential slip of the body's contacts", false, false, false,
       [](S, S at, D) {
         return largest(at, [](const ContactSample& c) { return c.slip.norm(); });
       }},
      {"penetration", "m", "deepest penetration of the body's contacts", false, false, false,
       [](S, S at, D) { return largest(at, [](const ContactSample& c) { return -c.gap; }); }},
      {"contacts", "1", "number of the body's contacts", false, false, false,
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
