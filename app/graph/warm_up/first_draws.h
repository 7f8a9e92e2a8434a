#pragma once

#include "base/pass_progress.h"
#include "graph/executor/executor.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Pictures of a look by name, from image_texture().
using ImageTextures = std::map<std::string, std::shared_ptr<const gpu::Texture>>;

/// The assumed size of the source before it is known, px.
inline constexpr Extent expected_source{320, 240};

/// The input of FirstDraws.
struct FirstDrawsInput {
    const Look& look;
    const Programs& programs;
    const Programs* known = nullptr;  // may be in use and are not changed; null: none
    const ImageTextures& images;
    Extent viewport;  // of the future picture
    // The size to draw if a quarter of the picture is not suitable. small: a few pixels, if the
    // draw must not block. whole: the full size. own: always the full size, because the executor
    // continues with the real frames.
    enum class Size { small, whole, own };
    Size size = Size::small;
    Values values = {};           // that sizes depend on
    std::vector<bool> seen = {};  // as in Executor::set_displayed
};

/// The programs that are not in `known`; null: all.
std::vector<PassProgram> new_programs(const Programs& programs, const Programs* known);
inline bool has_new(const Programs& programs, const Programs* known) {
    return !new_programs(programs, known).empty();
}

/// Draws once with each new program, one at a time, into targets of the look's formats. Drivers
/// compile a program when it is first drawn with, for the current state, and some compile it again
/// in each context. These draws do it in advance and in slices, so that no visible frame waits.
/// Belongs to the context that it was created in.
class FirstDraws {
public:
    /// `idle` replaces the known programs. It draws nothing, and may be empty if none are known.
    /// Without memory nothing is drawn.
    FirstDraws(const FirstDrawsInput& of, const PassProgram& idle);

    std::size_t total() const { return m_new.size(); }
    std::size_t done() const { return m_done; }
    bool is_done() const { return m_done >= m_new.size(); }
    /// The next pass.
    const std::string& next_pass() const;
    /// Draws a band of the next pass and waits for it.
    void draw_next();
    /// Draws all passes unless cancelled.
    void draw_all(PassProgress& progress);
    /// The executor of the draws, reset to before the first frame. Null without memory.
    std::unique_ptr<Executor> take_executor();

private:
    bool make_ready(const FirstDrawsInput& of);

    std::unique_ptr<Executor> m_executor;
    std::vector<std::size_t> m_new;  // passes
    std::size_t m_done = 0;
};

/// A program that draws nothing.
Result<PassProgram> idle_program();
