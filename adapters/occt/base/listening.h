// SPDX-License-Identifier: LGPL-2.1-or-later
// What Open CASCADE says while it reads.

#pragma once

#include <iostream>
#include <sstream>
#include <string>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>

namespace blossom::occt {

/// Keeps what Open CASCADE says instead of printing it.
class Notes : public Message_Printer {
 public:
  const std::string& text() const { return text_; }

 protected:
  void send(const TCollection_AsciiString& text, const Message_Gravity) const override {
    text_ += std::string(text.ToCString()) + "\n";
  }

 private:
  mutable std::string text_;
};

/// Keeps what Open CASCADE says for as long as this lives: its messages and, since its BREP reader
/// complains there, what goes to std::cout, where our results belong.
class Listening {
 public:
  Listening() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    Message::DefaultMessenger()->AddPrinter(notes_);
    output_ = std::cout.rdbuf(printed_.rdbuf());
  }
  ~Listening() {
    std::cout.rdbuf(output_);
    Message::DefaultMessenger()->ChangePrinters() = printers_;
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

  /// The first line that was said, or nothing.
  std::string first() const {
    std::istringstream lines(notes_->text() + "\n" + printed_.str());
    std::string line;
    while (line.empty() && std::getline(lines, line)) {
    }
    return line;
  }

 private:
  Handle(Notes) notes_ = new Notes;
  std::ostringstream printed_;
  std::streambuf* output_ = nullptr;
  Message_SequenceOfPrinters printers_;
};

}  // namespace blossom::occt
