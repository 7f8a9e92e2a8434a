#include "formats/mpv_export/mpv_export.h"

#include "formats/mpv_export/mpv_check.h"
#include "formats/mpv_export/mpv_pass.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
/// Writes the file of one look.
class MpvWriter {
public:
    MpvWriter(const EffectRequest& request, Effect effect)
        : m_request(request),
          m_effect(std::move(effect)),
          m_parameters(m_effect.look, request.values, m_effect.fixed),
          m_textures(m_effect.look) {}

    Result<EffectOutput> write() {
        if (std::string obstacle = m_textures.obstacle(); !obstacle.empty())
            return fail({{}, 0, std::move(obstacle)});
        auto pictures = m_textures.picture_blocks();
        if (!pictures)
            return fail(pictures.error());
        if (auto written = write_blocks(); !written)
            return fail(written.error());
        std::string text = without_mpv_marks(notice_comment(m_request.look, m_request.notices));
        if (m_request.has_live_parameters)
            text += m_parameters.blocks(m_used);
        text += *pictures;
        for (const MpvBlock& block : m_blocks)
            text += mpv_block_text(block);
        if (auto good = check_mpv_shader(text); !good)
            return fail(good.error());
        return EffectOutput{.texts = {{m_request.name + ".glsl", std::move(text)}},
                            .pictures = {},
                            .losses = losses()};
    }

private:
    const Look& look() const { return m_effect.look; }

    Result<void> write_blocks() {
        std::vector<std::vector<MpvBlock>> levels;
        std::size_t count = look().passes.size();
        for (const Pass& pass : look().passes) {
            levels.push_back(m_textures.level_blocks(pass));
            count += levels.back().size();
        }
        const MpvContext context{look(), m_request.look, m_parameters, m_textures, count};
        for (std::size_t i = 0; i < look().passes.size(); ++i) {
            const auto uniforms = effect_uniforms(look(), i, m_request.values, m_effect.fixed);
            if (!uniforms)
                return fail(uniforms.error());
            auto pass = mpv_pass(i, *uniforms, context);
            if (!pass)
                return fail(pass.error());
            if (!m_request.has_live_parameters)
                pass->block.values = m_parameters.defines(pass->parameters);
            m_used.insert(pass->parameters.begin(), pass->parameters.end());
            m_blocks.insert(m_blocks.end(), levels[i].begin(), levels[i].end());
            m_blocks.push_back(std::move(pass->block));
        }
        return {};
    }

    std::vector<std::string> losses() const {
        std::vector<std::string> all = m_effect.losses;
        const std::size_t last = look().passes.size() - 1;
        for (std::size_t i = 0; i < last; ++i) {
            const Pass& pass = look().passes[i];
            const bool is_own = find_pass(m_request.look, pass.name).has_value();
            if (is_own && half_floats_of(pass.format))
                all.push_back(fmt::format(
                    "Half of the bits of the pass '{}', because mpv stores 16 per number.",
                    pass.name));
        }
        return all;
    }

    const EffectRequest& m_request;
    Effect m_effect;
    MpvParameters m_parameters;
    MpvTextures m_textures;
    std::vector<MpvBlock> m_blocks;
    std::set<std::string> m_used;  // parameters
};
}  // namespace

const EffectHost& mpv_host() {
    static const EffectHost host{.name = "mpv",
                                 .rows = RowOrder::top_first,
                                 .has_feedback = false,
                                 .has_integers = false,
                                 .turns_last_pass = true};
    return host;
}

Result<EffectOutput> mpv_files(const EffectRequest& request) {
    auto effect = effect_of(request.look, request.values, request.size, request.source, mpv_host());
    if (!effect)
        return fail(effect.error());
    return MpvWriter(request, std::move(*effect)).write();
}
