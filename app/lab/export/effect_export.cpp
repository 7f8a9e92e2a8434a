#include "lab/export/effect_export.h"

#include "base/file.h"
#include "formats/isf_export/isf_export.h"
#include "formats/look_format.h"
#include "formats/mpv_export/mpv_check.h"
#include "formats/mpv_export/mpv_export.h"
#include "formats/reshade_export/reshade_export.h"
#include "formats/shadertoy_export/shadertoy_export.h"
#include "formats/slang_export/slang_export.h"
#include "glsl/cache/check_cache.h"
#include "glsl/limits/unbounded_loops.h"
#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "io/files/scratch_folder.h"
#include "lab/export/described_look.h"
#include "lab/media/source.h"
#include "model/picture/placing.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
/// A format whose main file has the files that it reads in a folder next to it.
struct EffectFormat {
    const char* label;        // "a RetroArch preset"
    const char* extension;    // ".slangp"
    std::string_view folder;  // "_shaders", after the name of the main file; "": no other files
    Result<EffectOutput> (*write)(const EffectRequest& request);
    Result<void> (*read)(const fs::path& file, const ShaderLimits& limits);
    bool has_subframes = false;  // as in ExportTarget
};

// Opened as a look, which compiles the shaders. Only a loop without a limit is the author's affair;
// any other warning is about what was written.
Result<void> read_look(const fs::path& file, const ShaderLimits& limits) {
    CheckCache cache(nullptr, limits);
    const LoadedLook read = load_look(file, {}, {.cache = &cache});
    if (!read.look)
        return fail(read.look.error());
    Diagnostics warnings = read.warnings;
    std::erase_if(warnings, [](const Diagnostic& one) { return one.message == unbounded_loop; });
    return warnings.empty() ? Result<void>() : fail(std::move(warnings));
}

Result<void> read_mpv(const fs::path& file, const ShaderLimits&) {
    const auto text = read_bytes(file);
    return text ? check_mpv_shader(*text) : fail(text.error());
}

// Afterglow can't compile effects of ReShade.
Result<void> read_reshade(const fs::path& file, const ShaderLimits&) {
    const auto text = read_bytes(file);
    return text ? Result<void>() : fail(text.error());
}

constexpr EffectFormat slang_format{"a RetroArch preset", ".slangp", "_shaders",
                                    slang_files,          read_look, true};
constexpr EffectFormat isf_format{"an ISF file", ".fs", "_pictures", isf_files, read_look};
constexpr EffectFormat mpv_format{"an mpv shader", ".glsl", "", mpv_files, read_mpv};
constexpr EffectFormat reshade_format{"a ReShade effect", ".fx", "_reshade", reshade_files,
                                      read_reshade};
constexpr EffectFormat shadertoy_format{"a Shadertoy shader", ".json", "_pictures", shadertoy_files,
                                        read_look};

const ShaderLimits& limits_of(const ExportRequest& request) {
    return request.prepared.document.look().shader_limits;
}

fs::path folder_of(const fs::path& path, const EffectFormat& format) {
    return path.parent_path() / (path.stem().string() + std::string(format.folder));
}

// The folder next to the main file is replaced, so it may only have files that the main file of an
// earlier export names.
Result<void> check_folder(const fs::path& path, const EffectFormat& format) {
    const fs::path folder = folder_of(path, format);
    std::error_code error;
    if (format.folder.empty() || !fs::exists(folder, error))
        return {};
    const std::string earlier = read_bytes(path).value_or(std::string());
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name =
            entry->path()
                .lexically_relative(path.parent_path().empty() ? fs::path(".") : path.parent_path())
                .generic_string();
        if (!entry->is_directory() && earlier.find(name) == std::string::npos)
            return fail({entry->path(), 0,
                         "isn't part of an earlier export. Move it, or choose another name."});
    }
    if (error)
        return fail({folder, 0, error.message()});
    return {};
}

Result<void> check_path(const fs::path& path, const EffectFormat& format) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return fail(
            {path, 0,
             fmt::format("is a folder. Add a file name, such as look{}.", format.extension)});
    if (path.extension() != format.extension)
        return fail({path, 0, fmt::format("needs the ending {}", format.extension)});
    if (path.filename() == "look.json")
        return fail({path, 0, "is the name of Afterglow's own looks. Choose another name."});
    return check_folder(path, format);
}

// The size of the source as the look sees it; the picture's size if there is no source.
Result<Extent> source_size(const Document& document, Extent size) {
    if (document.look().driven_by != Driver::picture || document.state().source.empty())
        return size;
    auto source = Source::open(document.state().source);
    if (!source)
        return fail(source.error());
    return placed_extent(source->extent(), source->spec(), size);
}

Result<EffectOutput> output_of(const ExportRequest& request, const EffectFormat& format) {
    const Document& document = request.prepared.document;
    const Look look = document.drawn_look();
    const auto notices = notices_of(look);
    if (!notices)
        return fail(notices.error());
    std::optional<Spec> signal;
    if (look.driven_by == Driver::signal) {
        auto complete = completed(document.state().signal);
        if (!complete)
            return fail(complete.error());
        signal = std::move(*complete);
    }
    const auto source = source_size(document, request.size);
    if (!source)
        return fail(source.error());
    auto output = format.write({.look = look,
                                .values = document.values(),
                                .size = request.size,
                                .source = *source,
                                .name = request.path.stem().string(),
                                .notices = *notices,
                                .has_live_parameters = request.has_parameters,
                                .folder = fs::absolute(request.path).parent_path(),
                                .signal = std::move(signal)});
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

// The error names the look, because the files are not in their place.
Result<void> check_files(const fs::path& file, const EffectFormat& format,
                         const ShaderLimits& limits) {
    const auto good = format.read(file, limits);
    if (good)
        return {};
    std::string_view reason = good.error().front().message;
    if (reason.ends_with('.'))
        reason.remove_suffix(1);
    return fail({{},
                 0,
                 fmt::format("the look can't be written as {}: {}. Export it with --to web or --to "
                             "portable.",
                             format.label, reason)});
}

/// Files in a temporary folder, which Afterglow could open.
struct CheckedFiles {
    ScratchFolder folder;
    fs::path main_file;
    ExportedLook made;
    std::vector<std::string> losses;
};

Result<CheckedFiles> checked_files(const ExportRequest& request, const EffectFormat& format) {
    auto output = output_of(request, format);
    if (!output)
        return fail(output.error());
    auto scratch = ScratchFolder::create();
    if (!scratch)
        return fail(scratch.error());
    auto made = write_files(*output, scratch->path());
    if (!made)
        return fail(made.error());
    const fs::path main_file = scratch->path() / request.path.filename();
    if (auto good = check_files(main_file, format, limits_of(request)); !good)
        return fail(good.error());
    return CheckedFiles{std::move(*scratch), main_file, *made, std::move(output->losses)};
}

// Replaces a folder of an earlier export, see check_folder().
Result<void> move_folder(const fs::path& from, const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(from, error)) {
        fs::remove_all(folder, error);
        return error ? Result<void>(fail({folder, 0, error.message()})) : Result<void>();
    }
    auto target = AtomicFolder::create(folder);
    if (!target)
        return fail(target.error());
    fs::copy(from, target->path(), fs::copy_options::recursive, error);
    if (error)
        return fail({folder, 0, error.message()});
    return target->finish();
}

// Moves checked files to their place: first the folder, then the main file.
Result<void> move_into_place(const fs::path& main_file, const fs::path& path,
                             const EffectFormat& format) {
    if (!format.folder.empty())
        if (auto moved = move_folder(folder_of(main_file, format), folder_of(path, format)); !moved)
            return moved;
    const auto text = read_bytes(main_file);
    return text ? write_atomically(path, *text) : fail(text.error());
}

Result<ExportedLook> export_effect(const ExportRequest& request, const EffectFormat& format) {
    if (auto good = check_path(request.path, format); !good)
        return fail(good.error());
    const auto files = checked_files(request, format);
    if (!files)
        return fail(files.error());
    if (auto moved = move_into_place(files->main_file, request.path, format); !moved)
        return fail(moved.error());
    ExportedLook made = files->made;
    made.path = request.path;
    return made;
}

Result<std::vector<std::string>> losses_in(const PreparedLook& prepared,
                                           const EffectFormat& format) {
    constexpr Extent usual{1280, 720};
    auto files =
        checked_files({prepared, usual, fs::path("export").concat(format.extension)}, format);
    return files ? Result<std::vector<std::string>>(std::move(files->losses)) : fail(files.error());
}

template <const EffectFormat& format>
ExportTarget target_of(std::string_view name, std::string_view label, std::string_view help,
                       const std::vector<std::string>& keeps, std::string_view why_not_drawn = {}) {
    return {.name = std::string(name),
            .label = std::string(label),
            .extension = format.extension,
            .help = std::string(help),
            .keeps = keeps,
            .has_subframes = format.has_subframes,
            .losses = [](const PreparedLook& prepared) { return losses_in(prepared, format); },
            .write = [](const ExportRequest& request) { return export_effect(request, format); },
            .check =
                [](const ExportRequest& request) {
                    return format.read(request.path, limits_of(request));
                },
            .page = nullptr,
            .why_not_drawn = std::string(why_not_drawn)};
}
}  // namespace

std::vector<ExportTarget> effect_targets() {
    return {
        target_of<slang_format>(
            "slang", "RetroArch preset",
            "a .slangp preset with its shaders, for RetroArch and other programs with libretro "
            "shaders",
            {"looks that process a picture", "all parameters, with label, range and step",
             "the author's shader text with its #include files"}),
        target_of<isf_format>("isf", "ISF shader",
                              "one .fs file, for VDMX and other programs with ISF shaders",
                              {"looks that process a picture",
                               "all parameters, with label and range", "the author's shader text"}),
        target_of<shadertoy_format>(
            "shadertoy", "Shadertoy shader",
            "one .json file with up to four buffers and an image, for Shadertoy and its players",
            {"looks that process a picture, with up to four buffers",
             "Phosphor with Lissajous figures, harmonics, AM and FM",
             "all parameters, as constants with annotations", "the author's shader text"}),
        target_of<mpv_format>(
            "mpv", "mpv shader", "one .glsl file, for mpv and other programs with its user shaders",
            {"looks that process a picture", "the author's shader text",
             "present values, as lines that you can edit"},
            "Afterglow can't draw user shaders of mpv. Compare the pictures in mpv"),
        target_of<reshade_format>(
            "reshade", "ReShade effect",
            "an .fx file with a preset and pictures, for ReShade and vkBasalt",
            {"looks that process a picture", "all parameters, with label, range and step",
             "licences and authors"},
            "Afterglow can't draw effects of ReShade"),
    };
}
