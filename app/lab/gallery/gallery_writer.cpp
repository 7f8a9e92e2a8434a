#include "lab/gallery/gallery_writer.h"

#include "base/text.h"
#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "io/files/scratch_folder.h"
#include "io/pictures/picture_file.h"
#include "lab/document/sharing.h"
#include "lab/export/export_target.h"
#include "lab/gallery/gallery_contents.h"
#include "lab/gallery/gallery_folder.h"
#include "lab/golden/golden_name.h"
#include "lab/offline/preset_thumbnail_renderer.h"
#include "lab/storage/media.h"

#include <fmt/format.h>

#include <set>

namespace fs = std::filesystem;

namespace {
constexpr int thumbnail_lines = 270;
constexpr Extent page_size{1280, 720};

/// Fills the folder of a gallery.
class GalleryWriter {
public:
    GalleryWriter(const GalleryRequest& request, const Library& library, fs::path folder,
                  fs::path scratch)
        : m_request(request),
          m_library(library),
          m_folder(std::move(folder)),
          m_scratch(std::move(scratch)) {}

    /// `next` is called after each card.
    Result<void> add(const GalleryGroup& group, const std::function<void()>& next);
    Result<WrittenGallery> finish();

private:
    Result<GalleryCard> write_card(const GalleryItem& item, PresetThumbnailRenderer& renderer);
    Result<void> write_thumbnail(const GalleryItem& item, GalleryCard& card,
                                 PresetThumbnailRenderer& renderer) const;
    Result<void> write_live_page(const GalleryItem& item, GalleryCard& card);
    std::string unique_anchor(const std::string& id);

    const GalleryRequest& m_request;
    const Library& m_library;
    fs::path m_folder;
    fs::path m_scratch;
    std::set<std::string> m_anchors;
    WrittenGallery m_written;
};

tl::unexpected<Diagnostics> failed(const GalleryItem& item, Diagnostics reasons) {
    for (Diagnostic& reason : reasons)
        if (reason.file.empty())
            reason.file = item.file.empty() ? item.prepared.document.look().manifest : item.file;
    return fail(std::move(reasons));
}

Result<void> GalleryWriter::write_thumbnail(const GalleryItem& item, GalleryCard& card,
                                            PresetThumbnailRenderer& renderer) const {
    fs::path preset = item.file;
    if (!item.line.empty()) {
        preset = m_scratch / (item.stem + ".txt");
        if (auto written = write_atomically(preset, item.line); !written)
            return written;
    }
    const auto picture = renderer.paint(preset, JobProgress());
    if (!picture)
        return failed(item, picture.error());
    card.thumbnail = fmt::format("{}/{}.png", gallery_thumbnails, item.stem);
    return save_picture(*picture, m_folder / card.thumbnail);
}

// A look that a page can't draw is not an error. A file that can't be written is an error.
Result<void> GalleryWriter::write_live_page(const GalleryItem& item, GalleryCard& card) {
    const auto web = find_export_target("web");
    if (!web)
        return fail(web.error());
    const std::string path = fmt::format("{}/{}.html", gallery_pages, item.stem);
    const auto made = export_look(**web, {item.prepared, page_size, m_folder / path});
    if (made) {
        card.page = path;
        return {};
    }
    const Diagnostic& reason = made.error().front();
    if (reason.file.string().starts_with(m_folder.string()))
        return fail(made.error());
    card.why_no_page = (reason.file.empty() ? "" : reason.file.filename().string() + ": ") +
                       reason.message.substr(0, reason.message.find('\n'));
    const fs::path source = item.file.empty() ? item.prepared.document.look().manifest : item.file;
    add_new(m_written.warnings,
            {source, 0, "has no live page: " + card.why_no_page, Severity::warning});
    return {};
}

Result<GalleryCard> GalleryWriter::write_card(const GalleryItem& item,
                                              PresetThumbnailRenderer& renderer) {
    const Document& document = item.prepared.document;
    add_new(m_written.warnings, item.prepared.warnings);
    GalleryCard card = gallery_card(document);
    card.name = item.name;
    if (item.file.empty() && item.line.empty())
        card.about = "All parameters at their defaults.";
    card.share_line = share_line_of(document, RecentMedia(m_library.roots()));
    if (auto written = write_thumbnail(item, card, renderer); !written)
        return fail(written.error());
    if (m_request.has_pages)
        if (auto written = write_live_page(item, card); !written)
            return fail(written.error());
    return card;
}

std::string GalleryWriter::unique_anchor(const std::string& id) {
    const std::string name = golden_name(id, {});
    std::string anchor = name;
    for (int number = 2; !m_anchors.insert(anchor).second; ++number)
        anchor = fmt::format("{}-{}", name, number);
    return anchor;
}

Result<void> GalleryWriter::add(const GalleryGroup& group, const std::function<void()>& next) {
    const Look& look = group.look;
    GallerySection section{.id = look.id,
                           .anchor = unique_anchor(look.id),
                           .name = look.name.empty() ? look.id : look.name,
                           .about = look.about,
                           .author = look.author,
                           .license = look.license,
                           .cards = {}};
    PresetThumbnailRenderer renderer(look, m_library, std::nullopt, Pace::full);
    renderer.set_lines(thumbnail_lines);
    for (const GalleryItem& item : group.items) {
        auto card = write_card(item, renderer);
        if (!card)
            return fail(card.error());
        section.cards.push_back(std::move(*card));
        next();
    }
    m_written.sections.push_back(std::move(section));
    return {};
}

Result<WrittenGallery> GalleryWriter::finish() {
    if (auto written = write_atomically(m_folder / gallery_index, gallery_page(m_written.sections));
        !written)
        return fail(written.error());
    std::error_code error;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(m_folder, error)) {
        if (!entry.is_regular_file(error))
            continue;
        ++m_written.files;
        m_written.bytes += entry.file_size(error);
    }
    return std::move(m_written);
}
}  // namespace

Result<WrittenGallery> write_gallery(const GalleryRequest& request, const Library& library,
                                     const GalleryProgress& progress) {
    if (auto good = check_gallery_folder(request.folder); !good)
        return fail(good.error());
    Diagnostics problems;
    const auto groups = gallery_contents(request.looks, library, problems);
    if (!groups)
        return fail(groups.error());
    auto folder = AtomicFolder::create(request.folder);
    const auto scratch = ScratchFolder::create();
    if (!folder || !scratch)
        return fail(folder ? scratch.error() : folder.error());
    int all = 0;
    for (const GalleryGroup& group : *groups)
        all += static_cast<int>(group.items.size());
    int done = 0;
    GalleryWriter writer(request, library, folder->path(), scratch->path());
    for (const GalleryGroup& group : *groups)
        if (auto added = writer.add(group, [&] { progress(++done, all); }); !added)
            return fail(added.error());
    auto written = writer.finish();
    if (!written)
        return written;
    // The user may have added files meanwhile.
    if (auto good = check_gallery_folder(request.folder); !good)
        return fail(good.error());
    if (auto finished = folder->finish(); !finished)
        return fail(finished.error());
    written->warnings.insert(written->warnings.begin(), problems.begin(), problems.end());
    return written;
}
