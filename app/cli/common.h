#pragma once

#include "base/diagnostic.h"
#include "cli/command_line.h"
#include "lab/library/library.h"
#include "lab/offline/offline.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Prints the reasons on stderr, one a line; gives exit code 1.
int report(const Diagnostics& reasons);

/// As report, for what does not stop the work.
void warn(const Diagnostics& warnings);

/// "1280x720"; throws UsageError.
Extent parse_size(const std::string& text);

/// Throws UsageError where a file's name has none of these endings.
void check_ending(const std::string& option, const std::string& file,
                  const std::vector<std::string>& endings);

/// The options that name a look and how to drive it, shared by render, describe, preset and bench.
class LookOptions {
public:
    /// Which of the options a command takes.
    enum class Take { values, drawing };

    explicit LookOptions(std::string size = "1280x720") : m_size(std::move(size)) {}

    void add_to(Options& options, Take take);
    RenderRequest request() const;

private:
    RenderRequest m_request;
    std::vector<std::string> m_set;
    std::string m_size;
};

/// What every command gets: where looks are.
Result<Library> open_library(const DataFolders& data);

/// What a command does with a look that is drawn without a display.
struct Drawing {
    /// Looks for mistakes before anything is drawn; may be empty.
    std::function<Result<void>(const Prepared& prepared)> check;
    std::function<Result<void>(Offline& offline, const Library& library)> draw;
    /// As Prepared::seen; may be empty.
    std::function<std::optional<std::vector<std::string>>(const Prepared& prepared)> seen = {};
};
/// Prepares the look, checks, draws, and reports what went wrong; the command's exit code.
int run_drawing(RenderRequest request, const DataFolders& data, const Drawing& drawing);

/// Each adds its verb to the program; the returned function runs it after parsing.
using Command = std::function<int(const DataFolders& data)>;
Command add_list(CommandLine& program);
Command add_render(CommandLine& program);
Command add_check(CommandLine& program);
Command add_describe(CommandLine& program);
Command add_preset(CommandLine& program);
Command add_compare(CommandLine& program);
Command add_bench(CommandLine& program);
Command add_sheet(CommandLine& program);
Command add_sweep(CommandLine& program);
Command add_impulse(CommandLine& program);
Command add_signal(CommandLine& program);
Command add_corpus(CommandLine& program);
