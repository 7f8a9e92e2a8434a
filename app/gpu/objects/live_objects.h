#pragma once

#include <map>
#include <string>

namespace gpu {

/// The number of GL objects by kind, in the current context and those that share with it. Vertex
/// arrays and framebuffers of other contexts are not counted. Asks for each name from 1, up to 256
/// names without an object: drivers reuse low names.
std::map<std::string, int> live_objects();

}  // namespace gpu
