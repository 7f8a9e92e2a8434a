#pragma once

#include "base/diagnostic.h"
#include "cli/command_line.h"
#include "lab/library/library.h"
#include "lab/offline/offline.h"
#include "lab/offline/sweep.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Prints the reasons to stderr, each with its source line if it has one. Returns exit_failure.
int report(const Diagnostics& reasons);

/// Prints the warnings to stderr, each with its source line if it has one.
void warn(const Diagnostics& warnings);

/// Parses "1280x720" or the name of a size. Throws UsageError for other text and sizes outside 1 to
/// 16384.
Extent parse_size(const std::string& text);

/// Throws UsageError if the file's name has none of these endings.
void check_ending(const std::string& option, const std::string& file,
                  const std::vector<std::string>& extensions);

/// The options for a look and its input, shared by the commands that open one look.
class LookOptions {
public:
    /// The options that a command takes; `drawing` adds --fps, and `several` takes several sounds.
    enum class Take { values, drawing, several };

    /// `size`: the default; "": none, and request() has an empty size.
    explicit LookOptions(std::string size = "1280x720") : m_size(std::move(size)) {}

    void add_to(Options& options, Take take);
    RenderRequest request() const;
    /// The arguments that give the same request, for another call of the program.
    std::vector<std::string> arguments() const;
    /// All values of --signal. request() has only the first.
    const std::vector<std::string>& signals() const { return m_signals; }

private:
    RenderRequest m_request;
    std::vector<std::string> m_signals;
    bool m_takes_several = false;
    bool m_has_rate = false;
    std::vector<std::string> m_set;
    std::string m_size;
};

/// The library of looks and presets in the folders of `data`.
Result<Library> open_library(const DataFolders& data);

/// Prepares the look, reports errors and warnings, and returns the exit code of `work`. For
/// commands that need no GL.
int run_prepared(
    const RenderRequest& request, const DataFolders& data,
    const std::function<int(const PreparedLook& prepared, const Library& library)>& work);

/// The steps of a command that draws a look without a display.
struct DrawingSteps {
    /// Reports errors before anything is drawn; may be empty.
    std::function<Result<void>(const PreparedLook& prepared)> check;
    std::function<Result<void>(Offline& offline, const Library& library)> draw;
    /// As PreparedLook::displayed; may be empty.
    std::function<std::optional<std::vector<std::string>>(const PreparedLook& prepared)> displayed =
        {};
};
/// Prepares the look, checks, draws and reports errors. Returns the exit code of the command.
int run_drawing(RenderRequest request, const DataFolders& data, const DrawingSteps& steps);

/// The axes of --vary. Throws UsageError for more than two; fails for other wrong texts.
Result<std::vector<SweepAxis>> sweep_axes(const std::vector<std::string>& texts, const Look& look);

/// Each function adds its verb to the program. The returned function runs it after parsing.
using Command = std::function<int(const DataFolders& data)>;
Command add_list(CommandLine& program);
Command add_render(CommandLine& program);
Command add_check(CommandLine& program);
Command add_describe(CommandLine& program);
Command add_export(CommandLine& program);
Command add_gallery(CommandLine& program);
Command add_match(CommandLine& program);
Command add_golden(CommandLine& program);
Command add_pack(CommandLine& program);
Command add_thumbnail(CommandLine& program);
Command add_preset(CommandLine& program);
Command add_compare(CommandLine& program);
Command add_bench(CommandLine& program);
Command add_sheet(CommandLine& program);
Command add_sweep(CommandLine& program);
Command add_impulse(CommandLine& program);
Command add_signal(CommandLine& program);
Command add_corpus(CommandLine& program);
Command add_jobs(CommandLine& program);
