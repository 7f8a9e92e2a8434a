#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// What a program that draws chains of full-screen passes can do.
struct EffectHost {
    std::string_view name;                // "RetroArch"
    RowOrder rows = RowOrder::top_first;  // of its source picture and of its screen
    bool samples_per_texture = false;     // a texture has one filter and one wrap for all readers
    bool has_mipmaps = true;              // of targets
    bool has_feedback = true;             // a pass can read pictures of the previous frame
    int most_frames_ago = 1;              // of such pictures
    bool keeps_previous = true;           // ... also after the pass is drawn again
    bool has_integers = true;             // targets with integer texels
    bool has_images = true;               // picture files of the look
    bool has_mouse = false;
    bool has_date = true;
    bool turns_last_pass = false;  // the writer turns the rows of the last pass
    // The source and the last target are the screen: the first pass copies the source, and no pass
    // reads the last target.
    bool is_on_screen = false;
    bool keeps_constants = false;  // annotated constants of the shaders stay adjustable
};

/// A look reduced to what such programs draw.
struct Effect {
    /// All passes are full-screen draws with sizes relative to the viewport or the source, or in
    /// px. Only the first pass reads the source, which has the host's rows and is display-encoded.
    /// The last pass writes the host's rows, display-encoded. Names of passes are identifiers.
    Look look;
    std::string source_pass;  // the first pass, if it only decodes or flips the source; or ""
    /// Parameters whose values cannot change.
    std::vector<std::string> fixed;
    std::vector<std::string> losses;  // a sentence per item
};

/// The reduced look for a render size and a source size. The error is the reason why the host can't
/// draw it, with an alternative.
Result<Effect> effect_of(const Look& look, const Values& values, Extent size, Extent source,
                         const EffectHost& host);
