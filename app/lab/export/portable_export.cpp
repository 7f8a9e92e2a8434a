#include "lab/export/portable_export.h"

#include "base/file.h"
#include "glsl/compile/check.h"
#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "io/files/scratch_folder.h"
#include "io/files/zip.h"
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
            name != portable_file && name != shader_folder && name != copies_folder &&
            name != stages_folder)
            return fail({entry.path(), 0,
                         "is not part of an exported look. Move it, or choose another path."});
    return {};
}
}  // namespace

namespace {
bool is_zip(const fs::path& path) {
    return path.extension() == ".zip";
}

Result<ExportedLook> export_folder(const ExportRequest& request) {
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

// An earlier archive is replaced.
Result<ExportedLook> export_zip(const ExportRequest& request) {
    const auto scratch = ScratchFolder::create();
    if (!scratch)
        return fail(scratch.error());
    ExportRequest unpacked = request;
    unpacked.path = scratch->path() / "look";
    auto made = export_folder(unpacked);
    if (!made)
        return made;
    const fs::path archive = scratch->path() / "look.zip";
    if (auto zipped = zip_folder(unpacked.path, archive); !zipped)
        return fail(zipped.error());
    if (auto saved = copy_atomically(archive, request.path); !saved)
        return fail(saved.error());
    std::error_code error;
    return ExportedLook{request.path, made->files, fs::file_size(request.path, error)};
}

// Where the files are: the folder, or the contents of an archive in `scratch`.
Result<ExportRequest> unpacked(const ExportRequest& request, const fs::path& scratch) {
    if (!is_zip(request.path))
        return request;
    ExportRequest folder = request;
    folder.path = scratch / "look";
    if (auto extracted = unzip(request.path, folder.path); !extracted)
        return fail(extracted.error());
    return folder;
}
}  // namespace

Result<ExportedLook> export_portable(const ExportRequest& request) {
    return is_zip(request.path) ? export_zip(request) : export_folder(request);
}

Result<std::vector<std::string>> portable_losses(const PreparedLook& prepared) {
    const Document& document = prepared.document;
    std::vector<std::string> losses;
    const auto source = parse_source(document.state().source);
    if (document.look().driven_by == Driver::picture && source && source->is_pattern() &&
        is_moving_pattern(source->picture.substr(std::string_view("pattern:").size())))
        losses.emplace_back("The moving test picture becomes a still picture.");
    return losses;
}

namespace {
// The files that a folder has instead of those that were described.
Result<PortableFiles> read_portable(const ExportRequest& request, PortableFiles files) {
    for (auto& [path, text] : files.texts) {
        auto bytes = read_bytes(request.path / path);
        if (!bytes)
            return fail(bytes.error());
        text = std::move(*bytes);
    }
    for (auto& [path, file] : files.media)
        file = request.path / path;
    for (const auto& [path, picture] : files.generated)
        files.media.emplace(path, request.path / path);
    files.generated.clear();
    std::error_code error;
    for (const auto& [path, file] : files.media)
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

namespace {
Result<void> check_folder(const ExportRequest& request) {
    const auto described = described_files(request);
    if (!described)
        return fail(described.error());
    const auto files = read_portable(request, *described);
    if (!files)
        return fail(files.error());
    if (files->texts != described->texts)
        return fail({request.path / portable_file, 0, "differs from the look. Export it again."});
    const Look look = look_of(request, *files);
    for (const Pass& pass : look.passes)
        if (const auto good = check_program(pass.vertex, pass.fragment, look.shader_limits); !good)
            return fail(good.error());
    return {};
}
}  // namespace

Result<void> check_portable(const ExportRequest& request) {
    const auto scratch = ScratchFolder::create();
    if (!scratch)
        return fail(scratch.error());
    const auto folder = unpacked(request, scratch->path());
    return folder ? check_folder(*folder) : fail(folder.error());
}

Result<fs::path> page_of_portable(const ExportRequest& request, const fs::path& folder) {
    const auto read = unpacked(request, folder);
    if (!read)
        return fail(read.error());
    const auto described = described_files(*read);
    if (!described)
        return fail(described.error());
    const auto files = read_portable(*read, *described);
    if (!files)
        return fail(files.error());
    const auto page = write_page(look_of(*read, *files), *files, folder / "page.html");
    return page ? Result<fs::path>(page->path) : fail(page.error());
}
