#include "cli/cli.h"

#include "base/text.h"
#include "cli/common.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>

namespace {
struct Verb {
    const char* name;
    Command (*add)(CLI::App&);
};

constexpr std::array verbs{
    Verb{"list", add_list},         Verb{"render", add_render}, Verb{"check", add_check},
    Verb{"describe", add_describe}, Verb{"preset", add_preset}, Verb{"compare", add_compare},
    Verb{"bench", add_bench},       Verb{"sheet", add_sheet},   Verb{"signal", add_signal},
};

constexpr const char* about =
    "The lab for the CRT, phosphor and oscilloscope look.\n\n"
    "afterglow [LOOK] opens the window; the commands work without a display.\n"
    "LOOK is a look's folder or name, a stack of looks as in phosphor+crt, or a preset: a file,\n"
    "a PNG that holds one, or its line of text.";

// A misspelt command reads like the name of a look, and would open a window.
void check_is_no_command(const std::string& look, const std::string& data) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs)
        names.emplace_back(verb.name);
    const auto library = open_library(data);
    const bool may_be_look = look.find_first_of("/.:+") != std::string::npos || !library ||
                             library->find_look(look).has_value();
    const std::string guess = did_you_mean(look, names);
    if (!may_be_look && !guess.empty() && !std::filesystem::exists(look))
        throw CLI::ValidationError("there is no look and no command '" + look + "'" + guess);
}

// What was printed must have arrived: a full disk is told here.
int with_output_written(int code) {
    errno = 0;
    std::cout.flush();
    if (std::cout)
        return code;
    const std::string reason = errno ? std::strerror(errno) : "nobody reads it";
    return report({{{}, 0, "the output cannot be written: " + reason}});
}

/// Runs the command that was parsed, or opens the window when there was none.
int run_parsed(const CLI::App& program, const std::vector<Command>& commands,
               const std::string& look, const std::string& data, const OpenWindow& open_window) {
    for (std::size_t i = 0; i < verbs.size(); ++i) {
        if (!program.got_subcommand(verbs[i].name))
            continue;
        if (!look.empty())
            throw CLI::ExtrasError(verbs[i].name, {look});
        return with_output_written(commands[i](data));
    }
    check_is_no_command(look, data);
    return open_window(look, data);
}
}  // namespace

int run_program(int argc, const char* const* argv, const OpenWindow& open_window) {
    CLI::App program{about};
    program.name("afterglow");
    program.set_version_flag("--version", "afterglow " AFTERGLOW_VERSION);
    program.require_subcommand(0, 1);
    std::string look;
    std::string data;
    program.add_option("LOOK", look, "What the window opens; the last one when it is left out");
    program.add_option("--data", data, "The folder that holds shaders/ and presets/");
    program.fallthrough();
    std::vector<Command> commands;
    for (const Verb& verb : verbs)
        commands.push_back(verb.add(program));
    try {
        program.parse(argc, argv);
        return run_parsed(program, commands, look, data, open_window);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? exit_done : exit_usage;
    } catch (const std::exception& error) {
        return report({{{}, 0, error.what()}});
    }
}
