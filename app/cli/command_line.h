#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own name
class App;
class Option;
}  // namespace CLI

constexpr int exit_done = 0;
constexpr int exit_not_good = 1;
constexpr int exit_usage = 2;

/// Wrong usage that shows only after parsing; ends CommandLine::run.
class UsageError : public std::runtime_error {
public:
    using runtime_error::runtime_error;
};

/// What is said of an argument that no option or command takes.
std::string unexpected_argument(const std::string& argument);

/// "looks, presets or signals".
std::string or_list(const std::vector<std::string>& words);

/// An option, a flag or a positional that was added; each call says one thing more about it.
class Option {
public:
    explicit Option(CLI::Option& option) : m_option(&option) {}

    Option& required();
    /// In the help, the value that its variable has now.
    Option& show_default();
    /// Takes numbers from `low` to `high`, whole ones or all; says so in plain words.
    Option& between(int low, int high);
    Option& between(double low, double high);
    Option& one_of(const std::vector<std::string>& words);
    /// Each value after a name of its own: --set a --set b.
    Option& repeated();
    Option& excludes(const Option& other);

private:
    CLI::Option* m_option;
};

/// What the program or one of its verbs takes. `names` is "--frames N", "-o,--output FILE", or
/// "LOOK" for a positional: the names, and what the help calls the value. `value` is filled by
/// parsing and must live until then.
class Options {
public:
    explicit Options(CLI::App& app) : m_app(&app) {}

    /// An empty text is wrong usage.
    Option add(const std::string& names, std::string& value, const std::string& help);
    Option add(const std::string& names, std::vector<std::string>& values, const std::string& help);
    Option add(const std::string& names, int& value, const std::string& help);
    Option add(const std::string& names, double& value, const std::string& help);
    Option add_flag(const std::string& names, bool& value, const std::string& help);
    /// A flag that changes nothing.
    Option add_flag(const std::string& names, const std::string& help);

private:
    CLI::App* m_app;
};

/// Whole command lines that the help of the program or of a verb ends with.
using Examples = std::span<const char* const>;

/// What the program takes on its command line: options of its own, and at most one verb with
/// others.
class CommandLine {
public:
    /// The help begins with `about`, and ends with `note` and `examples`.
    CommandLine(const std::string& name, const std::string& version, const std::string& about,
                const std::string& note, Examples examples);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    Options options();
    /// The list of the verbs shows the first line of `help`.
    Options add_verb(const std::string& name, const std::string& help, Examples examples);

    /// Parses, then gives what `action` returns for the verb, "" where there is none. Prints help
    /// and wrong usage itself; these are exit_done and exit_usage.
    int run(int argc, const char* const* argv,
            const std::function<int(const std::string& verb)>& action);

private:
    std::unique_ptr<CLI::App> m_app;
};
