#include "cli/command_line.h"

#include "base/text.h"
#include "cli/help_format.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace {
// An unset variable of a script must not count as an option that is not given.
std::string complaint_of_empty(const std::string& text) {
    return text.empty() ? "the value is empty" : "";
}

/// An option. The second word of `names` is the name of its value in the help.
template <typename Value>
CLI::Option& added(CLI::App& app, const std::string& names, Value& value, const std::string& help) {
    const std::size_t space = std::min(names.find(' '), names.size());
    CLI::Option& option = *app.add_option(names.substr(0, space), value, help);
    option.type_name(names.substr(std::min(space + 1, names.size())));
    return option;
}

/// Option names of the program and of the parsed verb.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    for (const CLI::App* verb : app.get_subcommands())
        for (const std::string& name : option_names(*verb))
            names.push_back(name);
    return names;
}

std::string complaint_of_extra(const CLI::App& app) {
    const std::vector<std::string> extras = app.remaining(true);
    const auto is_option = [](const std::string& text) { return text.starts_with('-'); };
    const auto unknown = std::find_if(extras.begin(), extras.end(), is_option);
    if (unknown == extras.end())
        return unexpected_argument(fmt::format("{}", fmt::join(extras, " ")));
    const std::string option = unknown->substr(0, unknown->find('='));
    return fmt::format("unknown option '{}'{}", option, did_you_mean(option, option_names(app)));
}

/// CLI11's messages, reworded. Messages of our checks stay unchanged.
std::string complaint_of(const CLI::App& app, const CLI::Error& error) {
    std::string text = error.what();
    switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
        case CLI::ExitCodes::ArgumentMismatch: {
            const std::string option = text.substr(0, text.find(':'));
            return text.find("At Most") != std::string::npos
                       ? fmt::format("{} can be given only once", option)
                       : fmt::format("{} needs a value", option);
        }
        case CLI::ExitCodes::ExcludesError: {
            constexpr std::string_view between = " excludes ";
            const std::size_t middle = std::min(text.find(between), text.size());
            return fmt::format("{} and {} can't be used together", text.substr(0, middle),
                               text.substr(std::min(middle + between.size(), text.size())));
        }
        case CLI::ExitCodes::ExtrasError:
            return complaint_of_extra(app);
        default:
            return text;
    }
}

std::string message_of(const CLI::App* app, const CLI::Error& error) {
    std::string command = app->get_name();
    for (const CLI::App* verb : app->get_subcommands())
        command += ' ' + verb->get_name();
    return fmt::format("{}\nRun '{} --help' for help.\n", complaint_of(*app, error), command);
}

std::string end_of_help(const std::string& note, Examples examples) {
    return fmt::format("{}\n\nExamples:\n  {}", note, fmt::join(examples, "\n  "));
}
}  // namespace

std::string unexpected_argument(const std::string& argument) {
    return fmt::format("unexpected argument '{}'", argument);
}

void add_argument(std::vector<std::string>& arguments, const std::string& name,
                  const std::string& value) {
    if (!value.empty())
        arguments.insert(arguments.end(), {name, value});
}

std::string or_list(const std::vector<std::string>& words) {
    if (words.size() == 1)
        return words.front();
    return fmt::format("{} or {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

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
                       : fmt::format("expected a whole number from {} to {}, got '{}'", low, high,
                                     text);
    });
    return *this;
}

Option& Option::between(double low, double high) {
    m_option->check([=](const std::string& text) {
        const auto number = parse_number(text);
        const bool is_good = number && *number >= low && *number <= high;
        return is_good ? std::string()
                       : fmt::format("expected a number from {} to {}, got '{}'", low, high, text);
    });
    return *this;
}

Option& Option::one_of(const std::vector<std::string>& values) {
    m_option->check([=](const std::string& text) {
        const bool is_good = std::find(values.begin(), values.end(), text) != values.end();
        return is_good ? std::string()
                       : fmt::format("unknown word '{}'; use {}", text, or_list(values));
    });
    return *this;
}

Option& Option::repeated() {
    m_option->take_all()->allow_extra_args(false);
    return *this;
}

Option& Option::or_alone(const std::string& value) {
    m_option->expected(0, CLI::detail::expected_max_vector_size)->default_str(value);
    return *this;
}

Option& Option::excludes(const Option& other) {
    m_option->excludes(other.m_option);
    return *this;
}

Option& Option::hidden() {
    m_option->group("");
    return *this;
}

Option Options::add(const std::string& names, std::string& value, const std::string& help) {
    return Option(*added(*m_app, names, value, help).check(complaint_of_empty));
}

Option Options::add(const std::string& names, std::vector<std::string>& values,
                    const std::string& help) {
    return Option(*added(*m_app, names, values, help).check(complaint_of_empty));
}

Option Options::add(const std::string& names, int& value, const std::string& help) {
    return Option(added(*m_app, names, value, help));
}

Option Options::add(const std::string& names, double& value, const std::string& help) {
    return Option(added(*m_app, names, value, help));
}

Option Options::add_flag(const std::string& names, bool& value, const std::string& help) {
    return Option(*m_app->add_flag(names, value, help));
}

Option Options::add_flag(const std::string& names, const std::string& help) {
    return Option(*m_app->add_flag(names)->description(help));
}

CommandLine::CommandLine(const std::string& name, const std::string& version,
                         const std::string& about, const std::string& note, Examples examples)
    : m_app(std::make_unique<CLI::App>(about, name)) {
    m_app->formatter(make_help_format());
    m_app->failure_message(message_of);
    m_app->set_help_flag("-h,--help", "Print this help");
    m_app->set_version_flag("--version", name + ' ' + version, "Print the version");
    m_app->footer(end_of_help(note, examples));
    m_app->require_subcommand(0, 1);
    m_app->fallthrough();
}

CommandLine::~CommandLine() = default;

Options CommandLine::options() {
    return Options(*m_app);
}

Options CommandLine::add_verb(const std::string& name, const std::string& help, Examples examples) {
    CLI::App* verb = m_app->add_subcommand(name, help)->group("Commands");
    verb->footer(end_of_help(
        fmt::format("Every command also takes --data, --include and --limit: see '{} --help'.",
                    m_app->get_name()),
        examples));
    return Options(*verb);
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
