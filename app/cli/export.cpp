#include "cli/common.h"
#include "lab/export/export_target.h"
#include "lab/files/file_rows.h"

#include <fmt/format.h>

#include <array>
#include <iostream>

namespace {
constexpr std::array export_examples{
    "afterglow export phosphor --to portable -o phosphor-look",
    "afterglow export crt --preset arcade-cabinet --to portable -o cabinet",
    "afterglow export crt --to portable --dry-run",
};

struct ExportArguments {
    LookOptions look;
    std::string target;
    std::string output;
    bool is_dry_run = false;
};

std::string about() {
    std::string text = "Export a look for other programs\n\n";
    for (const ExportTarget& target : export_targets())
        text += fmt::format("TARGET '{}' writes {}. ", target.name, target.help);
    return text + "This works without OpenGL.";
}

int print_losses(const ExportTarget& target, const PreparedLook& prepared) {
    const auto losses = target.losses(prepared);
    for (const std::string& loss : losses)
        std::cout << loss << '\n';
    if (losses.empty())
        std::cout << "nothing is lost\n";
    return exit_done;
}

int write(const ExportTarget& target, const ExportRequest& request) {
    const auto made = target.write(request);
    if (!made)
        return report(made.error());
    std::cout << fmt::format("{}: {} files, {}\n", made->path.string(), made->files,
                             file_size_text(made->bytes));
    return exit_done;
}
}  // namespace

/// afterglow export LOOK --to TARGET -o PATH
Command add_export(CommandLine& program) {
    Options options = program.add_verb("export", about(), export_examples);
    auto arguments = std::make_shared<ExportArguments>();
    arguments->look.add_to(options, LookOptions::Take::values);
    options.add("--to TARGET", arguments->target, "Program or format to export for").required();
    options.add("-o,--output PATH", arguments->output, "Folder to write");
    options.add_flag("--dry-run", arguments->is_dry_run,
                     "Print what would be lost, and write nothing");
    return [arguments](const DataFolders& data) {
        const auto target = find_export_target(arguments->target);
        if (!target)
            throw UsageError("--to: " + target.error().front().message);
        if (arguments->output.empty() && !arguments->is_dry_run)
            throw UsageError("-o: missing. Add -o PATH, or --dry-run.");
        const RenderRequest request = arguments->look.request();
        return run_prepared(request, data, [&](const PreparedLook& prepared, const Library&) {
            return arguments->is_dry_run
                       ? print_losses(**target, prepared)
                       : write(**target, {prepared, request.size, arguments->output});
        });
    };
}
