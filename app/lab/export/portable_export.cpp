#include "lab/export/portable_export.h"

#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "lab/export/described_look.h"

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
