#include "lab/export/portable_export.h"

#include "base/file.h"
#include "formats/portable/portable_json.h"
#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace fs = std::filesystem;

namespace {
// The name of a source file: at most the last three parts of its path from the first look.
std::string notice_name(const fs::path& file, const Stack& stack) {
    constexpr std::ptrdiff_t most_parts = 3;
    std::vector<fs::path> parts;
    for (const fs::path& part : file.lexically_proximate(stack.front().path))
        if (part != ".." && part != "/")
            parts.push_back(part);
    fs::path name;
    for (auto part = parts.end() - std::min(most_parts, std::ssize(parts)); part != parts.end();
         ++part)
        name /= *part;
    return name.generic_string();
}

// Pictures have no comments.
Result<SourceNotices> notices_of(const Look& look) {
    SourceNotices notices;
    std::error_code error;
    for (const fs::path& file : look.files) {  // also places where an include was searched
        if (!fs::exists(file, error))
            continue;
        const auto bytes = read_bytes(file);
        if (!bytes)
            return fail(bytes.error());
        if (bytes->find('\0') == std::string::npos)
            notices.emplace_back(notice_name(file, look.stack), source_notice(*bytes));
    }
    return notices;
}

Result<PortableFiles> files_of(const ExportRequest& request) {
    const Document& document = request.prepared.document;
    const Look look = document.drawn_look();
    auto notices = notices_of(look);
    if (!notices)
        return fail(notices.error());
    Spec signal;
    if (look.driven_by == Driver::signal) {
        auto complete = completed(document.state().signal);
        if (!complete)
            return fail(complete.error());
        signal = std::move(*complete);
    }
    const std::string source =
        look.driven_by == Driver::picture ? document.state().source : std::string();
    return portable_files({.look = look,
                           .values = document.values(),
                           .modulations = document.state().modulations,
                           .signal = std::move(signal),
                           .source = source,
                           .size = request.size},
                          *notices);
}

Result<std::uintmax_t> write_texts(const PortableFiles& files, const fs::path& folder) {
    std::uintmax_t bytes = 0;
    for (const auto& [path, text] : files.texts) {
        if (auto written = write_atomically(folder / path, text); !written)
            return fail(written.error());
        bytes += text.size();
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
    const auto files = files_of(request);
    if (!files)
        return fail(files.error());
    auto folder = AtomicFolder::create(request.path);
    if (!folder)
        return fail(folder.error());
    const auto texts = write_texts(*files, folder->path());
    if (!texts)
        return fail(texts.error());
    const auto media = copy_media(*files, folder->path());
    if (!media)
        return fail(media.error());
    if (auto done = folder->finish(); !done)
        return fail(done.error());
    return ExportedLook{request.path, files->texts.size() + files->media.size(), *texts + *media};
}
