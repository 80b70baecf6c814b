// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/xml_fault.hpp"

#include <cctype>
#include <set>
#include <vector>

namespace setsquare::testing {
namespace {

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == ':';
}

class Checker {
 public:
  explicit Checker(std::string_view text) : text_(text) {}

  std::optional<std::string> fault() {
    while (at_ < text_.size() && fault_.empty()) {
      if (starts_with("<?") || starts_with("<!DOCTYPE html>")) {
        if (has_element_) fail("a declaration inside the document");
        skip_past('>');
      } else if (starts_with("</")) {
        close_element();
      } else if (text_[at_] == '<') {
        open_element();
      } else {
        check_character();
      }
    }
    if (fault_.empty() && !open_.empty()) fail("element " + open_.back() + " is not closed");
    if (fault_.empty() && !has_element_) fail("no element");
    if (fault_.empty()) return std::nullopt;
    return fault_;
  }

 private:
  bool starts_with(std::string_view start) const { return text_.substr(at_).starts_with(start); }
  void fail(const std::string& reason) { fault_ = reason + " at offset " + std::to_string(at_); }
  void skip_past(char end) { at_ = std::min(text_.find(end, at_), text_.size() - 1) + 1; }
  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }

  std::string name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_name_character(text_[at_])) ++at_;
    if (at_ == start) fail("a name is missing");
    return std::string(text_.substr(start, at_ - start));
  }

  void check_character() {
    const auto byte = static_cast<unsigned char>(text_[at_]);
    if (byte < 0x20 && byte != '\n' && byte != '\t') fail("a control character");
    if (open_.empty() && byte > ' ') fail("text outside the element");
    if (byte == '&') {
      bool is_known = false;
      for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}) {
        is_known = is_known || starts_with(entity);
      }
      if (!is_known) fail("an unknown entity");
    }
    ++at_;
  }

  void close_element() {
    at_ += 2;
    const std::string closed = name();
    if (open_.empty() || open_.back() != closed) return fail("</" + closed + "> closes nothing");
    open_.pop_back();
    if (!starts_with(">")) return fail("> is missing");
    ++at_;
  }

  void open_element() {
    if (open_.empty() && has_element_) return fail("a second root element");
    ++at_;
    has_element_ = true;
    open_.push_back(name());
    std::set<std::string> attributes;
    for (skip_blanks(); at_ < text_.size() && fault_.empty(); skip_blanks()) {
      if (starts_with("/>")) {
        at_ += 2;
        open_.pop_back();
        return;
      }
      if (starts_with(">")) {
        ++at_;
        return;
      }
      if (!attributes.insert(name()).second) return fail("an attribute stands twice");
      if (!starts_with("=\"")) return fail("an attribute without a quoted value");
      for (at_ += 2; at_ < text_.size() && text_[at_] != '"' && fault_.empty();) {
        if (text_[at_] == '<') return fail("< in an attribute");
        check_character();
      }
      ++at_;
    }
    fail("a tag without its end");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool has_element_ = false;
  std::vector<std::string> open_;
  std::string fault_;
};

}  // namespace

std::optional<std::string> xml_fault(std::string_view text) { return Checker(text).fault(); }

}  // namespace setsquare::testing
