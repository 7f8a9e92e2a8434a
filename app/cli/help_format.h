#pragma once

#include <memory>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own name
class FormatterBase;
}  // namespace CLI

/// The format of the help of the program and of its commands. Lines have at most 80 columns. Notes
/// such as "(required)" follow the text of an option.
std::shared_ptr<CLI::FormatterBase> make_help_format();
