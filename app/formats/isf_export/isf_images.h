#pragma once

#include "formats/effect/effect_look.h"

#include <string>
#include <string_view>
#include <vector>

/// The pictures that the passes of an ISF file read, as functions. ISF has no samplers that can be
/// passed on, no wrap, no filter and no mip levels. So a sampler becomes a number, and mip levels
/// become passes, each half the size of the one before. The source is decoded where it is read.
class IsfImages {
public:
    explicit IsfImages(const Effect& effect);

    /// A pass that draws a target: a pass of the look, or the mip level `level` of its picture.
    struct Target {
        std::size_t pass = 0;
        int level = 0;
        std::string name;  // of the target; "" for the last pass, if nothing reads it
    };
    const std::vector<Target>& targets() const { return m_targets; }

    /// Whether a side of a pass has the length of the source. ISF can't name that length, so the
    /// picture is at the bottom left of a larger target.
    bool has_source_size(const std::string& pass) const;
    /// The number for a sampler of a pass.
    std::size_t number_of(const Input& input) const;
    /// The size of a pass's picture as GLSL, for its readers; of the source for "".
    std::string size_of(const std::string& pass, int level = 0) const;
    /// The size of what a pass draws as GLSL, while it is drawn.
    std::string drawn_size(const std::string& pass, int level = 0) const;
    /// Functions that read pictures: image_at(), image_lod(), image_fetch(), image_gather(),
    /// image_size().
    std::string functions() const;
    /// The GLSL that draws a mip level, with the result in `vec4`.
    std::string level_text(const Target& target) const;
    /// Why ISF can't read a picture of the look; "" if it can.
    std::string obstacle() const;

private:
    struct Image {
        Input input;  // without its uniform
        int levels = 0;
    };

    void add_levels();
    std::string target_name(const std::string& pass, int level) const;
    bool has_target(std::size_t pass) const;
    std::size_t sampler_count() const;
    std::string source_reader() const;
    std::string limited_size(const std::string& pass, int level, const std::string& whole) const;
    std::string reader(const Image& image, int level) const;
    std::string readers() const;
    std::string read(const Image& image, std::size_t number) const;

    const Look& m_look;
    std::string m_source_pass;  // not drawn
    std::vector<Image> m_images;
    std::vector<int> m_levels;  // of each pass
    std::vector<Target> m_targets;
};
