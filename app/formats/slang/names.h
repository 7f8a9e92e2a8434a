#pragma once

#include "model/look/built_in.h"
#include "model/look/parameter.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A texture that shaders of a chain read.
struct SlangPicture {
    enum class Of { original, source, output, feedback, image };

    Of of = Of::original;
    int number = 0;  // original: frames ago; output, feedback: of the pass; image: of the texture

    bool operator==(const SlangPicture&) const = default;
};

/// The names that mean a texture in one chain: "Source", "PassOutput2", a pass's alias, a
/// texture's id. Those that the chain gives win over those of the format.
class SlangNames {
public:
    /// `aliases` has one name a pass, "" where it has none.
    SlangNames(std::vector<std::string> aliases, std::vector<std::string> images);

    std::optional<SlangPicture> find(std::string_view sampler) const;
    /// What a member that tells a size is about: "SourceSize", "PassOutputSize2", "AliasSize".
    std::optional<SlangPicture> find_size(std::string_view member) const;

private:
    std::optional<SlangPicture> find_own(std::string_view name) const;

    std::vector<std::string> m_aliases;
    std::vector<std::string> m_images;
};

/// A member of a block that says the same in every chain.
struct SlangMember {
    std::string_view name;
    NumberType type;
    std::optional<BuiltIn> says;  // none: always `number`
    double number = 0.0;
};

/// "FrameCount", "MVP" and so on; null for all others.
const SlangMember* find_slang_member(std::string_view name);
