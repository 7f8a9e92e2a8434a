#pragma once

#include <string>
#include <string_view>

/// A picture that the site offers to shaders, and what stands for it here.
struct ToyAsset {
    std::string name;   // of the parameter
    std::string label;  // what a panel shows
    std::string made;   // "pattern:noise": as Image::made
};

/// The picture at a path of the site, told by the digest in its name; a name and a stand-in of our
/// own where it is none of the known ones.
ToyAsset toy_asset(std::string_view path);
