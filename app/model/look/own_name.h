#pragma once

#include <string>

/// The name of a stack's pass within its look: "mask" of "crt/mask". Other names are unchanged.
inline std::string own_name(const std::string& pass) {
    return pass.substr(pass.find('/') + 1);
}
