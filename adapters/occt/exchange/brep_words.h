// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers of BREP files, one after the other, and those that cannot be. For this folder only.

#pragma once

#include <cstddef>
#include <string_view>

namespace blossom::occt {

/// Goes through a BREP text, or through binary BREP, which has the same numbers in the same order:
/// what is a word there has a fixed number of bytes here. Words are taken as Open CASCADE takes
/// them.
class BrepWords {
 public:
  struct Number {
    std::size_t at = 0, length = 0;
    double value = 0;
  };

  /// content   has to live as long as this
  BrepWords(std::string_view content, std::size_t at, bool binary)
      : content_(content), at_(at), binary_(binary) {}

  /// Whether nothing follows, or what should be a whole number is none.
  bool ended() const { return lost_ || at_ >= content_.size(); }

  std::string_view word();  ///< of a heading
  int count();              ///< behind the name of a table
  void skip_text_word();    ///< one that only texts have
  int kind() { return binary_ ? bytes<signed char>() : whole(); }
  bool flag() { return binary_ ? bytes<char>() != 0 : whole() != 0; }
  int degree() { return binary_ ? bytes<unsigned short>() : whole(); }
  int integer() { return binary_ ? bytes<int>() : whole(); }
  Number real();

  void skip_reals(std::size_t count) { skip(count, sizeof(double)); }
  void skip_singles(std::size_t count) { skip(count, sizeof(float)); }
  void skip_integers(std::size_t count) { skip(count, sizeof(int)); }

  /// How many kinds, integers, or real numbers may follow at most.
  std::size_t room_for_kinds() const { return room(sizeof(char)); }
  std::size_t room_for_reals() const { return room(sizeof(double)); }
  std::size_t room_for_integers() const { return room(sizeof(int)); }

 private:
  template <class Value>
  Value bytes();
  int whole();  ///< 0 if there is none
  void skip(std::size_t count, std::size_t size);
  std::size_t room(std::size_t size) const;

  std::string_view content_;
  std::size_t at_;
  bool binary_;
  bool lost_ = false;
};

/// Goes through the tables before the shapes. Open CASCADE makes room for as many control points,
/// knots, nodes and triangles as a file says it has, before it reads the first of them.
/// throws   BadModel that names the entry, if the rest of the file is too short for what it says
void check_counts(std::string_view content, bool binary);

}  // namespace blossom::occt
