#include "cli/common.h"
#include "lab/document/sharing.h"

#include <array>
#include <iostream>

namespace {
constexpr std::array preset_examples{
    "afterglow preset phosphor --set decay=0.97 --name Slow -o slow.json",
    "afterglow preset slow.json --line",
    "afterglow preset picture.png -o picture.json",
};
}  // namespace

/// afterglow preset LOOK [--preset F] [--set …] -o F.json | --line
Command add_preset(CommandLine& program) {
    struct Arguments {
        LookOptions look;
        std::string output;
        std::string name;
        bool as_line = false;
    };
    Options options =
        program.add_verb("preset", "Create, convert or share a preset", preset_examples);
    auto arguments = std::make_shared<Arguments>();
    arguments->look.add_to(options, LookOptions::Take::values);
    Option output =
        options.add("-o,--output FILE", arguments->output, "Save the preset as a .json file");
    options.add("--name NAME", arguments->name, "Name of the preset");
    Option line =
        options.add_flag("--line", arguments->as_line, "Print the preset as one line of text");
    line.excludes(output);
    return [arguments](const DataFolders& data) {
        if (!arguments->as_line && arguments->output.empty())
            throw UsageError("--output FILE or --line is required");
        if (!arguments->as_line)
            check_ending("--output", arguments->output, {".json"});
        const auto write = [&](const PreparedLook& prepared, const Library& library) -> int {
            const RecentMedia recent(library.roots());
            if (arguments->as_line) {
                std::cout << share_line_of(prepared.document, recent) << '\n';
                return exit_done;
            }
            const auto saved =
                write_preset(prepared.document, arguments->name, arguments->output, recent);
            return saved ? exit_done : report(saved.error());
        };
        return run_prepared(arguments->look.request(), data, write);
    };
}
