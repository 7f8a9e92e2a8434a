#pragma once

#include "base/pass_progress.h"
#include "graph/executor/executor.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Pictures of a look by name, as image_texture() makes them.
using ImageTextures = std::map<std::string, std::shared_ptr<const gpu::Texture>>;

/// How large a source is taken to be before there is one, px.
inline constexpr Extent expected_source{320, 240};

/// What the first draws are made with.
struct FirstDrawsOf {
    const Look& look;
    const Programs& programs;
    const Programs* known = nullptr;  // may be in use, and are not touched; null: none
    const ImageTextures& images;
    Extent viewport;  // of the picture to come
    // What is drawn where no quarter of the picture will do. Small: a few pixels, where nobody may
    // wait for more; whole: all of it. Own: all of it in any case, as who draws the picture goes on
    // with what the draws were made with.
    enum class Size { small, whole, own };
    Size size = Size::small;
    Values values = {};           // that the sizes follow
    std::vector<bool> seen = {};  // as Executor::set_seen takes it
};

/// Those of the programs that are none of `known`; null: there are none.
std::vector<PassProgram> new_of(const Programs& programs, const Programs* known);
inline bool has_new(const Programs& programs, const Programs* known) {
    return !new_of(programs, known).empty();
}

/// Draws once with each program that is new, one at a time, into targets of the look's formats. A
/// driver makes a program's code when it is first drawn with, for the states that it meets there,
/// and some make it anew in each context; done before, in slices, no picture waits for it. Belongs
/// to the context that it was made in.
class FirstDraws {
public:
    /// `idle` stands in for the known programs; it draws nothing, and need not be where there are
    /// none. Where there is no memory there is nothing to be drawn.
    FirstDraws(const FirstDrawsOf& of, const PassProgram& idle);

    std::size_t total() const { return m_new.size(); }
    std::size_t done() const { return m_done; }
    bool is_done() const { return m_done >= m_new.size(); }
    /// The pass that comes next.
    const std::string& next_pass() const;
    /// Draws a band of the next one and waits for it.
    void draw_next();
    /// Draws them all, unless they are cancelled.
    void draw_all(PassProgress& progress);
    /// What the draws were made with, as before a first frame. Null where there was no memory.
    std::unique_ptr<Executor> take_executor();

private:
    bool make_ready(const FirstDrawsOf& of);

    std::unique_ptr<Executor> m_executor;
    std::vector<std::size_t> m_new;  // passes
    std::size_t m_done = 0;
};

/// A program that draws nothing.
Result<PassProgram> idle_program();
