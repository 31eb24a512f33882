// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/markdown_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "reports/text/check_text.h"
#include "reports/text/markdown_text.h"
#include "reports/text/number.h"

namespace stiction {
namespace {

// Distinct texts in the order they came, each with the labels of the cases that have it.
class SharedTexts {
 public:
  void add(const std::string& text, const std::string& label) {
    if (text.empty()) return;
    const auto found = std::find_if(texts_.begin(), texts_.end(),
                                    [&](const Entry& entry) { return entry.text == text; });
    if (found == texts_.end()) {
      texts_.push_back({text, {label}});
    } else if (found->labels.back() != label) {
      found->labels.push_back(label);
    }
  }

  struct Entry {
    std::string text;
    std::vector<std::string> labels;
  };
  const std::vector<Entry>& entries() const { return texts_; }

  // The mark of a text's footnote (a, b, …, z, aa, …); empty when one text serves all.
  std::string mark(const std::string& text) const {
    if (texts_.size() < 2) return "";
    const auto found = std::find_if(texts_.begin(), texts_.end(),
                                    [&](const Entry& entry) { return entry.text == text; });
    return found == texts_.end() ? "" : mark(static_cast<std::size_t>(found - texts_.begin()));
  }
  static std::string mark(std::size_t index) {
    constexpr std::size_t kLetters = 26;
    std::string letters(1, static_cast<char>('a' + index % kLetters));
    return index < kLetters ? letters : mark(index / kLetters - 1) + letters;
  }

 private:
  std::vector<Entry> texts_;
};

// What the checks of one table share.
using ClaimKey = std::tuple<std::string, std::string, ReferenceKind, std::string>;

ClaimKey key_of(const Judgement& check) {
  return {check.claim.statement, check.claim.formula, check.claim.kind, check.claim.source};
}

std::vector<ClaimKey> claims_of(const Family& family) {
  std::vector<ClaimKey> claims;  // in the order they came; a family has few
  for (const Record* record : family.records) {
    for (const Judgement& check : record->checks) {
      const ClaimKey key = key_of(check);
      if (std::find(claims.begin(), claims.end(), key) == claims.end()) claims.push_back(key);
    }
  }
  return claims;
}

template <typename Visit>
void for_checks(const Family& family, const ClaimKey& key, Visit visit) {
  for (const Record* record : family.records) {
    for (const Judgement& check : record->checks) {
      if (key_of(check) == key) visit(*record, check);
    }
  }
}

std::string claim_text(const ClaimKey& key, const SharedTexts& reasons, const SharedTexts& causes) {
  const auto& [claim, formula, kind, source] = key;
  std::string text =
      fmt::format("**Claim.** {}\n\n", claim.empty() ? "(none given)" : markdown_escaped(claim));
  if (!formula.empty()) text += fmt::format("- Formula: {}\n", markdown_escaped(formula));
  text += fmt::format("- Reference: {}{}{}\n", to_string(kind), source.empty() ? "" : "; ",
                      markdown_escaped(source));
  for (const SharedTexts::Entry& reason : reasons.entries()) {
    const std::string mark = reasons.mark(reason.text);
    text += fmt::format("- Tolerance{}: {}\n", mark.empty() ? "" : " (" + mark + ")",
                        markdown_escaped(reason.text));
  }
  for (const SharedTexts::Entry& cause : causes.entries()) {
    text += fmt::format("- Cause: {}\n", markdown_escaped(cause.text));
  }
  return text + "\n";
}

std::string claim_section(const Family& family, const ClaimKey& key) {
  SharedTexts reasons, causes;
  for_checks(family, key, [&](const Record& record, const Judgement& check) {
    reasons.add(check.claim.reason, record.case_name);
    causes.add(check.cause, record.case_name);
  });
  MarkdownTable table({{"case"},
                       {"quantity"},
                       {"measured", kRight},
                       {"expected", kRight},
                       {"error", kRight},
                       {"tolerance", kRight},
                       {"of tolerance", kRight},
                       {"digits", kRight},
                       {"verdict"},
                       {"worst offender"}});
  for_checks(family, key, [&](const Record& record, const Judgement& check) {
    const std::string mark = reasons.mark(check.claim.reason);
    table.add_row(
        {markdown_escaped(family.label(record)), markdown_escaped(check.claim.quantity),
         markdown_escaped(with_unit(format_value(check.value), check.claim.unit)),
         markdown_escaped(with_unit(format_value(check.claim.expected), check.claim.unit)),
         markdown_escaped(error_text(check)),
         markdown_escaped(tolerance_text(check)) + (mark.empty() ? "" : " (" + mark + ")"),
         share_text(check), check.digits ? format_digits(*check.digits) : std::string(),
         markdown_verdict(check.verdict) + markdown_escaped(band_text(check)),
         markdown_escaped(check.worst)});
  });
  return claim_text(key, reasons, causes) + table.text();
}

std::string figures_section(const Family& family) {
  MarkdownTable table({{"case"}, {"measured quantity"}, {"value", kRight}, {"what it means"}});
  std::size_t rows = 0;
  for (const Record* record : family.records) {
    for (const Figure& figure : record->figures) {
      table.add_row({markdown_escaped(family.label(*record)), markdown_escaped(figure.quantity),
                     markdown_escaped(with_unit(format_value(figure.value), figure.unit)),
                     markdown_escaped(figure.meaning)});
      ++rows;
    }
  }
  return rows == 0 ? "" : "**Measured, not judged.**\n\n" + table.text();
}

std::string notes_list(const Family& family) {
  SharedTexts notes;
  for (const Record* record : family.records) {
    for (const std::string& note : record->notes) notes.add(note, family.label(*record));
    for (const Failure& failure : record->failures) {
      notes.add("failed: " + failure_text(failure), family.label(*record));
    }
    notes.add(record->error, family.label(*record));
  }
  std::string text;
  for (const auto& [note, labels] : notes.entries()) {
    text += fmt::format("- Note: {}", markdown_escaped(note));
    if (labels.size() < family.records.size()) {
      std::string cases;
      for (const std::string& label : labels) {
        cases += (cases.empty() ? "" : "; ") + markdown_escaped(label);
      }
      text += fmt::format(" ({})", cases);
    }
    text += "\n";
  }
  return text.empty() ? text : text + "\n";
}

std::string mesh_lines(const Family& family) {
  SharedTexts meshes;
  for (const Record* record : family.records) {
    for (const Mesh& mesh : record->meshes) {
      meshes.add(fmt::format("{}: {} vertices, {} tetrahedra, dihedral angles {:.1f}° to {:.1f}°, "
                             "shortest altitude {:.3g} m",
                             mesh.bodies, mesh.vertices, mesh.tetrahedra, mesh.min_dihedral_angle,
                             mesh.max_dihedral_angle, mesh.min_altitude),
                 "");
    }
  }
  std::string text;
  for (const auto& [mesh, labels] : meshes.entries()) {
    text += fmt::format("- Mesh: {}\n", markdown_escaped(mesh));
  }
  return text.empty() ? text : text + "\n";
}

std::string rate_text(const Cost& cost) {
  return cost.simulated_seconds > 0.0 ? format_seconds(cost.cpu_seconds / cost.simulated_seconds)
                                      : std::string();
}

std::string contact_time_text(const ContactTime& time) {
  return time.median > 0.0 ? fmt::format("{} ({} to {})", format_seconds(time.median),
                                         format_seconds(time.lower), format_seconds(time.upper))
                           : std::string();
}

std::string cost_table(const Family& family) {
  MarkdownTable table({{"case"},
                       {"verdict"},
                       {"CPU s", kRight},
                       {"CPU s per simulated s", kRight},
                       {"steps", kRight},
                       {"contact updates", kRight},
                       {"whole step, ns per contact", kRight},
                       {"contact phases, ns per contact", kRight},
                       {"state hash"}});
  for (const Record* record : family.records) {
    const Cost& cost = record->cost;
    table.add_row({markdown_escaped(family.label(*record)), markdown_verdict(record->verdict),
                   format_seconds(cost.cpu_seconds), rate_text(cost), format_count(cost.steps),
                   format_count(cost.contact_updates), contact_time_text(cost.whole_step),
                   contact_time_text(cost.contact_phases), markdown_escaped(record->state_hash)});
  }
  return "**Runs and what they cost.**\n\n" + table.text();
}

std::string series_line(const Family& family) {
  std::set<std::string> names;
  for (const Record* record : family.records) {
    for (const Series& series : record->series)
      names.insert(series.name + " over " + series.x_name);
  }
  return names.empty() ? ""
                       : fmt::format("Series in records.jsonl: {}.\n\n", markdown_joined(names));
}

}  // namespace

std::string markdown_family(const Family& family) {
  std::string text = fmt::format("## {}\n\n", markdown_escaped(family.name));
  SharedTexts titles;
  for (const Record* record : family.records) titles.add(record->title, "");
  if (titles.entries().size() == 1) {
    text += markdown_escaped(titles.entries().front().text) + "\n\n";
  }
  if (!family.common_settings.empty()) {
    text +=
        fmt::format("All with {}.\n\n", markdown_escaped(settings_text(family.common_settings)));
  }
  for (const ClaimKey& key : claims_of(family)) text += claim_section(family, key);
  text += figures_section(family);
  return text + notes_list(family) + mesh_lines(family) + series_line(family) + cost_table(family);
}

}  // namespace stiction
