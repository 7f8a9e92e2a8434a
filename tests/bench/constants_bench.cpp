// Changing a constant of the shown shader: the time until its picture is drawn, and the number of
// new pictures per second during continuous change. The shader marches 48 steps, like many of
// Shadertoy's. Neither the program nor the driver caches any of it.
#include "bench/bench_lab.h"
#include "bench/side_by_side.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

namespace fs = std::filesystem;

namespace {
constexpr const char* marching = R"(#define STEPS 48          // @range 8 256 1
const float GLOW = 0.35;  // @range 0 1
float map(vec3 p) {
    vec3 q = abs(mod(p, 4.0) - 2.0) - vec3(0.6);
    return length(max(q, 0.0)) - 0.2;
}
void mainImage(out vec4 color, in vec2 at) {
    vec3 from = vec3(0.0, 0.0, iTime);
    vec3 way = normalize(vec3((at - 0.5 * iResolution.xy) / iResolution.y, 1.0));
    float t = 0.0;
    float glow = 0.0;
    for (int i = 0; i < STEPS; ++i) {
        float d = map(from + way * t);
        glow += GLOW / (1.0 + 40.0 * d * d) / float(STEPS);
        if (d < 0.001) break;
        t += d;
    }
    color = vec4(vec3(exp(-0.15 * t)) + glow, 1.0);
}
)";

const bench::Topic topic{"constants", "Changing a constant of a shader with 48 ray-marching steps"};

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A lab without a window and with its own folder.
class ConstantsBench : public bench::BenchLab {
public:
    ConstantsBench(const fs::path& folder, Extent picture) : BenchLab(folder, picture) {
        const fs::path file = folder / "marching.glsl";
        std::ofstream(file) << marching;
        m_lab->looks().open(file.string());
        while (m_lab->player().transport().frame_number() < 10)
            update();
    }

    double frame_milliseconds() {
        const auto start = Clock::now();
        for (int i = 0; i < 5; ++i)
            update();
        return milliseconds_since(start) / 5.0;
    }
    // The time until a frame is drawn with it.
    double until_seen(const char* name, double value) {
        const auto start = Clock::now();
        set(name, value, false);
        while (seen(name) != value || m_lab->loader().is_loading())
            update();
        update();
        return milliseconds_since(start);
    }
    int pictures_per_second() {
        const auto start = Clock::now();
        int pictures = 0;
        double value = 1.0 + seen("GLOW");
        double last = seen("GLOW");
        while (milliseconds_since(start) < 1000.0) {
            set("GLOW", value += 1e-3, true);
            update();
            pictures += seen("GLOW") != last ? 1 : 0;
            last = seen("GLOW");
        }
        set("GLOW", value, false);
        return pictures;
    }

private:
    void set(const char* name, double value, bool goes_on) {
        m_lab->edit([&](Document& document) {
            document.set_value(name, Value(value), goes_on);
            if (!goes_on)
                document.finish();
        });
    }
    double seen(const char* name) const {
        return m_lab->document()->look().constants.at(name).number();
    }
    void update() {
        m_lab->update(1.0 / 60.0);
        gpu::finish();
    }
};
}  // namespace

int main() {
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    setenv("MESA_SHADER_CACHE_DIR", (folder / "driver").c_str(), 1);
    for (const Extent picture : {Extent{320, 180}, Extent{640, 360}, Extent{1280, 720}}) {
        ConstantsBench bench(folder, picture);
        std::vector<double> times;
        for (int i = 0; i < 9; ++i)  // all different, because the driver caches them
            times.push_back(bench.until_seen("GLOW", 0.05 * i + 1e-5 * picture.width));
        const std::string size = fmt::format("{} x {}", picture.width, picture.height);
        bench::tell(topic,
                    {.key = fmt::format("seen-{}", picture.height),
                     .what = fmt::format("{}: time from a change to its first frame", size),
                     .value = bench::median(times),
                     .unit = "ms",
                     .detail = fmt::format("frame time {:.3g} ms", bench.frame_milliseconds())});
        bench::tell(topic, {.key = fmt::format("turning-{}", picture.height),
                            .what = fmt::format("{}: new pictures during continuous change", size),
                            .value = static_cast<double>(bench.pictures_per_second()),
                            .unit = "per second"});
    }
    fs::remove_all(folder);
    return EXIT_SUCCESS;
}
