#include "lab/views/file_thumbnail.h"

#include "gpu/objects/texels.h"

void FileThumbnail::update(const std::filesystem::path& file) {
    if (file != m_file) {
        m_file = file;
        m_texture.reset();
        m_lines.clear();
        m_work.cancel();
        if (has_preview(file))
            m_work.start(
                [file](JobProgress&) -> Result<FilePreview> { return load_preview(file); });
    }
    const bool was_pending = is_pending();
    m_work.update();
    if (!was_pending || is_pending() || !m_work.outcome())
        return;
    const FilePreview& preview = **m_work.outcome();
    m_lines = preview.lines;
    if (!preview.picture)
        return;
    if (auto made = gpu::texture_of(*preview.picture, Format::rgba8, Encoding::display))
        m_texture.emplace(std::move(*made));
}
