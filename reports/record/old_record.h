// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/record/json_field.h"
#include "reports/record/record.h"

namespace stiction {

/// A check as schema versions 1 to 3 had it: its scale, 1 where none was given, and digits from it
/// always; a cause (`limit` in version 2), and from version 3 on the two ends of a band.
Judgement read_old_check(const JsonField& field);

/// Until version 3 figures were checks that were shown and whose reason began with "none", failures
/// were notes "failed: …": makes them figures and failures.
void split_old_checks_and_notes(Record& record);

}  // namespace stiction
