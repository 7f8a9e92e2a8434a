#include "cli/common.h"
#include "lab/export/export_target.h"
#include "lab/export/verification.h"
#include "lab/files/file_rows.h"
#include "lab/library/library.h"
#include "lab/send/look_sender.h"
#include "lab/send/running_program.h"

#include <fmt/format.h>

#include <array>
#include <iostream>

namespace {
constexpr std::array export_examples{
    "afterglow export phosphor --to web -o phosphor.html",
    "afterglow export crt --preset arcade-cabinet --to web -o cabinet.html --verify",
    "afterglow export crt --to slang -o crt.slangp",
    "afterglow export phosphor+crt --to web --dry-run",
};

struct ExportArguments {
    LookOptions look;
    std::string target;
    std::string output;
    std::string send;  // address of a running program; "": do not send
    bool is_dry_run = false;
    bool has_stages = false;
    bool has_parameters = false;
    bool verifies = false;
    double timeout = 60.0;  // s
};

std::string about() {
    std::string text = "Export a look for other programs\n\n";
    for (const ExportTarget& target : export_targets())
        text += fmt::format("TARGET '{}' writes {}. ", target.name, target.help);
    return text + "Only --verify needs OpenGL.";
}

int print_losses(const ExportTarget& target, const PreparedLook& prepared) {
    const auto losses = losses_of(target, prepared);
    if (!losses)
        return report(losses.error());
    for (const std::string& loss : *losses)
        std::cout << loss << '\n';
    if (losses->empty())
        std::cout << "nothing is lost\n";
    return exit_done;
}

int verify(const ExportTarget& target, const ExportRequest& request, double timeout) {
    const Verification verification = verify_export(target, request, timeout);
    std::cout << verification.text << '\n';
    return verification.outcome == Verification::Outcome::verified ? exit_done : exit_failure;
}

int send(const ExportRequest& request, const ExportArguments& arguments, const Library& library) {
    const std::size_t program = *program_for(arguments.target);
    const auto sent = send_look(request.prepared, request.size, {program, arguments.send},
                                library.roots().cache / "sent");
    if (!sent)
        return report(sent.error());
    std::cout << fmt::format("sent to {}\n", running_programs()[program].name);
    return exit_done;
}

int write(const ExportTarget& target, const ExportRequest& request,
          const ExportArguments& arguments) {
    const auto made = export_look(target, request);
    if (!made)
        return report(made.error());
    std::cout << fmt::format("{}: {} {}, {}\n", made->path.string(), made->files,
                             made->files == 1 ? "file" : "files", file_size_text(made->bytes));
    return arguments.verifies ? verify(target, request, arguments.timeout) : exit_done;
}
}  // namespace

/// afterglow export LOOK --to TARGET -o PATH
Command add_export(CommandLine& program) {
    Options options = program.add_verb("export", about(), export_examples);
    auto arguments = std::make_shared<ExportArguments>();
    arguments->look.add_to(options, LookOptions::Take::values);
    options.add("--to TARGET", arguments->target, "Program or format to export for").required();
    options.add("-o,--output PATH", arguments->output,
                "File or folder to write. A portable look can be a .zip");
    options.add("--send ADDRESS", arguments->send,
                "Also load the export in the running program: the port of RetroArch's network "
                "commands (usually 55355), or the socket of mpv's --input-ipc-server");
    options.add_flag("--stages", arguments->has_stages,
                     "With 'portable': also write the shaders as SPIR-V, GLSL ES 3.00, HLSL and "
                     "MSL");
    options.add_flag("--params", arguments->has_parameters,
                     "With 'mpv': write values as parameters, for libplacebo 5 or newer");
    options.add_flag("--dry-run", arguments->is_dry_run,
                     "Print what would be lost, and write nothing");
    options.add_flag("--verify", arguments->verifies,
                     "Also draw the export and compare the pictures. A difference is an error. "
                     "'web' and 'portable' need Chromium");
    options.add("--timeout S", arguments->timeout,
                "With --verify: seconds that Chromium may take (default: 60)");
    return [arguments](const DataFolders& data) {
        const auto target = find_export_target(arguments->target);
        if (!target)
            throw UsageError("--to: " + target.error().front().message);
        if (arguments->output.empty() && !arguments->is_dry_run && arguments->send.empty())
            throw UsageError("-o: missing. Add -o PATH, --send ADDRESS or --dry-run.");
        if (!arguments->send.empty() && !program_for(arguments->target))
            throw UsageError("--send: only with --to slang or --to mpv");
        if (arguments->has_stages && arguments->target != "portable")
            throw UsageError("--stages: only with --to portable");
        if (arguments->has_parameters && arguments->target != "mpv")
            throw UsageError("--params: only with --to mpv");
        if (arguments->timeout <= 0.0)
            throw UsageError("--timeout: must be above 0");
        const RenderRequest request = arguments->look.request();
        return run_prepared(
            request, data, [&](const PreparedLook& prepared, const Library& library) {
                const ExportRequest wanted{prepared, request.size, arguments->output,
                                           arguments->has_stages, arguments->has_parameters};
                if (arguments->is_dry_run)
                    return print_losses(**target, prepared);
                const int code =
                    arguments->output.empty() ? exit_done : write(**target, wanted, *arguments);
                return code == exit_done && !arguments->send.empty()
                           ? send(wanted, *arguments, library)
                           : code;
            });
    };
}
