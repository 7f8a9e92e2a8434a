#pragma once

#include "portable_player/textures.h"
#include "portable_player/values.h"

#include <vector>

/// The target of a pass and its previous pictures.
struct Target {
    Size size{1, 1};
    std::size_t host = 0;  // the pass whose target it draws onto; itself for its own
    std::vector<Canvas> slots;
    std::size_t newest = 0;

    const Canvas& canvas(int frames_ago = 0) const {
        return slots[(newest + slots.size() - static_cast<std::size_t>(frames_ago)) % slots.size()];
    }
    void advance() { newest = (newest + 1) % slots.size(); }
    bool has_previous() const { return slots.size() > 1; }
};

/// How many frames ago the input of a pass was drawn. A pass that is not drawn before it in the
/// frame is read as of the previous frame.
int frames_ago(const Description& description, std::size_t reader, const Input& input);

/// The size of what a look reads as the source.
Size source_size(const Description& description, const Pass& pass,
                 const std::vector<Target>& targets, const Size& source);

/// The targets of all passes. `view`: render size; `source`: size of the source.
std::vector<Target> make_targets(const Description& description, const Values& values,
                                 const Size& view, const Size& source);

/// The passes in drawing order. A pass that draws onto another follows it.
std::vector<std::size_t> drawing_order(const std::vector<Target>& targets);

/// Whether passes draw onto the target of this pass, or onto one that it reads.
bool is_drawn_onto(const Description& description, const std::vector<Target>& targets,
                   std::size_t pass);
