#include "cli/common.h"
#include "io/files/atomic_file.h"
#include "lab/packs/file_thumbnail.h"

#include <array>

namespace {
constexpr std::array thumbnail_examples{
    "afterglow thumbnail mine.json -o mine.png",
    "afterglow thumbnail tubes.afterglow -o tubes.png",
};

struct ThumbnailArguments {
    std::string file;
    std::string output;
};

int write_thumbnail(const ThumbnailArguments& arguments, const DataFolders& data) {
    check_ending("--output", arguments.output, {".png"});
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    const auto png = file_thumbnail(arguments.file, *library);
    if (!png)
        return report(png.error());
    const auto written = write_atomically(arguments.output, *png);
    return written ? exit_done : report(written.error());
}
}  // namespace

/// afterglow thumbnail FILE -o OUT
Command add_thumbnail(CommandLine& program) {
    Options options = program.add_verb(
        "thumbnail",
        "Write the small picture that file managers show\n\n"
        "A look or preset is drawn. A pack already has pictures; nothing of it is drawn.",
        thumbnail_examples);
    auto arguments = std::make_shared<ThumbnailArguments>();
    options.add("FILE", arguments->file, "Preset, pack, look.json or shader of another program")
        .required();
    options.add("-o,--output FILE", arguments->output, "Picture to write: NAME.png").required();
    return [arguments](const DataFolders& data) { return write_thumbnail(*arguments, data); };
}
