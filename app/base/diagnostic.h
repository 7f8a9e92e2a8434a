#pragma once

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// A location in a user's file.
struct Location {
    std::filesystem::path file;
    int line = 0;  // from 1; 0: the whole file

    bool operator==(const Location&) const = default;
};

enum class Severity { error, warning };

/// A problem in a user's file or on the machine, with a message that the user can act on.
struct Diagnostic {
    std::filesystem::path file;
    int line = 0;  // from 1; 0: the whole file
    std::string message;
    Severity severity = Severity::error;

    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// A value, or all errors that prevented it.
template <class T>
using Result = tl::expected<T, Diagnostics>;

/// The error side of a Result.
tl::unexpected<Diagnostics> fail(Diagnostic reason);
tl::unexpected<Diagnostics> fail(Diagnostics reasons);

/// "file:line: error: message", without the unknown parts.
std::string to_string(const Diagnostic& diagnostic);

/// One diagnostic per line.
std::string to_string(const Diagnostics& diagnostics);

bool has_errors(const Diagnostics& diagnostics);

/// Adds diagnostics that are not yet listed, up to 256 errors and 256 warnings. A broken file may
/// have millions. One more of each severity reports that the list is cut.
void add_new(Diagnostics& all, const Diagnostics& some);
void add_new(Diagnostics& all, Diagnostic one);
