#include "cli/common.h"
#include "lab/sharing.h"

#include <iostream>

/// afterglow preset LOOK [--preset F] [--set …] -o F.json | --line
Command add_preset(CommandLine& program) {
    struct Arguments {
        LookOptions look;
        std::string output;
        std::string name;
        bool as_line = false;
    };
    Options options = program.add_verb("preset", "Make, convert or share a preset");
    auto arguments = std::make_shared<Arguments>();
    arguments->look.add_to(options, LookOptions::Take::values);
    Option output = options.add("-o,--output", arguments->output, "The file to write, .json");
    options.add("--name", arguments->name, "What the preset is called");
    Option line = options.add_flag("--line", arguments->as_line, "Print it as one line of text");
    line.excludes(output);
    return [arguments](const DataFolders& data) {
        if (!arguments->as_line && arguments->output.empty())
            throw UsageError("-o F.json or --line is required");
        if (!arguments->as_line)
            check_ending("--output", arguments->output, {".json"});
        const auto library = open_library(data);
        if (!library)
            return report(library.error());
        auto prepared = prepare(arguments->look.request(), *library);
        if (!prepared)
            return report(prepared.error());
        warn(prepared->warnings);
        const RecentMedia recent(library->roots());
        if (arguments->as_line) {
            std::cout << share_line_of(prepared->document, recent) << '\n';
            return exit_done;
        }
        const auto saved =
            write_preset(prepared->document, arguments->name, arguments->output, recent);
        return saved ? exit_done : report(saved.error());
    };
}
