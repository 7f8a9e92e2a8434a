#pragma once

#include "base/diagnostic.h"
#include "lab/library.h"
#include "lab/offline.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

constexpr int exit_done = 0;
constexpr int exit_not_good = 1;
constexpr int exit_usage = 2;

/// Prints the reasons on stderr, one a line; gives exit code 1.
int report(const Diagnostics& reasons);

/// As report, for what does not stop the work.
void warn(const Diagnostics& warnings);

/// "1280x720"; throws CLI::ValidationError.
Extent parse_size(const std::string& text);

/// Takes numbers from `low` to `high`, whole ones or all; says so in plain words.
CLI::Validator number_between(double low, double high);
CLI::Validator whole_number_between(int low, int high);

/// Throws CLI::ValidationError where a file's name has none of these endings.
void check_ending(const std::string& option, const std::string& file,
                  const std::vector<std::string>& endings);

/// The options that name a look and how to drive it, shared by render, describe, preset and bench.
class LookOptions {
public:
    /// Which of the options a command takes.
    enum class Take { values, drawing };

    void add_to(CLI::App& command, Take take);
    RenderRequest request() const;

private:
    RenderRequest m_request;
    std::vector<std::string> m_set;
    std::string m_size = "1280x720";
};

/// What every command gets: where looks are. `data` is --data, "" when it was not given.
Result<Library> open_library(const std::string& data);

/// Each adds its verb to the program; the returned function runs it after parsing.
using Command = std::function<int(const std::string& data)>;
Command add_list(CLI::App& program);
Command add_render(CLI::App& program);
Command add_check(CLI::App& program);
Command add_describe(CLI::App& program);
Command add_preset(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_sheet(CLI::App& program);
Command add_signal(CLI::App& program);
