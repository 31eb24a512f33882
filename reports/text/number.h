// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace stiction {

/// Numbers as people read them. All are independent of the locale; NaN is "nan" whatever its sign,
/// infinities are "inf" and "-inf", negative zero is "0".

/// Six significant digits: measured and expected values.
std::string format_value(double value);

/// Two significant digits: errors and tolerances.
std::string format_error(double error);

/// Digits of agreement, one decimal.
std::string format_digits(double digits);

/// A time, s or ns: three significant digits, no exponent from 0.001 up.
std::string format_seconds(double seconds);

/// A duration: "45 s", "2 min 05 s", "1 h 20 min".
std::string duration_text(double seconds);

/// Whole number with "," between thousands.
std::string format_count(std::uint64_t count);

/// As format_count, with spaces: "100 000", for tables.
std::string spaced_count(std::uint64_t count);

/// Of so many nanoseconds: "9.9", "120".
std::string format_nanoseconds(double value);

/// Shortest decimal that reads back as the same double (machine-readable outputs). Keeps "-0".
std::string format_exact(double value);

/// `number` with its unit behind it; the dimensionless "1" and an empty unit are left out.
std::string with_unit(const std::string& number, const std::string& unit);

}  // namespace stiction
