// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/json_text.hpp>

#include <nlohmann/json.hpp>

#include <unordered_set>

#include <eliminant/io/results/json_words.hpp>

namespace eliminant::io {

namespace {

constexpr std::size_t largest_depth = 100;
constexpr std::size_t npos = std::string::npos;

// Builds the tree from nlohmann's events. They come in the order of the words, which gives each one its place.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const JsonWords& words, JsonValue& root)
      : text_(text), words_(words), root_(root) {}

  bool null() override { return leaf({}); }
  bool boolean(bool value) override {
    JsonValue result;
    result.kind = JsonValue::Kind::boolean;
    result.boolean = value;
    return leaf(std::move(result));
  }
  bool number_integer(number_integer_t) override { return number(); }
  bool number_unsigned(number_unsigned_t) override { return number(); }
  bool number_float(number_float_t, const string_t&) override { return number(); }
  bool string(string_t& value) override {
    JsonValue result;
    result.kind = JsonValue::Kind::text;
    result.text = std::move(value);
    return leaf(std::move(result));
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override {
    names_.emplace_back();
    return open(JsonValue::Kind::object);
  }
  bool key(string_t& name) override {
    const std::size_t offset = next_offset();
    if (!names_.back().insert(name).second)
      throw ParseError("the name \"" + name + "\" occurs twice in one object", "each name once",
                       place_in(text_, offset));
    open_.back()->members.push_back({std::move(name), offset, {}});
    return true;
  }
  bool end_object() override {
    names_.pop_back();
    open_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
  bool end_array() override {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::json::exception& error) override {
    // `position` counts the bytes read, up to the end of the word that does not fit; `last_token` is that word, with
    // what stood before it when the word is punctuation.
    const bool punctuation = !last_token.empty() && std::string_view("[]{},:").find(last_token.back()) != npos;
    const std::size_t length = punctuation ? 1 : last_token.size();
    const std::size_t begin = position - std::min(position, length);
    const std::string message = error.what();
    const std::size_t at = message.rfind("; expected ");
    std::string expected = at == npos ? "an escape that JSON has" : message.substr(at + 11);
    if (expected == "end of input") expected = "nothing behind the value";
    if (expected == "string literal") expected = "a name in double quotes";
    if (expected == "'[', '{', or a literal") expected = "a JSON value";
    if (expected == "'}'" || expected == "']'") expected = "',' or " + expected;
    const bool at_end = begin >= text_.size() || message.find("unexpected end of input") != std::string::npos;
    throw ParseError(at_end ? std::string("unexpected end of the JSON text") : "unexpected '" + word_at(begin) + "'",
                     expected, place_in(text_, at_end ? text_.size() : begin));
  }

 private:
  // The character or word in the original text, where numbers have not been replaced.
  std::string word_at(std::size_t offset) const {
    const std::string_view rest = text_.substr(offset);
    const std::size_t length = rest.find_first_of(" \t\r\n,:]}", 1);
    return std::string(rest.substr(0, std::min<std::size_t>(length, 30)));
  }
  std::size_t next_offset() { return words_.offsets[next_word_++]; }
  JsonValue& attach(JsonValue value) {
    if (open_.empty()) return root_ = std::move(value);
    JsonValue& parent = *open_.back();
    if (parent.kind == JsonValue::Kind::object) return parent.members.back().value = std::move(value);
    return parent.elements.emplace_back(std::move(value));
  }
  bool leaf(JsonValue value) {
    value.offset = next_offset();
    attach(std::move(value));
    return true;
  }
  bool number() {
    JsonValue result;
    result.kind = JsonValue::Kind::number;
    result.text = words_.numbers[next_number_++];
    return leaf(std::move(result));
  }
  bool open(JsonValue::Kind kind) {
    JsonValue value;
    value.kind = kind;
    value.offset = next_offset();
    if (open_.size() >= largest_depth)
      throw ParseError("arrays and objects are nested more than " + std::to_string(largest_depth) + " deep",
                       "a problem", place_in(text_, value.offset));
    // The parent's vector does not grow while this one is open: the pointer stays valid.
    open_.push_back(&attach(std::move(value)));
    return true;
  }

  std::string_view text_;
  const JsonWords& words_;
  JsonValue& root_;
  std::vector<JsonValue*> open_;
  std::vector<std::unordered_set<std::string>> names_;
  std::size_t next_word_ = 0;
  std::size_t next_number_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
  for (const JsonMember& member : members)
    if (member.name == name) return &member.value;
  return nullptr;
}

const char* JsonValue::kind_in_words() const {
  switch (kind) {
    case Kind::null:
      return "null";
    case Kind::boolean:
      return boolean ? "true" : "false";
    case Kind::number:
      return "a number";
    case Kind::text:
      return "a text";
    case Kind::array:
      return "an array";
    case Kind::object:
      return "an object";
  }
  return "a value";
}

JsonDocument::JsonDocument(std::string text) : text_(std::move(text)) {
  const JsonWords words = json_words(text_);
  TreeBuilder builder(text_, words, root_);
  nlohmann::json::sax_parse(words.without_numbers, &builder);
}

Locate JsonDocument::locate_inside(const JsonValue& value) const {
  if (value.kind != JsonValue::Kind::text) return [this, at = value.offset](std::size_t i) { return place_of(at + i); };
  return [this, begin = value.offset + 1](std::size_t offset) {
    // Walk through the quoted text until `offset` decoded bytes have gone by.
    std::size_t at = begin;
    std::size_t decoded = 0;
    while (decoded < offset && at < text_.size() && text_[at] != '"') {
      if (text_[at] != '\\') {
        ++at;
        ++decoded;
      } else if (at + 6 <= text_.size() && text_[at + 1] == 'u') {
        const unsigned long code = std::stoul(text_.substr(at + 2, 4), nullptr, 16);
        // Each half of a surrogate pair stands for two of the four bytes.
        const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
        decoded += code < 0x80 ? 1 : (code < 0x800 || surrogate) ? 2 : 3;
        at += 6;
      } else {
        at += 2;
        ++decoded;
      }
    }
    return place_of(at);
  };
}

}  // namespace eliminant::io
