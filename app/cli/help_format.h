#pragma once

#include <memory>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own name
class FormatterBase;
}  // namespace CLI

/// The format of the help of the program and of its commands: lines of at most 80 columns, names of
/// values, and notes such as "(required)" after the text of an option.
std::shared_ptr<CLI::FormatterBase> make_help_format();
