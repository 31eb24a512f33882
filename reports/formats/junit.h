// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// JUnit XML (UTF-8) for CI servers: one testsuite a case family, one testcase a record, `time` in
/// CPU seconds. A failing record carries its worst check as the failure's message and the
/// tolerance's reason, worst offender and notes as its text; a record that does not apply is
/// `skipped`; one that is only shown counts as passed. Every check stands in `system-out`.
std::string junit_xml(const std::vector<Record>& records);

}  // namespace stiction
