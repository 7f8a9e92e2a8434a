#pragma once

#include <memory>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own name
class FormatterBase;
}  // namespace CLI

/// How the help of the program and of its commands is printed: in lines of at most 80 columns, with
/// what a value is called, and notes such as "(required)" after an option's text.
std::shared_ptr<CLI::FormatterBase> make_help_format();
