#include "cli/command_line.h"

#include "base/text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {
// A script's variable that was never set must not read as an option that was not given.
std::string complaint_of_empty(const std::string& text) {
    return text.empty() ? "is given nothing" : "";
}
}  // namespace

Option& Option::required() {
    m_option->required();
    return *this;
}

Option& Option::show_default() {
    m_option->capture_default_str();
    return *this;
}

Option& Option::between(int low, int high) {
    m_option->check([=](const std::string& text) {
        const auto number = parse_integer(text);
        const bool is_good = number && *number >= low && *number <= high;
        return is_good ? std::string()
                       : fmt::format("'{}' is not a whole number from {} to {}", text, low, high);
    });
    return *this;
}

Option& Option::between(double low, double high) {
    m_option->check([=](const std::string& text) {
        const auto number = parse_number(text);
        const bool is_good = number && *number >= low && *number <= high;
        return is_good ? std::string()
                       : fmt::format("'{}' is not a number from {} to {}", text, low, high);
    });
    return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
    m_option->check(CLI::IsMember(words));
    return *this;
}

Option& Option::repeated() {
    m_option->take_all()->allow_extra_args(false);
    return *this;
}

Option& Option::excludes(const Option& other) {
    m_option->excludes(other.m_option);
    return *this;
}

Option Options::add(const std::string& names, std::string& value, const std::string& help) {
    return Option(*m_app->add_option(names, value, help)->check(complaint_of_empty));
}

Option Options::add(const std::string& names, std::vector<std::string>& values,
                    const std::string& help) {
    return Option(*m_app->add_option(names, values, help)->check(complaint_of_empty));
}

Option Options::add(const std::string& names, int& value, const std::string& help) {
    return Option(*m_app->add_option(names, value, help));
}

Option Options::add(const std::string& names, double& value, const std::string& help) {
    return Option(*m_app->add_option(names, value, help));
}

Option Options::add_flag(const std::string& names, bool& value, const std::string& help) {
    return Option(*m_app->add_flag(names, value, help));
}

Option Options::add_flag(const std::string& names, const std::string& help) {
    return Option(*m_app->add_flag(names)->description(help));
}

CommandLine::CommandLine(const std::string& name, const std::string& version,
                         const std::string& about)
    : m_app(std::make_unique<CLI::App>(about, name)) {
    m_app->set_version_flag("--version", name + ' ' + version);
    m_app->require_subcommand(0, 1);
    m_app->fallthrough();
}

CommandLine::~CommandLine() = default;

Options CommandLine::options() {
    return Options(*m_app);
}

Options CommandLine::add_verb(const std::string& name, const std::string& help) {
    return Options(*m_app->add_subcommand(name, help));
}

int CommandLine::run(int argc, const char* const* argv,
                     const std::function<int(const std::string& verb)>& action) {
    const auto exit = [&](const CLI::Error& error) {
        return m_app->exit(error) == 0 ? exit_done : exit_usage;
    };
    try {
        m_app->parse(argc, argv);
        const auto verbs = m_app->get_subcommands();
        return action(verbs.empty() ? "" : verbs.front()->get_name());
    } catch (const CLI::ParseError& error) {
        return exit(error);
    } catch (const UsageError& error) {
        return exit(CLI::ValidationError(error.what()));
    }
}
