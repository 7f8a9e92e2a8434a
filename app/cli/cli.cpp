#include "cli/cli.h"

#include "base/text.h"
#include "cli/common.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>
#include <map>

namespace {
struct Verb {
    const char* name;
    Command (*add)(CommandLine&);
};

constexpr std::array verbs{
    Verb{"list", add_list},         Verb{"render", add_render},   Verb{"check", add_check},
    Verb{"describe", add_describe}, Verb{"preset", add_preset},   Verb{"compare", add_compare},
    Verb{"bench", add_bench},       Verb{"sheet", add_sheet},     Verb{"sweep", add_sweep},
    Verb{"signal", add_signal},     Verb{"impulse", add_impulse}, Verb{"corpus", add_corpus},
};

constexpr const char* about =
    "The lab for the CRT, phosphor and oscilloscope look.\n\n"
    "afterglow [LOOK] opens the window, also on a sound, picture or preset; the commands work "
    "without a display.\n"
    "LOOK is a look's folder or name, a stack of looks as in phosphor+crt, a shader of another\n"
    "program (libretro's .slangp and .slang, ISF, Shadertoy, a fragment shader alone), or a\n"
    "preset: a file, a PNG that holds one, or its line of text.";

// A misspelt command reads like the name of a look, and would open a window.
void check_is_no_command(const std::string& look, const DataFolders& data) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs)
        names.emplace_back(verb.name);
    const auto library = open_library(data);
    const bool may_be_look = look.find_first_of("/.:+") != std::string::npos || !library ||
                             library->find_look(look).has_value();
    const std::string guess = did_you_mean(look, names);
    if (!may_be_look && !guess.empty() && !std::filesystem::exists(look))
        throw UsageError("there is no look and no command '" + look + "'" + guess);
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

std::string help_of_limits() {
    const ShaderLimits defaults;
    std::string help = "NAME=VALUE, a larger limit for shaders; may be given again and again.";
    for (const ShaderLimit& limit : shader_limits)
        help += fmt::format("\n{} ({:.0f}): {}", limit.name, defaults.*limit.value, limit.about);
    return help;
}

void set_limits(DataFolders& data) {
    for (const std::string& text : data.limit_texts)
        if (const auto set = set_limit(data.limits, text); !set)
            throw UsageError("--limit: " + set.error().front().message);
}

/// Runs the command that was parsed, or opens the window when there was none.
int run_parsed(const std::string& verb, const std::map<std::string, Command>& commands,
               const std::string& look, const DataFolders& data, const OpenWindow& open_window) {
    if (!verb.empty() && !look.empty())
        throw UsageError("The following argument was not expected: " + look);
    if (!verb.empty())
        return with_output_written(commands.at(verb)(data));
    check_is_no_command(look, data);
    return open_window(look, data);
}
}  // namespace

int run_program(int argc, const char* const* argv, const OpenWindow& open_window) {
    CommandLine program("afterglow", AFTERGLOW_VERSION, about);
    std::string look;
    DataFolders data;
    Options options = program.options();
    options.add("LOOK", look, "What the window opens; the last one when it is left out");
    options.add("--data", data.data, "The folder that holds shaders/ and presets/");
    options
        .add("--include", data.includes,
             "A folder that shaders may include files from; may be given again and again")
        .repeated();
    options.add("--limit", data.limit_texts, help_of_limits()).repeated();
    std::map<std::string, Command> commands;
    for (const Verb& verb : verbs)
        commands[verb.name] = verb.add(program);
    try {
        return program.run(argc, argv, [&](const std::string& verb) {
            set_limits(data);
            return run_parsed(verb, commands, look, data, open_window);
        });
    } catch (const std::exception& error) {
        return report({{{}, 0, error.what()}});
    }
}
