#include "lab/export/portable_export.h"

#include "base/file.h"
#include "glsl/compile/check.h"
#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "lab/export/described_look.h"
#include "lab/export/web_export.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
Result<std::uintmax_t> write_contents(const PortableFiles& files, const fs::path& folder) {
    std::uintmax_t bytes = 0;
    std::map<fs::path, std::string_view> contents(files.texts.begin(), files.texts.end());
    for (const auto& [path, picture] : files.generated)
        contents.emplace(path, picture.bytes);
    for (const auto& [path, content] : contents) {
        if (auto written = write_atomically(folder / path, content); !written)
            return fail(written.error());
        bytes += content.size();
    }
    return bytes;
}

Result<std::uintmax_t> copy_media(const PortableFiles& files, const fs::path& folder) {
    std::uintmax_t bytes = 0;
    for (const auto& [path, original] : files.media) {
        std::error_code error;
        fs::create_directories((folder / path).parent_path(), error);
        fs::copy_file(original, folder / path, error);
        if (error)
            return fail({original, 0, fmt::format("can't copy: {}", error.message())});
        bytes += fs::file_size(folder / path, error);
    }
    return bytes;
}

// Only an earlier export may be replaced, and only if the user has added nothing to it.
Result<void> check_target(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        return {};
    std::error_code ignored;
    const bool is_export = fs::exists(path / portable_file, ignored);
    const fs::directory_iterator entries(path, error);
    if (error || (!is_export && entries != fs::directory_iterator()))
        return fail({path, 0, "exists and is not an exported look. Choose another path."});
    for (const fs::directory_entry& entry : entries)
        if (const fs::path name = entry.path().filename();
            name != portable_file && name != shader_folder && name != copies_folder)
            return fail({entry.path(), 0,
                         "is not part of an exported look. Move it, or choose another path."});
    return {};
}
}  // namespace

Result<ExportedLook> export_portable(const ExportRequest& request) {
    if (auto good = check_target(request.path); !good)
        return fail(good.error());
    const auto files = described_files(request);
    if (!files)
        return fail(files.error());
    auto folder = AtomicFolder::create(request.path);
    if (!folder)
        return fail(folder.error());
    const auto contents = write_contents(*files, folder->path());
    if (!contents)
        return fail(contents.error());
    const auto media = copy_media(*files, folder->path());
    if (!media)
        return fail(media.error());
    if (auto done = folder->finish(); !done)
        return fail(done.error());
    return ExportedLook{request.path,
                        files->texts.size() + files->generated.size() + files->media.size(),
                        *contents + *media};
}

Result<std::vector<std::string>> portable_losses(const PreparedLook& prepared) {
    const Document& document = prepared.document;
    std::vector<std::string> losses;
    const auto source = parse_source(document.state().source);
    if (document.look().driven_by == Driver::picture && source && source->is_pattern() &&
        is_moving_pattern(source->picture.substr(std::string_view("pattern:").size())))
        losses.push_back("The moving test picture becomes a still picture.");
    return losses;
}

namespace {
// The files that a folder has, as if they had just been described.
Result<PortableFiles> read_portable(const ExportRequest& request) {
    auto files = described_files(request);
    if (!files)
        return files;
    for (auto& [path, text] : files->texts) {
        auto bytes = read_bytes(request.path / path);
        if (!bytes)
            return fail(bytes.error());
        text = std::move(*bytes);
    }
    for (auto& [path, file] : files->media)
        file = request.path / path;
    for (const auto& [path, picture] : files->generated)
        files->media.emplace(path, request.path / path);
    files->generated.clear();
    std::error_code error;
    for (const auto& [path, file] : files->media)
        if (!fs::exists(file, error))
            return fail({file, 0, "is missing. Export the look again."});
    return files;
}

// The look with the shaders of the folder.
Look look_of(const ExportRequest& request, const PortableFiles& files) {
    Look look = request.prepared.document.drawn_look();
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        Pass& pass = look.passes[i];
        const std::string stem = shader_stem(look, i);
        pass.vertex = {request.path / (stem + ".vert"), files.texts.at(stem + ".vert"), {}};
        pass.fragment = {request.path / (stem + ".frag"), files.texts.at(stem + ".frag"), {}};
    }
    return look;
}
}  // namespace

Result<void> check_portable(const ExportRequest& request) {
    const auto described = described_files(request);
    const auto files = read_portable(request);
    if (!described || !files)
        return fail(described ? files.error() : described.error());
    if (files->texts != described->texts)
        return fail({request.path / portable_file, 0, "differs from the look. Export it again."});
    const Look look = look_of(request, *files);
    for (const Pass& pass : look.passes)
        if (const auto good = check_program(pass.vertex, pass.fragment, look.shader_limits); !good)
            return fail(good.error());
    return {};
}

Result<fs::path> page_of_portable(const ExportRequest& request, const fs::path& folder) {
    const auto files = read_portable(request);
    if (!files)
        return fail(files.error());
    return write_page(look_of(request, *files), *files, folder / "page.html")
        .map([](const ExportedLook& page) { return page.path; });
}
