#pragma once

#include "model/look/built_in.h"
#include "model/look/parameter.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A texture read by shaders of a chain.
struct SlangPicture {
    enum class Of { original, source, output, feedback, image };

    Of of = Of::original;
    int number = 0;  // original: frames ago; output, feedback: pass; image: texture

    bool operator==(const SlangPicture&) const = default;
};

/// The names of textures in one chain: "Source", "PassOutput2", a pass's alias, a texture's id.
/// Names of the chain take precedence over those of the format.
class SlangNames {
public:
    /// `aliases` has one name per pass, "" for none.
    SlangNames(std::vector<std::string> aliases, std::vector<std::string> images);

    std::optional<SlangPicture> find(std::string_view sampler) const;
    /// The texture of a size member: "SourceSize", "PassOutputSize2", "AliasSize".
    std::optional<SlangPicture> find_size(std::string_view member) const;

private:
    std::optional<SlangPicture> find_own(std::string_view name) const;

    std::vector<std::string> m_aliases;
    std::vector<std::string> m_images;
};

/// A block member with the same meaning in each chain.
struct SlangMember {
    std::string_view name;
    NumberType type;
    std::optional<BuiltIn> kind;  // nullopt: the constant `number`
    double number = 0.0;
};

/// "FrameCount", "MVP" and so on; null for other names.
const SlangMember* find_slang_member(std::string_view name);
