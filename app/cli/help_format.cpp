#include "cli/help_format.h"

#include "base/text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {
constexpr std::size_t max_columns = 80;
constexpr std::size_t option_column = 25;   // start of the text of an option
constexpr std::size_t command_column = 13;  // start of the text of a command

// Wraps the text at spaces. Lines after the first start at `column`.
std::string wrapped(std::string_view text, std::size_t column) {
    std::string result;
    std::size_t end = column;
    const auto break_line = [&] {
        result += '\n' + std::string(column, ' ');
        end = column;
    };
    for (const std::string_view line : split(text, '\n')) {
        if (line.data() != text.data())
            break_line();
        for (const std::string_view word : split(line, ' ')) {
            if (end > column && end + 1 + word.size() > max_columns) {
                break_line();
            } else if (end > column) {
                result += ' ';
                ++end;
            }
            result += word;
            end += word.size();
        }
    }
    return result;
}

// A name that reaches the column of the text gets its own line.
std::string help_row(const std::string& name, std::string_view text, std::size_t column) {
    std::string left = "  " + name;
    if (left.size() + 2 > column)
        left += '\n' + std::string(column, ' ');
    else
        left.resize(column, ' ');
    return left + wrapped(text, column) + '\n';
}

bool is_list(const CLI::Option& option) {
    return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

/// Notes such as " (required, repeatable)", or "".
std::string notes_of(const CLI::Option& option) {
    std::vector<std::string> notes;
    if (option.get_required())
        notes.emplace_back("required");
    if (is_list(option))
        notes.emplace_back("repeatable");
    if (!option.get_default_str().empty() && option.get_expected_min() > 0)
        notes.push_back(fmt::format("default: {}", option.get_default_str()));
    for (const CLI::Option* other : option.get_excludes())
        notes.push_back(fmt::format("not with {}", other->get_name()));
    return notes.empty() ? std::string() : fmt::format(" ({})", fmt::join(notes, ", "));
}

class HelpFormat : public CLI::Formatter {
public:
    HelpFormat() { label("Positionals", "Arguments"); }

    std::string make_description(const CLI::App* app) const override {
        return wrapped(app->get_description(), 0) + "\n\n";
    }

    std::string make_usage(const CLI::App* app, std::string name) const override {
        if (app->get_parent() == nullptr)
            return fmt::format("Usage: {0} [OPTIONS] [LOOK]\n       {0} COMMAND [OPTIONS] ...\n",
                               name);
        std::string usage = fmt::format("Usage: {}", name);
        for (const CLI::Option* option : app->get_options()) {
            if (option->get_positional())
                usage += ' ' + make_option_usage(option);
            else if (option->get_required())
                usage += fmt::format(" {} {}", option->get_name(), option->get_type_name());
        }
        return usage + " [OPTIONS]\n";
    }

    std::string make_option(const CLI::Option* option, bool is_positional) const override {
        if (is_positional)
            return help_row(option->get_name(true), option->get_description(), option_column);
        std::string name = replace_all(option->get_name(false, true), ",", ", ");
        if (!option->get_type_name().empty())
            name += ' ' + option->get_type_name();
        return help_row(name, option->get_description() + notes_of(*option), option_column);
    }

    std::string make_subcommand(const CLI::App* command) const override {
        const std::string text = command->get_description();
        return help_row(command->get_name(), text.substr(0, text.find('\n')), command_column);
    }
};
}  // namespace

std::shared_ptr<CLI::FormatterBase> make_help_format() {
    return std::make_shared<HelpFormat>();
}
