#include "lab/export/portable_export.h"

#include "base/file.h"
#include "formats/portable/portable_json.h"
#include "io/files/atomic_file.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
tl::unexpected<Diagnostics> refused(const fs::path& file, const std::error_code& error) {
    return fail({file, 0, fmt::format("can't write: {}", error.message())});
}

// The name of a source file below the folder of its look, otherwise its last part.
std::string notice_name(const fs::path& file, const fs::path& manifest) {
    const fs::path relative = file.lexically_relative(manifest.parent_path());
    const bool is_inside = !relative.empty() && *relative.begin() != "..";
    return (is_inside ? relative : file.filename()).generic_string();
}

bool is_media(const Look& look, const fs::path& file) {
    return std::ranges::any_of(look.images, [&](const Image& image) {
        return image.file == file || std::ranges::find(image.faces, file) != image.faces.end();
    });
}

Result<std::map<std::string, SourceNotice>> notices_of(const Look& look) {
    std::map<std::string, SourceNotice> notices;
    std::error_code error;
    for (const fs::path& file : look.files) {  // also places where an include was searched
        if (is_media(look, file) || !fs::exists(file, error))
            continue;
        const auto text = read_text(file);
        if (!text)
            return fail(text.error());
        notices.emplace(notice_name(file, look.manifest), source_notice(*text));
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

/// A new folder beside the target, removed by the destructor unless it replaced the target.
class NewFolder {
public:
    explicit NewFolder(const fs::path& target)
        : m_target(target.lexically_normal()), m_folder(m_target) {
        if (!m_target.has_filename())  // "out/"
            m_target = m_folder = m_target.parent_path();
        m_folder += ".new";
        fs::remove_all(m_folder, m_ignored);
    }
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder() { fs::remove_all(m_folder, m_ignored); }

    const fs::path& path() const { return m_folder; }

    Result<void> replace_target() {
        std::error_code error;
        fs::path old = m_target;
        old += ".old";
        fs::remove_all(old, m_ignored);
        if (fs::exists(m_target, error))
            fs::rename(m_target, old, error);
        if (error)
            return refused(m_target, error);
        fs::rename(m_folder, m_target, error);
        if (error) {
            fs::rename(old, m_target, m_ignored);
            return refused(m_target, error);
        }
        fs::remove_all(old, m_ignored);
        return {};
    }

private:
    fs::path m_target;
    fs::path m_folder;
    std::error_code m_ignored;
};

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

// Only an earlier export may be replaced.
Result<void> check_target(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error) || fs::exists(path / portable_file, error) ||
        (fs::is_directory(path, error) && fs::is_empty(path, error)))
        return {};
    return fail({path, 0, "exists and is not an exported look. Choose another path."});
}
}  // namespace

Result<ExportedLook> export_portable(const ExportRequest& request) {
    if (auto good = check_target(request.path); !good)
        return fail(good.error());
    const auto files = files_of(request);
    if (!files)
        return fail(files.error());
    NewFolder folder(request.path);
    const auto texts = write_texts(*files, folder.path());
    if (!texts)
        return fail(texts.error());
    const auto media = copy_media(*files, folder.path());
    if (!media)
        return fail(media.error());
    if (auto done = folder.replace_target(); !done)
        return fail(done.error());
    return ExportedLook{request.path, files->texts.size() + files->media.size(), *texts + *media};
}
