#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A look.json with another list of passes; all other bytes are unchanged.
struct PassEdit {
    std::string text;
    std::vector<std::string> rewired = {};         // passes with other inputs than before
    std::vector<std::string> unused_shaders = {};  // files that only the removed pass named
};

/// A pass to add. It reads the pass `after` as `image`, and later passes read it instead.
struct NewPass {
    std::string name;
    std::string fragment;  // file name
    std::string after;
};

enum class PassMove { earlier, later };

/// Inserts a pass. It gets the size and format of the pass that it follows. Fails if that pass
/// cannot be read as a picture: its format has integers, or it is drawn onto another pass.
Result<PassEdit> with_pass_added(std::string_view text, const NewPass& pass,
                                 const std::filesystem::path& file);

/// Removes a pass. Its readers read its first input instead, as if it were bypassed. Fails for the
/// only pass, and for a pass without inputs that others read.
Result<PassEdit> with_pass_removed(std::string_view text, std::string_view pass,
                                   const std::filesystem::path& file);

/// Exchanges a pass with its neighbour. If the later one reads the earlier one, they also exchange
/// their inputs and readers, so that the chain stays whole. Fails at the ends of the list, and if
/// the earlier one has no input to exchange.
Result<PassEdit> with_pass_moved(std::string_view text, std::string_view pass, PassMove move,
                                 const std::filesystem::path& file);

/// The text of a look.json with another name and without a description.
Result<std::string> with_look_named(std::string_view text, std::string_view name,
                                    const std::filesystem::path& file);
