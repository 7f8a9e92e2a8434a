#include "lab/source.h"

#include "io/picture_file.h"
#include "signals/patterns.h"

Result<Picture> load_source(const std::string& source) {
    constexpr std::string_view prefix = "pattern:";
    if (source.starts_with(prefix))
        return make_pattern(std::string_view(source).substr(prefix.size()));
    return load_picture(source);
}
