#include "model/look/shader_limits.h"

#include <doctest/doctest.h>

TEST_CASE("a shader limit is set by name, and must be a whole number in range") {
    ShaderLimits limits;
    CHECK(set_limit(limits, "uniforms=2048").has_value());
    CHECK(limits.uniforms == 2048.0);
    for (const char* wrong : {"uniform=1", "uniforms", "uniforms=", "uniforms=0", "uniforms=-1",
                              "uniforms=1.5", "uniforms=1e13", "uniforms=x", "=1", ""})
        CHECK_FALSE(set_limit(limits, wrong).has_value());
    CHECK(set_limit(limits, "uniform=1").error().front().message.find("switch-cases") !=
          std::string::npos);
}
