#include "pictures/svg_paths.h"

#include "io/system/bounded_child.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cairo-svg.h>
#include <charconv>
#include <cmath>
#include <librsvg/rsvg.h>
#include <memory>
#include <optional>

namespace fs = std::filesystem;

namespace {
// Units of the page's longer side, tried in this order. Cairo has a resolution of 1/256 unit and a
// limit of 2^23. Letters are limited to 65535 units, which large ones exceed with the first value.
constexpr std::array page_units{32768.0, 1024.0};
// Cairo drops fills without area only if they are horizontal or vertical. A beam draws them.
constexpr double page_rotation = 0.5;  // radians

// Hides everything that would become pixels. Opacity stays: elements with opacity 0 are not drawn.
constexpr std::string_view plain_style =
    "*{filter:none !important;mask:none !important;mix-blend-mode:normal !important;"
    "isolation:auto !important} image{display:none !important}";

template <auto Free>
struct Freed {
    template <class T>
    void operator()(T* owned) const {
        Free(owned);
    }
};
using Handle = std::unique_ptr<RsvgHandle, Freed<g_object_unref>>;
using File = std::unique_ptr<GFile, Freed<g_object_unref>>;
using Stream = std::unique_ptr<GInputStream, Freed<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Freed<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Freed<cairo_destroy>>;

/// The rectangle to draw, in units of the viewBox, otherwise in CSS px.
struct Page {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
};

// "E3 a message": the line (0 if unknown) and the message.
std::string failure(int line, std::string_view message) {
    return fmt::format("E{} {}", line, message);
}

int number_at(std::string_view text) {
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

// libxml2 writes "... on line 4 column 7 of data: REASON", and its SAX reader "... in (null):4:7:
// REASON".
std::string failure(const GError* error) {
    std::string_view message = error ? error->message : "no reason given";
    message = message.substr(0, message.find_last_not_of(" \n") + 1);
    for (const std::string_view mark : {" on line ", " in (null):"}) {
        const std::size_t offset = message.find(mark);
        if (offset == std::string_view::npos)
            continue;
        const std::string_view behind = message.substr(offset + mark.size());
        const std::size_t words = std::min(behind.find(": "), behind.size());
        return failure(number_at(behind),
                       fmt::format("not well-formed XML{}", behind.substr(words)));
    }
    return failure(0, fmt::format("can't draw this SVG file: {}", message));
}

std::optional<Page> page_of(RsvgHandle* handle) {
    gboolean has_width = FALSE;
    gboolean has_height = FALSE;
    gboolean has_box = FALSE;
    RsvgLength width{};
    RsvgLength height{};
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle, &has_width, &width, &has_height, &height, &has_box,
                                         &box);
    has_box = has_box && box.width > 0.0 && box.height > 0.0;
    double pixel_width = 0.0;
    double pixel_height = 0.0;
    const bool has_size =
        rsvg_handle_get_intrinsic_size_in_pixels(handle, &pixel_width, &pixel_height) != FALSE &&
        pixel_width > 0.0 && pixel_height > 0.0;
    if (has_box && !has_size)
        return Page{box.x, box.y, box.width, box.height};
    if (has_box)
        return Page{box.x, box.y, box.width, box.width * pixel_height / pixel_width};
    if (has_size)
        return Page{0.0, 0.0, pixel_width, pixel_height};
    return std::nullopt;
}

// For an SVG with neither a size nor a viewBox: the extents of its drawing, in CSS px.
std::optional<Page> drawn_page(RsvgHandle* handle, GError** error) {
    constexpr RsvgRectangle usual{0.0, 0.0, 300.0, 150.0};  // CSS 2.1, 10.3.2
    RsvgRectangle ink{};
    RsvgRectangle drawn{};
    if (!rsvg_handle_get_geometry_for_layer(handle, nullptr, &usual, &ink, &drawn, error))
        return std::nullopt;
    // The extents exclude texts.
    const double left = std::min(drawn.x, usual.x);
    const double top = std::min(drawn.y, usual.y);
    const double width = std::max(drawn.x + drawn.width, usual.width) - left;
    const double height = std::max(drawn.y + drawn.height, usual.height) - top;
    const double margin = std::max(width, height);
    return Page{left - margin, top - margin, width + 2.0 * margin, height + 2.0 * margin};
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

// The rotated page is in the middle of a square surface.
std::string draw(RsvgHandle* handle, const Page& page, bool has_page, double units) {
    const double scale = units / std::max(page.width, page.height);
    const double side = 1.5 * units;
    std::string svg;
    const Surface surface(cairo_svg_surface_create_for_stream(append, &svg, side, side));
    const Context context(cairo_create(surface.get()));
    cairo_translate(context.get(), side / 2.0, side / 2.0);
    cairo_rotate(context.get(), page_rotation);
    cairo_scale(context.get(), scale, scale);
    cairo_translate(context.get(), -page.x - page.width / 2.0, -page.y - page.height / 2.0);
    cairo_matrix_t back;
    cairo_get_matrix(context.get(), &back);
    cairo_matrix_invert(&back);
    RsvgRectangle viewport{0.0, 0.0, 300.0, 150.0};
    if (has_page) {
        viewport = {page.x, page.y, page.width, page.height};
        cairo_rectangle(context.get(), page.x, page.y, page.width, page.height);
        cairo_clip(context.get());
    }
    GError* error = nullptr;
    if (!rsvg_handle_render_document(handle, context.get(), &viewport, &error))
        return failure(error);
    cairo_surface_finish(surface.get());
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        return failure(0, cairo_status_to_string(cairo_surface_status(surface.get())));
    return fmt::format("Smatrix({} {} {} {} {} {})\n", back.xx, back.yx, back.xy, back.yy, back.x0,
                       back.y0) +
           svg;
}

std::string convert(std::string_view bytes, const fs::path& file) {
    const Stream stream(g_memory_input_stream_new_from_data(
        bytes.data(), static_cast<gssize>(bytes.size()), nullptr));
    const File base(g_file_new_for_path(fs::absolute(file).c_str()));
    GError* error = nullptr;
    const Handle handle(rsvg_handle_new_from_stream_sync(stream.get(), base.get(),
                                                         RSVG_HANDLE_FLAGS_NONE, nullptr, &error));
    if (!handle)
        return failure(error);
    rsvg_handle_set_dpi(handle.get(), 96.0);
    if (!rsvg_handle_set_stylesheet(handle.get(),
                                    reinterpret_cast<const guint8*>(plain_style.data()),
                                    plain_style.size(), &error))
        return failure(error);
    const auto page = page_of(handle.get());
    const auto drawn = page ? page : drawn_page(handle.get(), &error);
    if (!drawn)
        return failure(error);
    std::string made;
    for (const double units : page_units)
        if (made = draw(handle.get(), *drawn, page.has_value(), units); made.starts_with('S'))
            break;
    return made;
}

std::string reason_of(const ChildOutput& output, const ChildBounds& bounds) {
    switch (output.end) {
        case ChildOutput::End::too_slow:
            return fmt::format("it takes too long; the limit is {:g} s", bounds.seconds);
        case ChildOutput::End::output_too_large:
            return fmt::format("its paths are too large; the limit is {} MB",
                               bounds.output_bytes >> 20);
        case ChildOutput::End::failed:
            return fmt::format("it needs more than {} MB of memory, or it crashes the SVG library",
                               bounds.memory_bytes >> 20);
        case ChildOutput::End::not_started:
            return output.system_error;
        case ChildOutput::End::finished:
            break;
    }
    return {};
}
}  // namespace

Result<std::string> svg_paths(std::string_view bytes, const fs::path& file) {
    constexpr ChildBounds bounds{.seconds = 5.0,
                                 .memory_bytes = std::size_t{1} << 30,
                                 .output_bytes = std::size_t{256} << 20};
    const ChildOutput made = run_bounded([&] { return convert(bytes, file); }, bounds);
    if (made.end != ChildOutput::End::finished)
        return fail(
            {file, 0, fmt::format("can't draw this SVG file: {}", reason_of(made, bounds))});
    const std::string& text = made.text;
    if (text.starts_with('S'))
        return text.substr(1);
    const std::size_t space = std::min(text.find(' '), text.size());
    return fail({file,
                 number_at(std::string_view(text).substr(std::min<std::size_t>(1, text.size()))),
                 text.substr(std::min(space + 1, text.size()))});
}
