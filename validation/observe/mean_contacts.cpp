// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/mean_contacts.h"

namespace stiction {

void MeanContacts::add(const std::vector<ContactSample>& contacts) {
  ++looks_;
  for (const ContactSample& contact : contacts) {
    if (!(contact.normal_force > 0.0)) continue;
    Sum& sum = sums_[{contact.body, contact.obstacle, contact.against_body, contact.point}];
    sum.force += contact.normal_force;
    sum.moment += contact.normal_force * contact.position;
    sum.normal += contact.normal_force * contact.normal;
  }
}

std::vector<ContactSample> MeanContacts::mean() const {
  std::vector<ContactSample> contacts;
  for (const auto& [key, sum] : sums_) {
    ContactSample& contact = contacts.emplace_back();
    std::tie(contact.body, contact.obstacle, contact.against_body, contact.point) = key;
    contact.normal_force = sum.force / static_cast<double>(looks_);
    contact.position = sum.moment / sum.force;
    contact.normal = sum.normal.normalized();
  }
  return contacts;
}

}  // namespace stiction
