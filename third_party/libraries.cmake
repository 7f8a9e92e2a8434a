# Finds what Afterglow is built on. Every library is a package of the system; see README.md.
# Each find is turned into one target of ours, so that a layer names it in LINKS and nothing else.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(glslang REQUIRED)
# Its CMake file insists on tools and a Python module that nobody needs here.
pkg_check_modules(openimageio REQUIRED IMPORTED_TARGET OpenImageIO)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tl-expected REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(sndfile REQUIRED IMPORTED_TARGET sndfile)
pkg_check_modules(rtaudio REQUIRED IMPORTED_TARGET rtaudio)
pkg_check_modules(kissfft REQUIRED kissfft-float)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)

# An external_NAME stands for the libraries behind it; imported targets' headers count as SYSTEM.
function(add_external name)
    add_library(external_${name} INTERFACE)
    target_link_libraries(external_${name} INTERFACE ${ARGN})
endfunction()

add_external(threads Threads::Threads)
add_external(expected tl::expected)
add_external(fmt fmt::fmt)
add_external(glm glm::glm)
add_external(glfw glfw)
add_external(epoxy PkgConfig::epoxy)
add_external(imgui PkgConfig::imgui glfw)
add_external(glslang glslang::glslang glslang::glslang-default-resource-limits glslang::SPIRV)
add_external(openimageio PkgConfig::openimageio)
add_external(json nlohmann_json::nlohmann_json)
add_external(cli11 CLI11::CLI11)
add_external(sndfile PkgConfig::sndfile)
add_external(rtaudio PkgConfig::rtaudio)
add_external(kissfft ${kissfft_LINK_LIBRARIES})  # its headers take `float` without being told
add_external(stb PkgConfig::stb)
add_external(zlib ZLIB::ZLIB)
