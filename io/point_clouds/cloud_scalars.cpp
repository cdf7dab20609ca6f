// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/point_clouds/cloud_scalars.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>

namespace eliminant::io {

namespace {

template <class Number>
double read_as(std::array<char, 8> bytes) {
  Number number;
  std::memcpy(&number, bytes.data(), sizeof(Number));
  return static_cast<double>(number);
}

}  // namespace

std::size_t size_of(ScalarType type) {
  switch (type) {
    case ScalarType::int8:
    case ScalarType::uint8:
      return 1;
    case ScalarType::int16:
    case ScalarType::uint16:
      return 2;
    case ScalarType::int32:
    case ScalarType::uint32:
    case ScalarType::float32:
      return 4;
    case ScalarType::int64:
    case ScalarType::uint64:
    case ScalarType::float64:
      return 8;
  }
  return 0;
}

double scalar_at(const char* bytes, ScalarType type, bool big_endian) {
  std::array<char, 8> own{};
  const std::size_t size = size_of(type);
  std::copy_n(bytes, size, own.begin());
  if (big_endian != (std::endian::native == std::endian::big))
    std::reverse(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(size));
  switch (type) {
    case ScalarType::int8:
      return read_as<std::int8_t>(own);
    case ScalarType::uint8:
      return read_as<std::uint8_t>(own);
    case ScalarType::int16:
      return read_as<std::int16_t>(own);
    case ScalarType::uint16:
      return read_as<std::uint16_t>(own);
    case ScalarType::int32:
      return read_as<std::int32_t>(own);
    case ScalarType::uint32:
      return read_as<std::uint32_t>(own);
    case ScalarType::int64:
      return read_as<std::int64_t>(own);
    case ScalarType::uint64:
      return read_as<std::uint64_t>(own);
    case ScalarType::float32:
      return read_as<float>(own);
    case ScalarType::float64:
      return read_as<double>(own);
  }
  return 0;
}

std::optional<double> double_in(std::string_view word) {
  if (word.starts_with('+') && word.size() > 1 && word[1] != '-') word.remove_prefix(1);
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, number);
  // Too small for a double is 0.
  if (error == std::errc::result_out_of_range && rest == end) {
    const std::size_t exponent = word.find_first_of("eE");
    if (exponent != std::string_view::npos && word.substr(exponent + 1).starts_with('-')) return 0;
    return std::nullopt;
  }
  if (word.empty() || error != std::errc{} || rest != end) return std::nullopt;
  return number;
}

std::optional<std::size_t> count_in(std::string_view word) {
  std::size_t number = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, number);
  if (word.empty() || error != std::errc{} || rest != end) return std::nullopt;
  return number;
}

std::string quoted_word(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string quoted(word.substr(0, longest));
  for (char& c : quoted)
    if (c < ' ' || c > '~') c = '?';
  return "'" + quoted + "'";
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(" \t\r"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t\r", end);
  }
  return words;
}

bool LineReader::next(std::string_view& line) {
  if (offset_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", offset_), text_.size());
  line = text_.substr(offset_, end - offset_);
  const bool both = text_.substr(end).starts_with("\r\n");
  if (number_ == 0) ends_in_return_ = !both && text_.substr(end).starts_with('\r');
  offset_ = end + (both && !ends_in_return_ ? 2 : 1);
  ++number_;
  return true;
}

}  // namespace eliminant::io
