#pragma once

#include "lab/files/file_preview.h"
#include "lab/storage/background_work.h"
#include "lab/views/view_image.h"

/// The preview of the selected file, read in the background.
class FileThumbnail {
public:
    /// Call it in every update. "": no file is selected.
    void update(const std::filesystem::path& file);

    /// Row 0 at the bottom; a handle of 0: no picture, or not read yet.
    ViewImage image() const { return image_of(m_texture ? &*m_texture : nullptr); }
    const std::vector<std::string>& lines() const { return m_lines; }
    bool is_pending() const { return m_work.is_running(); }

private:
    std::filesystem::path m_file;
    BackgroundWork<FilePreview> m_work;
    std::optional<gpu::Texture> m_texture;
    std::vector<std::string> m_lines;
};
