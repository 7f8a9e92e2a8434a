#pragma once

#include <string>
#include <string_view>

/// A picture of the site's library and its replacement.
struct ShadertoyAsset {
    std::string name;   // of the parameter
    std::string label;  // shown in panels
    std::string made;   // such as "pattern:noise", as in Image::made
};

/// The picture at a path of the site, identified by the digest in its name. Unknown pictures get a
/// generated name and a default replacement.
ShadertoyAsset shadertoy_asset(std::string_view path);
