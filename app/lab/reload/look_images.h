#pragma once

#include "graph/warm_up/first_draws.h"

#include <filesystem>
#include <map>
#include <memory>

/// Textures of the images that looks name. Unchanged files keep their texture.
class LookImages {
public:
    /// All images of the look; an error names each that cannot be read. Needs a current context.
    Result<ImageTextures> load(const Look& look, Diagnostics& warnings);
    void clear() { m_read.clear(); }

private:
    struct ReadImage {
        std::filesystem::file_time_type time;
        Image image;
        Encoding source_encoding;
        bool is_mipmapped;
        std::shared_ptr<const gpu::Texture> texture;

        bool serves(const ReadImage& other) const {
            return time == other.time && image == other.image &&
                   source_encoding == other.source_encoding && is_mipmapped == other.is_mipmapped;
        }
    };

    std::map<std::filesystem::path, ReadImage> m_read;  // by file, of the last look
};
