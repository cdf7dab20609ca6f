// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/input_text.hpp>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include <eliminant/base/text_place.hpp>

namespace eliminant::io {

namespace {

constexpr std::size_t largest_size = std::size_t{1} << 30U;

// Length of the valid UTF-8 sequence at the beginning of `text` (RFC 3629: shortest form, no surrogates), 0 if none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return continues(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && byte(1) < 0xA0;
    const bool surrogate = lead == 0xED && byte(1) > 0x9F;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool overlong = lead == 0xF0 && byte(1) < 0x90;
    const bool beyond = lead == 0xF4 && byte(1) > 0x8F;
    return continues(1) && continues(2) && continues(3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

[[noreturn]] void refuse_file(const std::string& name, const std::string& problem) {
  throw InvalidInput(name + " " + problem, "a problem file (JSON or .ms)");
}

std::string read_all(std::FILE* file, const std::string& name) {
  std::string text;
  std::array<char, 65536> block{};
  while (true) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), file);
    if (std::memchr(block.data(), 0, count) != nullptr) refuse_file(name, "is binary: it holds zero bytes");
    text.append(block.data(), count);
    if (text.size() > largest_size) throw LimitReached(name + " is larger than 1 GiB, which is the limit");
    if (count < block.size()) break;
  }
  if (std::ferror(file) != 0) refuse_file(name, "cannot be read: " + std::string(std::strerror(errno)));
  return text;
}

}  // namespace

void require_text(std::string_view text, const std::string& name) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = text[at] == '\0' ? 0 : utf8_length(text.substr(at));
    if (length == 0)
      throw InvalidInput(name + (text[at] == '\0' ? " holds a zero byte" : " is no valid UTF-8"), "UTF-8 text",
                         place_in(text, at));
    at += length;
  }
}

std::string read_text(const std::string& path) {
  std::string text;
  std::string name = "the file '" + path + "'";
  if (path == "-") {
    name = "standard input";
    text = read_all(stdin, name);
  } else {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) refuse_file("'" + path + "'", "is a directory");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) refuse_file(name, "cannot be opened: " + std::string(std::strerror(errno)));
    text = read_all(file.get(), name);
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InvalidInput(name + " is UTF-16", "UTF-8 text");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) refuse_file(name, "is empty");
  require_text(text, name);
  return text;
}

}  // namespace eliminant::io
