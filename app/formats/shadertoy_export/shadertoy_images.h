#pragma once

#include "formats/glsl/modern_glsl.h"
#include "formats/shadertoy_export/shadertoy_plan.h"

#include <set>
#include <string>
#include <vector>

/// A channel of a pass and what it reads.
struct ShadertoyConnection {
    int buffer = -1;  // below 0: the picture
    Sampler sampler;  // of the channel

    bool operator==(const ShadertoyConnection&) const = default;
};

/// What one pass of a Shadertoy shader reads, as functions. Buffers have no size of their own, and
/// the picture is not linear light, so a sampler becomes a number: texture() becomes image_at().
class ShadertoyImages {
public:
    ShadertoyImages(const ShadertoyPlan& plan, std::size_t pass);

    /// The number for a sampler of the pass.
    std::size_t number_of(const Input& input) const;
    /// The size of a pass's picture as GLSL; of the picture that the user connects for "".
    std::string size_of(const std::string& pass);
    /// Functions that read each picture.
    std::string readers();
    /// Functions that a text of a pass needs, for the pictures of that pass: image_at() and so on.
    /// `words`: of the text. `has_bias`: it adds numbers to the mip levels that texture() reads.
    std::string functions(const Pass& pass, const GlslWords& words, bool has_bias);
    /// The passes that are drawn where this pass reads them, in order.
    const std::vector<std::string>& inlined() const { return m_inlined; }
    /// The channel of Buffer A.
    int table_channel() { return channel_of({.buffer = 0, .sampler = {}}); }
    /// The connected channels, in order.
    const std::vector<ShadertoyConnection>& channels() const { return m_channels; }
    /// Why the pass can't have its channels; "" if it can.
    std::string obstacle() const;

private:
    struct Image {
        Input input;
        int channel = 0;
    };

    void add_inputs(const Pass& pass);
    bool is_inlined(const Input& input) const;
    int channel_of(const ShadertoyConnection& wanted);
    int picture_channel();
    ShadertoyConnection channel_for(const Input& input) const;
    bool is_tapped(const Input& input) const;
    bool has_own_levels(const Input& input) const;
    std::string size_of(const Input& input);
    std::string size_functions() const;
    std::string reader(const Image& image, std::size_t number);
    std::string tapping_reader(const Image& image, std::size_t number);
    std::string plain_read(const Image& image, const std::string& size) const;
    std::string at_line(const Image& image, std::size_t number);
    std::string biased_line(const Image& image, std::size_t number);
    std::string lod_line(const Image& image, std::size_t number) const;

    const ShadertoyPlan& m_plan;
    const Pass& m_pass;
    std::vector<Image> m_images;
    std::vector<ShadertoyConnection> m_channels;
    std::vector<std::string> m_inlined;
    std::set<std::string> m_sized;  // passes whose size is a function
};

/// The code of Buffer A for a plan with mip levels. Its channel 0 is the picture.
std::string shadertoy_levels_code();
