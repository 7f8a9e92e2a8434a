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
constexpr int exit_failure = 1;
constexpr int exit_usage = 2;

/// Wrong usage that is detected only after parsing. CommandLine::run() catches it.
class UsageError : public std::runtime_error {
public:
    using runtime_error::runtime_error;
};

/// The error message for an argument that no option or command takes.
std::string unexpected_argument(const std::string& argument);

/// Adds `name` and `value` for another call of the program, unless the value is empty.
void add_argument(std::vector<std::string>& arguments, const std::string& name,
                  const std::string& value);

/// The words as a list, such as "looks, presets or signals".
std::string or_list(const std::vector<std::string>& words);

/// An option, flag or positional argument that was added. Each function sets one property of it.
class Option {
public:
    explicit Option(CLI::Option& option) : m_option(&option) {}

    Option& required();
    /// Shows the current value of its variable in the help.
    Option& show_default();
    /// Accepts whole numbers from `low` to `high`, or with doubles any numbers.
    Option& between(int low, int high);
    Option& between(double low, double high);
    Option& one_of(const std::vector<std::string>& words);
    /// Each value needs the option's name: --set a --set b.
    Option& repeated();
    /// For a list: without values, the option gives the list `value`.
    Option& or_alone(const std::string& value);
    Option& excludes(const Option& other);
    /// Leaves it out of the help, for an option that is refused with a reason.
    Option& hidden();

private:
    CLI::Option* m_option;
};

/// The options of the program or of one of its verbs. `names` is the names and the name of the
/// value in the help: "--frames N", "-o,--output FILE", or "LOOK" for a positional argument.
/// Parsing sets `value`, which must live until then.
class Options {
public:
    explicit Options(CLI::App& app) : m_app(&app) {}

    /// Empty values are wrong usage, also in a list.
    Option add(const std::string& names, std::string& value, const std::string& help);
    Option add(const std::string& names, std::vector<std::string>& values, const std::string& help);
    Option add(const std::string& names, int& value, const std::string& help);
    Option add(const std::string& names, double& value, const std::string& help);
    Option add_flag(const std::string& names, bool& value, const std::string& help);
    /// A flag without effect.
    Option add_flag(const std::string& names, const std::string& help);

private:
    CLI::App* m_app;
};

/// Complete command lines at the end of the help of the program or of a verb.
using Examples = std::span<const char* const>;

/// The command line of the program: its own options, and at most one verb with further options.
class CommandLine {
public:
    /// The help starts with `about` and ends with `note` and `examples`.
    CommandLine(const std::string& name, const std::string& version, const std::string& about,
                const std::string& note, Examples examples);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    Options options();
    /// The list of the verbs shows the first line of `help`.
    Options add_verb(const std::string& name, const std::string& help, Examples examples);

    /// Parses, then returns the result of `action` for the verb ("": no verb). Prints the help and
    /// returns exit_done, or prints wrong usage and returns exit_usage.
    int run(int argc, const char* const* argv,
            const std::function<int(const std::string& verb)>& action);

private:
    std::unique_ptr<CLI::App> m_app;
};
