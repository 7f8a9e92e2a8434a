#include "cli/cli.h"

#include "base/text.h"
#include "cli/common.h"
#include "lab/library/open.h"

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
    Verb{"list", add_list},           Verb{"render", add_render},   Verb{"check", add_check},
    Verb{"describe", add_describe},   Verb{"preset", add_preset},   Verb{"compare", add_compare},
    Verb{"bench", add_bench},         Verb{"sheet", add_sheet},     Verb{"sweep", add_sweep},
    Verb{"signal", add_signal},       Verb{"impulse", add_impulse}, Verb{"corpus", add_corpus},
    Verb{"export", add_export},       Verb{"golden", add_golden},   Verb{"pack", add_pack},
    Verb{"thumbnail", add_thumbnail}, Verb{"gallery", add_gallery}, Verb{"match", add_match},
    Verb{"jobs", add_jobs},
};

std::string about() {
    return fmt::format(
        "Afterglow: a lab for CRT, phosphor and oscilloscope looks\n\n"
        "Without a command, the window opens. All commands work without a display.\n\n"
        "LOOK is a look (name or folder), a stack of looks (phosphor+crt), a shader of another "
        "program ({}), or a preset (file, PNG with a preset, or line of text). The window also "
        "opens sounds, pictures and videos.",
        other_programs());
}

constexpr std::array program_examples{
    "afterglow",
    "afterglow phosphor+crt",
    "afterglow song.flac",
    "afterglow render phosphor --preset amber-p3 -o amber.png",
};

// A misspelt command looks like the name of a look and would open the window.
void check_is_no_command(const std::string& look, const DataFolders& data) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs)
        names.emplace_back(verb.name);
    const auto library = open_library(data);
    const bool may_be_look = look.find_first_of("/.:+") != std::string::npos || !library ||
                             library->find_look(look).has_value();
    const std::string guess = did_you_mean(look, names);
    if (!may_be_look && !guess.empty() && !std::filesystem::exists(look))
        throw UsageError(fmt::format("unknown command or look '{}'{}", look, guess));
}

// Reports output that cannot be written, for example to a full disk.
int with_output_written(int code) {
    errno = 0;
    std::cout.flush();
    if (std::cout)
        return code;
    return report({{{},
                    0,
                    errno ? fmt::format("can't write the output: {}", std::strerror(errno))
                          : std::string("can't write the output")}});
}

std::string note_of_help() {
    const ShaderLimits defaults;
    std::string note = "Limits of --limit, with their defaults:";
    for (const ShaderLimit& limit : shader_limits)
        note +=
            fmt::format("\n  {:<22} {}",
                        fmt::format("{}={:.0f}", limit.name, defaults.*limit.value), limit.about);
    return note + "\n\nRun 'afterglow COMMAND --help' for the options of a command.";
}

void set_limits(DataFolders& data) {
    for (const std::string& text : data.limit_texts)
        if (const auto set = set_limit(data.limits, text); !set)
            throw UsageError(fmt::format("--limit: {}", set.error().front().message));
}

/// Runs the parsed command, or opens the window without a command.
int run_parsed(const std::string& verb, const std::map<std::string, Command>& commands,
               const std::string& look, const DataFolders& data, const OpenWindow& open_window) {
    if (!verb.empty() && !look.empty())
        throw UsageError(unexpected_argument(look));
    if (!verb.empty())
        return with_output_written(commands.at(verb)(data));
    check_is_no_command(look, data);
    return open_window(look, data);
}
}  // namespace

int run_program(int argc, const char* const* argv, const OpenWindow& open_window) {
    CommandLine program("afterglow", AFTERGLOW_VERSION, about(), note_of_help(), program_examples);
    std::string look;
    DataFolders data;
    Options options = program.options();
    options.add("LOOK", look, "What the window opens (default: the last look)");
    options.add("--data FOLDER", data.data, "Folder that contains shaders/ and presets/");
    options.add("--include FOLDER", data.includes, "Folder that shaders can include files from")
        .repeated();
    options
        .add("--limit NAME=VALUE", data.limit_texts,
             "Set one of the limits for shaders listed below")
        .repeated();
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
