#include "lab/export/effect_export.h"

#include "base/file.h"
#include "formats/isf_export/isf_export.h"
#include "formats/look_format.h"
#include "formats/slang_export/slang_export.h"
#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "io/files/scratch_folder.h"
#include "lab/export/described_look.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
/// A format whose main file has the files that it reads in a folder next to it.
struct EffectFormat {
    const char* extension;  // ".slangp"
    const char* folder;     // "_shaders", after the name of the main file
    Result<EffectOutput> (*write)(const EffectRequest& request);
};

constexpr EffectFormat slang_format{".slangp", "_shaders", slang_files};
constexpr EffectFormat isf_format{".fs", "_pictures", isf_files};

Result<void> check_path(const fs::path& path, const EffectFormat& format) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return fail(
            {path, 0,
             fmt::format("is a folder. Add a file name, such as look{}.", format.extension)});
    if (path.extension() != format.extension)
        return fail({path, 0, fmt::format("needs the ending {}", format.extension)});
    const fs::path folder = path.parent_path() / (path.stem().string() + format.folder);
    if (fs::exists(folder, error) && !fs::exists(path, error))
        return fail({folder, 0, "is there already. Remove it, or choose another name."});
    return {};
}

Result<EffectOutput> output_of(const PreparedLook& prepared, Extent size, const std::string& name,
                               const EffectFormat& format) {
    const Document& document = prepared.document;
    const Look look = document.drawn_look();
    const auto notices = notices_of(look);
    if (!notices)
        return fail(notices.error());
    auto output = format.write({.look = look,
                                .values = document.values(),
                                .size = size,
                                .source = size,
                                .name = name,
                                .notices = *notices});
    if (output)
        for (const auto& [parameter, modulation] : document.state().modulations)
            if (const Parameter* moved = find_parameter(look, parameter))
                output->losses.push_back(fmt::format(
                    "The modulation of '{}'. The control keeps its present value.", moved->label));
    return output;
}

// Writes the files below a folder.
Result<ExportedLook> write_files(const EffectOutput& output, const fs::path& folder) {
    ExportedLook made;
    std::error_code error;
    const auto write = [&](const std::string& path, const std::string& bytes) {
        const fs::path file = folder / path;
        fs::create_directories(file.parent_path(), error);
        ++made.files;
        made.bytes += bytes.size();
        return write_atomically(file, bytes);
    };
    for (const auto& [path, text] : output.texts)
        if (auto written = write(path, text); !written)
            return fail(written.error());
    for (const auto& [path, picture] : output.pictures)
        if (auto written = write(path, picture.bytes); !written)
            return fail(written.error());
    return made;
}

// Moves checked files to their place: first the folder, then the main file.
Result<void> move_into_place(const fs::path& from, const fs::path& path,
                             const EffectFormat& format) {
    const std::string stem = path.stem().string();
    const std::string folder = stem + format.folder;
    std::error_code error;
    if (fs::exists(from / folder, error)) {
        auto target = AtomicFolder::create(path.parent_path() / folder);
        if (!target)
            return fail(target.error());
        fs::copy(from / folder, target->path(), fs::copy_options::recursive, error);
        if (error)
            return fail({path.parent_path() / folder, 0, error.message()});
        if (auto done = target->finish(); !done)
            return fail(done.error());
    }
    const auto text = read_bytes(from / path.filename());
    return text ? write_atomically(path, *text) : fail(text.error());
}

// The files are opened before they get to their place.
Result<ExportedLook> export_effect(const ExportRequest& request, const EffectFormat& format) {
    if (auto good = check_path(request.path, format); !good)
        return fail(good.error());
    const auto output =
        output_of(request.prepared, request.size, request.path.stem().string(), format);
    if (!output)
        return fail(output.error());
    const auto scratch = ScratchFolder::create();
    if (!scratch)
        return fail(scratch.error());
    auto made = write_files(*output, scratch->path());
    if (!made)
        return made;
    ExportRequest written = request;
    written.path = scratch->path() / request.path.filename();
    if (auto good = check_effect(written); !good)
        return fail(good.error());
    if (auto moved = move_into_place(scratch->path(), request.path, format); !moved)
        return fail(moved.error());
    made->path = request.path;
    return made;
}
}  // namespace

Result<ExportedLook> export_slang(const ExportRequest& request) {
    return export_effect(request, slang_format);
}

namespace {
Result<std::vector<std::string>> losses_in(const PreparedLook& prepared,
                                           const EffectFormat& format) {
    constexpr Extent usual{1280, 720};
    auto output = output_of(prepared, usual, "look", format);
    return output ? Result<std::vector<std::string>>(std::move(output->losses))
                  : fail(output.error());
}
}  // namespace

Result<std::vector<std::string>> slang_losses(const PreparedLook& prepared) {
    return losses_in(prepared, slang_format);
}

Result<ExportedLook> export_isf(const ExportRequest& request) {
    return export_effect(request, isf_format);
}

Result<std::vector<std::string>> isf_losses(const PreparedLook& prepared) {
    return losses_in(prepared, isf_format);
}

Result<void> check_effect(const ExportRequest& request) {
    const LoadedLook read = load_look(request.path, {});
    if (!read.look)
        return fail(read.look.error());
    if (!read.warnings.empty())
        return fail(read.warnings);
    return {};
}
