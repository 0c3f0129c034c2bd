// SPDX-License-Identifier: LGPL-2.1-or-later
// The words of a failure of Open CASCADE.

#include "adapters/occt/base/errors.h"

#include <exception>
#include <ios>
#include <new>
#include <string_view>

#include <Standard_ConstructionError.hxx>
#include <Standard_DimensionError.hxx>
#include <Standard_DomainError.hxx>
#include <Standard_NoSuchObject.hxx>
#include <Standard_NotImplemented.hxx>
#include <Standard_NullObject.hxx>
#include <Standard_NumericError.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_OutOfRange.hxx>
#include <Standard_Type.hxx>
#include <Standard_TypeMismatch.hxx>
#include <StdFail_NotDone.hxx>

namespace blossom::occt {
namespace {

/// What a kind of exception means to somebody who has the model, not the program.
struct Meaning {
  Handle(Standard_Type) type;
  const char* words;
};

/// Narrower kinds stand before those that they are kinds of.
const char* meaning_of(const Standard_Failure& failure) {
  static const Meaning kMeanings[] = {
      {STANDARD_TYPE(Standard_ConstructionError), "its numbers make no such geometry"},
      {STANDARD_TYPE(Standard_OutOfRange), "a number points outside of the list that it counts"},
      {STANDARD_TYPE(Standard_DimensionError), "counts do not fit together"},
      {STANDARD_TYPE(Standard_NoSuchObject), "something is referred to that is not there"},
      {STANDARD_TYPE(Standard_NullObject), "something that is needed is missing"},
      {STANDARD_TYPE(Standard_TypeMismatch), "something is of another kind than is needed there"},
      {STANDARD_TYPE(Standard_NumericError), "a computation with its numbers fails"},
      {STANDARD_TYPE(Standard_NotImplemented), "Open CASCADE cannot do that"},
      {STANDARD_TYPE(StdFail_NotDone), "Open CASCADE finds no solution"},
      {STANDARD_TYPE(Standard_DomainError), "its numbers are not among those that are possible"}};
  for (const Meaning& meaning : kMeanings)
    if (failure.IsKind(meaning.type)) return meaning.words;
  return "Open CASCADE fails";
}

/// Whether a message of Open CASCADE is a sentence, not the name of a function.
bool is_words(std::string_view message) {
  constexpr auto npos = std::string_view::npos;
  return message.find(' ') != npos && message.find("::") == npos && message.find('_') == npos &&
         message.find('\n') == npos;
}

std::string words_of(const Standard_Failure& failure) {
  const char* const message = failure.GetMessageString();
  const std::string meaning = meaning_of(failure);
  if (message == nullptr || !is_words(message)) return meaning;
  return meaning + " (" + message + ")";
}

}  // namespace

bool is_lack_of_memory() {
  const std::exception_ptr current = std::current_exception();
  if (!current) return false;
  try {
    std::rethrow_exception(current);
  } catch (const Standard_OutOfMemory&) {
    return true;
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

std::string current_failure_text() {
  const std::exception_ptr current = std::current_exception();
  if (!current) return "no failure";
  if (is_lack_of_memory()) throw std::bad_alloc();
  try {
    std::rethrow_exception(current);
  } catch (const Standard_Failure& failure) {
    return words_of(failure);
  } catch (const std::ios_base::failure&) {
    return "it breaks off, or has something else where a number or a word is due";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "unknown failure";
  }
}

}  // namespace blossom::occt
