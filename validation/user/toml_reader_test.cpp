// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/toml_reader.h"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <stdexcept>

#include "solver/testing/test_refusal.h"

namespace stiction {
namespace {

// Line numbers in the sentences below count from `name` as line 1.
constexpr const char* kText = R"(name = "box"
flag = true
whole = 3
real = 2.5e-4
vector = [1, 2.0, -3]
list = [0.5, 1]
vectors = [[1, 0, 0], [0, 1, 0]]
mixed = [1, "two", 3]
short = [1, 2]
nan = nan
infinite = inf
inner = { a = 1, b = "x" }
[[item]]
n = 1
[[item]]
n = 2
)";

TomlKeys keys_of(const char* table, std::initializer_list<const char*> names) {
  TomlKeys keys{table, "", {}};
  for (const char* name : names) keys.keys.push_back({name, "", "", "", ""});
  return keys;
}

const TomlKeys kFile = [] {
  TomlKeys keys =
      keys_of("the file", {"name", "flag", "whole", "real", "vector", "list", "vectors", "mixed",
                           "short", "nan", "infinite", "inner", "item", "absent"});
  keys.keys.push_back({"length", "m", "", "", ""});
  keys.keys.push_back({"path", "m", "", "", ""});
  return keys;
}();
const TomlKeys kInner = keys_of("[inner]", {"a", "c"});
const TomlKeys kItem = keys_of("[[item]]", {"n", "name"});

class Reader : public testing::Test {
 protected:
  std::string refusal(const std::function<void(TomlTable&)>& use) {
    TomlTable fresh(file_, root_, kFile);
    return test::refusal([&] { use(fresh); });
  }
  toml::table root_ = toml::parse(kText);
  std::string file_ = "file.toml";
  TomlTable table{file_, root_, kFile};
};

TEST_F(Reader, ReadsEachKind) {
  EXPECT_EQ(table.text("name"), "box");
  EXPECT_TRUE(table.flag("flag", false));
  EXPECT_EQ(table.number("whole"), 3.0);
  EXPECT_EQ(table.number("real"), 2.5e-4);
  EXPECT_EQ(table.vector("vector"), Eigen::Vector3d(1, 2, -3));
  EXPECT_EQ(table.numbers("list"), (std::vector<double>{0.5, 1.0}));
  ASSERT_EQ(table.vectors("vectors").size(), 2u);
  EXPECT_EQ(table.vectors("vectors")[1], Eigen::Vector3d::UnitY());
  EXPECT_EQ(table.table("inner", kInner).number("a"), 1.0);
  ASSERT_EQ(table.tables("item", kItem).size(), 2u);
  EXPECT_EQ(table.tables("item", kItem)[1].number("n"), 2.0);
  EXPECT_TRUE(table.is_table("inner"));
  EXPECT_FALSE(table.is_table("name"));
  EXPECT_TRUE(table.is_text("name"));
}

TEST_F(Reader, FallsBackWhereAKeyIsAbsent) {
  EXPECT_EQ(table.text("absent", "x"), "x");
  EXPECT_FALSE(table.flag("absent", false));
  EXPECT_EQ(table.number("absent", 7.0), 7.0);
  EXPECT_EQ(table.vector("absent", Eigen::Vector3d::UnitZ()), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(table.tables("absent", kItem).empty());
  EXPECT_FALSE(table.is_table("absent"));
}

TEST_F(Reader, DoesNotFallBackWhereAKeyIsWrong) {
  EXPECT_EQ(refusal([](TomlTable& t) { t.number("name", 7.0); }),
            "file.toml:1: 'name' must be a finite number");
  EXPECT_EQ(refusal([](TomlTable& t) { t.flag("whole", true); }),
            "file.toml:3: 'whole' must be true or false");
}

struct Misreading {
  const char* name;
  std::function<void(TomlTable&)> use;
  const char* sentence;
};

class ReaderRefuses : public Reader, public testing::WithParamInterface<Misreading> {};

TEST_P(ReaderRefuses, WithTheLine) { EXPECT_EQ(refusal(GetParam().use), GetParam().sentence); }

const Misreading kMisreadings[] = {
    {"ANumberAsText", [](TomlTable& t) { t.text("whole"); },
     "file.toml:3: 'whole' must be a text in quotes"},
    {"ATextAsNumber", [](TomlTable& t) { t.number("name"); },
     "file.toml:1: 'name' must be a finite number"},
    {"AFlagAsNumber", [](TomlTable& t) { t.number("flag"); },
     "file.toml:2: 'flag' must be a finite number"},
    {"NaN", [](TomlTable& t) { t.number("nan"); }, "file.toml:10: 'nan' must be a finite number"},
    {"Infinity", [](TomlTable& t) { t.number("infinite"); },
     "file.toml:11: 'infinite' must be a finite number"},
    {"AListOfTwoAsVector", [](TomlTable& t) { t.vector("short"); },
     "file.toml:9: 'short' must be three numbers, like [0, 0, 1]"},
    {"ANumberAsVector", [](TomlTable& t) { t.vector("whole"); },
     "file.toml:3: 'whole' must be three numbers, like [0, 0, 1]"},
    {"AWordInAVector", [](TomlTable& t) { t.vector("mixed"); },
     "file.toml:8: 'mixed' must be a finite number"},
    {"AWordInAList", [](TomlTable& t) { t.numbers("mixed"); },
     "file.toml:8: 'mixed' must be a finite number"},
    {"ANumberAsList", [](TomlTable& t) { t.numbers("whole"); },
     "file.toml:3: 'whole' must be a list"},
    {"NumbersAsVectors", [](TomlTable& t) { t.vectors("list"); },
     "file.toml:6: 'list' must be three numbers, like [0, 0, 1]"},
    {"ANumberAsTable", [](TomlTable& t) { t.table("whole", kInner); },
     "file.toml:3: 'whole' must be a table"},
    {"NumbersAsTables", [](TomlTable& t) { t.tables("list", kItem); },
     "file.toml:6: 'list' must be written as [[list]]"},
    {"AMissingKey", [](TomlTable& t) { t.table("inner", kInner).number("c"); },
     "file.toml:12: [inner] lacks 'c'"},
    {"AMissingKeyOfARepeatedTable", [](TomlTable& t) { t.tables("item", kItem)[1].text("name"); },
     "file.toml:15: [[item]] lacks 'name'"},
    {"AnUnknownKey",
     [](TomlTable& t) {
       TomlTable inner = t.table("inner", kInner);
       inner.number("a");
       inner.finish();
     },
     "file.toml:12: [inner] has no key 'b'; there are: a, c"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, ReaderRefuses, testing::ValuesIn(kMisreadings),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_F(Reader, FinishesWhenEveryKeyWasAskedFor) {
  const TomlKeys both = keys_of("[inner]", {"a", "b"});
  TomlTable inner = table.table("inner", both);
  inner.number("a");
  EXPECT_EQ(test::refusal([&] { inner.finish(); }),
            "file.toml:12: 'b' has no effect beside what else [inner] says");
  inner.has("b");
  EXPECT_EQ(test::refusal([&] { inner.finish(); }), "");
}

TEST_F(Reader, AskedForAKeyThatNobodyExplainsIsAMistakeOfTheProgram) {
  EXPECT_THROW(table.number("colour"), std::logic_error);
}

TEST_F(Reader, TakesANumberWithAUnitOfItsKind) {
  root_ = toml::parse("length = \"3 mm\"\npath = [\"1 cm\", 0, \"-2 m\"]\nwhole = \"3 mm\"\n");
  EXPECT_EQ(table.number("length"), 0.003);
  EXPECT_EQ(table.vector("path"), Eigen::Vector3d(0.01, 0, -2));
  EXPECT_EQ(table.number_in("m", "whole"), 0.003);
  EXPECT_EQ(refusal([](TomlTable& t) { t.number("whole"); }),
            "file.toml:3: 'whole' must be a finite number");
  EXPECT_EQ(refusal([](TomlTable& t) { t.number_in("kg", "length"); }),
            "file.toml:1: 'length' must be a finite number, or a text of one and its unit: kg, g, "
            "mg, t");
}

TEST_F(Reader, GivesSettingsAsTextThatReadsBackAsTheSameNumber) {
  root_ = toml::parse("inner = { dt = 2e-4, rule = \"none\", cells = 2 }\n");
  const auto all = table.settings("inner");
  ASSERT_EQ(all.size(), 3u);
  for (const auto& [key, value] : all) {
    EXPECT_EQ(value, key == "dt" ? "0.0002" : key == "rule" ? "none" : "2") << key;
  }
}

}  // namespace
}  // namespace stiction
