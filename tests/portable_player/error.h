#pragma once

#include <stdexcept>

/// A problem in the files of a look, or of the machine. The message names the file.
class Error : public std::runtime_error {
    using std::runtime_error::runtime_error;
};
