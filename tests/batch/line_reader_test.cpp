// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include <cli/program.hpp>
#include <eliminant/base/error.hpp>
#include <eliminant/batch/line_reader.hpp>

using eliminant::InvalidInput;
using eliminant::batch::LineReader;
using eliminant::batch::parse_shard;
using eliminant::batch::Shard;

namespace {

using Lines = std::vector<std::pair<std::uint64_t, std::string>>;

Lines lines_of(const std::string& path, const std::optional<Shard>& shard = {}) {
  LineReader reader(path, shard);
  Lines lines;
  while (auto line = reader.next()) lines.emplace_back(line->line, line->text);
  CHECK(reader.at_end());
  return lines;
}

}  // namespace

TEST_CASE("line reader: blank lines count, but are none; the last line needs no end") {
  const TemporaryFolder folder;
  CHECK(lines_of(folder.write("a", "")).empty());
  CHECK(lines_of(folder.write("b", "\n \t\r\n\n")).empty());
  CHECK(lines_of(folder.write("c", "a\n\n  b\r\nc")) == Lines{{1, "a"}, {3, "  b"}, {4, "c"}});
  CHECK(lines_of(folder.write("d",
                              "\xEF\xBB\xBF"
                              "a\n")) == Lines{{1, "a"}});
}

TEST_CASE("line reader: lines longer than a block are whole, and longer than the limit they are cut") {
  const TemporaryFolder folder;
  const std::string longest(LineReader::longest_line, 'x');
  CHECK(lines_of(folder.write("a", std::string(1'000'000, 'a') + "\nb\n")) ==
        Lines{{1, std::string(1'000'000, 'a')}, {2, "b"}});
  LineReader reader(folder.write("b", longest + "\n" + longest + "x\nb\n"), {});
  const auto fits = reader.next();
  REQUIRE(fits);
  CHECK_FALSE(fits->too_long);
  CHECK(fits->text == longest);
  const auto cut = reader.next();
  REQUIRE(cut);
  CHECK(cut->too_long);
  CHECK(cut->text == longest);
  CHECK(reader.next()->text == "b");
  CHECK_FALSE(reader.next());
}

TEST_CASE("line reader: the parts of a file are its lines, in order, with their numbers in the file") {
  const TemporaryFolder folder;
  std::string content = "\xEF\xBB\xBF";
  for (int i = 0; i < 40'000; ++i) content += std::string(static_cast<std::size_t>(i * 7 % 31), 'a') + "\n";
  for (const std::string& text : {content, std::string("a\nbb\n\nccc"), std::string("\n"), std::string()}) {
    const std::string path = folder.write("file", text);
    const Lines whole = lines_of(path);
    for (const std::uint64_t count : {1U, 2U, 3U, 7U, 50U}) {
      CAPTURE(count);
      Lines joined;
      for (std::uint64_t index = 1; index <= count; ++index)
        for (auto& line : lines_of(path, Shard{index, count})) joined.push_back(std::move(line));
      CHECK(joined == whole);
    }
  }
}

TEST_CASE("line reader: what cannot be read, or not be cut, is bad input") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(LineReader(folder.file("missing"), {}), InvalidInput);
  CHECK_THROWS_AS(LineReader(folder.file("."), {}), InvalidInput);
  CHECK_THROWS_AS(LineReader("-", Shard{1, 2}), InvalidInput);
}

TEST_CASE("line reader: a part is two whole numbers") {
  CHECK(parse_shard("1/1").count == 1);
  CHECK(parse_shard("3/16").index == 3);
  for (const char* text :
       {"", "/", "1", "1/", "/1", "0/1", "2/1", "1/0", "-1/2", "1/2/3", "1/2 ", "a/b", "1/1000001"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_shard(text), InvalidInput);
  }
}
