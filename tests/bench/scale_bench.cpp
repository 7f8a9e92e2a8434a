// Cost of a large look compared with the same draws in plain GL: 50 passes of few pixels with two
// targets each, and 1,000 parameters. It is drawn by the executor alone and by the lab as in a
// window, without changes and while one parameter is dragged. An argument restricts the run to
// figures whose key contains it.
#include "bench/bench_lab.h"
#include "bench/plain_scale.h"
#include "bench/side_by_side.h"
#include "gpu/objects/readback.h"
#include "io/temporary_folder.h"
#include "lab/offline/offline.h"

#include <fmt/format.h>

#include <cstdlib>

namespace {
using bench::PlainScale;
using bench::ScaleSize;
using bench::wanted;

const bench::Topic topic{"scale", "Large looks: 50 passes of 8 x 8 px, 1,000 parameters"};

/// The dragged parameter, in the middle of the look.
struct DraggedParameter {
    int pass = 0;
    int parameter = 0;
};

DraggedParameter dragged_parameter(const ScaleSize& size) {
    return {size.passes / 2, size.parameters_per_pass / 2};
}

double value_at(int step) {
    return 0.3 + 0.05 * (step % 7);
}

/// Values in which no parameter has its default.
Values all_turned(const ScaleSize& size) {
    Values values;
    for (int pass = 0; pass < size.passes; ++pass)
        for (int i = 0; i < size.parameters_per_pass; ++i)
            values[bench::scale_parameter(pass, i)] = Value(bench::scale_initial(pass, i) + 0.01);
    return values;
}

Look look_at(const std::filesystem::path& folder) {
    RenderRequest request;
    request.look = folder.string();
    const Library library(wanted(find_roots(AFTERGLOW_SOURCE_DIR)));
    return wanted(prepare(request, library)).document.drawn_look();
}

/// Only the executor.
class OwnExecutor {
public:
    OwnExecutor(const Look& look, Values values, Extent extent)
        : m_executor(look, wanted(build_programs(look))), m_values(std::move(values)) {
        m_executor.set_values(m_values);
        wanted(m_executor.resize(extent, extent));
        m_frame.is_first = true;
        m_frame.time_delta = 1.0 / 60.0;
    }
    void set(const std::string& name, double value) {
        m_values.insert_or_assign(name, Value(value));
        m_executor.set_values(m_values);
    }
    void draw(double seconds) {
        m_frame.time = seconds;
        ++m_frame.number;
        m_executor.draw(m_frame);
        m_frame.is_first = false;
    }
    Picture picture() const {
        return gpu::read_picture(
            m_executor.target(static_cast<int>(m_executor.look().passes.size()) - 1));
    }

private:
    Executor m_executor;
    Values m_values;
    Frame m_frame;
};

/// Everything that a window does for a frame, except the panels.
class ScaleLab : public bench::BenchLab {
public:
    ScaleLab(const std::filesystem::path& folder, const std::filesystem::path& look,
             const Values& values, Extent extent)
        : BenchLab(folder, extent) {
        m_lab->looks().open(look.string());
        m_lab->update(0.0);
        while (m_lab->loader().is_loading() || !m_lab->renderer() ||
               m_lab->player().transport().frame_number() < 5)
            draw();
        m_lab->edit([&](Document& document) {
            for (const auto& [name, value] : values)
                document.set_value(name, value);
        });
        until_ready([this] { draw(); });
    }
    void set(const std::string& name, double value) {
        m_lab->edit([&](Document& document) { document.set_value(name, Value(value), true); });
    }
    // Such short updates that values do not count as static, so that programs are not specialised.
    void draw(double /*seconds*/ = 0.0) {
        m_lab->update(1e-5);
        while (m_lab->frames().has_unfinished_frame())
            m_lab->update(0.0);
    }
};

/// The reference, and a text: figures whose key contains it are measured.
struct Yardstick {
    PlainScale& plain;
    ScaleSize size;
    std::string only;
};

/// Both draw the same frames. During a drag, one parameter changes in each frame.
template <class Ours>
void compare_costs(const std::string& name, const Yardstick& by, Ours& ours) {
    constexpr double seconds = 6.0;
    const DraggedParameter dragged = dragged_parameter(by.size);
    const std::string parameter_name = bench::scale_parameter(dragged.pass, dragged.parameter);
    double time = 1.0;
    std::array<int, 2> turns{};
    const auto measure = [&](const char* doing, const char* words, bool is_dragged) {
        const std::string key = fmt::format("{}-{}-{}", by.size.format, name, doing);
        if (key.find(by.only) == std::string::npos)
            return;
        const auto plain = [&] {
            if (is_dragged)
                by.plain.set(dragged.pass, dragged.parameter, value_at(++turns[0]));
            by.plain.draw(time += 1.0 / 60.0);
        };
        const auto draw_ours = [&] {
            if (is_dragged)
                ours.set(parameter_name, value_at(++turns[1]));
            ours.draw(time);
        };
        bench::tell(topic, bench::more_figure(key,
                                              fmt::format("{}: {}, {}, CPU time minus plain GL",
                                                          by.size.format, name, words),
                                              bench::side_by_side_for(seconds, plain, draw_ours),
                                              bench::at_most(1.0)));
    };
    measure("still", "no change", false);
    measure("dragged", "one parameter dragged", true);
}

void tell_picture(const ScaleSize& size, PlainScale& plain, OwnExecutor& ours) {
    constexpr int frames = 10;
    for (int i = 1; i <= frames; ++i) {
        plain.draw(i / 60.0);
        ours.draw(i / 60.0);
    }
    Picture picture = ours.picture();
    Picture expected{picture.extent, 4, picture.encoding, plain.picture()};
    double largest = 0.0;
    const auto row = static_cast<std::size_t>(picture.extent.width) * 4;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const std::size_t from_below = expected.pixels.size() - (i / row + 1) * row + i % row;
        largest = std::max(largest, static_cast<double>(
                                        std::abs(picture.pixels[i] - expected.pixels[from_below])));
    }
    bench::tell(topic, {.key = std::string(size.format) + "-picture",
                        .what = fmt::format("{}: largest difference from plain GL after {} frames",
                                            size.format, frames),
                        .value = largest,
                        .bound = bench::at_most(1.0 / 255.0)});
}

void measure(const TemporaryFolder& folder, const ScaleSize& size, const std::string& only) {
    const bench::ScaleTexts texts = bench::scale_texts(size);
    const std::filesystem::path place = folder / size.format;
    folder.write(place / "look.json", texts.manifest);
    for (std::size_t i = 0; i < texts.fragments.size(); ++i)
        folder.write(place / fmt::format("pass{}.frag", i), texts.fragments[i]);
    const Values values = all_turned(size);
    const Extent extent{size.side, size.side};
    ScaleLab lab(folder.path(), place, values, extent);
    PlainScale plain = wanted(PlainScale::make(size));
    for (int pass = 0; pass < size.passes; ++pass)
        for (int i = 0; i < size.parameters_per_pass; ++i)
            plain.set(pass, i, bench::scale_initial(pass, i) + 0.01);
    OwnExecutor executor(look_at(place), values, extent);
    tell_picture(size, plain, executor);
    const Yardstick yardstick{plain, size, only};
    compare_costs("executor", yardstick, executor);
    compare_costs("lab", yardstick, lab);
}
}  // namespace

int main(int count, char** arguments) {
    setenv("LP_NUM_THREADS", "0", 0);  // its threads cost more than these draws
    const TemporaryFolder folder;
    const std::string only = count > 1 ? arguments[1] : "";
    measure(folder, {}, only);
    measure(folder, {.format = "rgba16f", .gl_format = GL_RGBA16F}, only);
    return EXIT_SUCCESS;
}
