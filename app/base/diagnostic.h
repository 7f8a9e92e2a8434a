#pragma once

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// A place in a person's file.
struct Location {
    std::filesystem::path file;
    int line = 0;  // from 1; 0: the whole file

    bool operator==(const Location&) const = default;
};

enum class Severity { error, warning };

/// A problem in a person's file or machine, in words that they can act on.
struct Diagnostic {
    std::filesystem::path file;
    int line = 0;  // from 1; 0: the whole file
    std::string message;
    Severity severity = Severity::error;

    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// A value, or every reason why there is none.
template <class T>
using Result = tl::expected<T, Diagnostics>;

/// The error side of a Result, with one reason.
tl::unexpected<Diagnostics> fail(Diagnostic reason);
tl::unexpected<Diagnostics> fail(Diagnostics reasons);

/// "file:line: error: message", without the parts that are not known.
std::string to_string(const Diagnostic& diagnostic);

/// One diagnostic a line.
std::string to_string(const Diagnostics& diagnostics);

bool has_errors(const Diagnostics& diagnostics);

/// Adds those that are not there yet, up to 256 errors and 256 warnings: nobody reads more, and a
/// broken file may have millions. One more of each says that there are others.
void add_new(Diagnostics& all, const Diagnostics& some);
void add_new(Diagnostics& all, Diagnostic one);
