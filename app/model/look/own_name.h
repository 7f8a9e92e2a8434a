#pragma once

#include <string>

/// What a pass of a stack is called within its look: "mask" of "crt/mask". Others are called so
/// anyway.
inline std::string own_name(const std::string& pass) {
    return pass.substr(pass.find('/') + 1);
}
