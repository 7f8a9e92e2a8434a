#include "io/system/browser.h"

#include "io/system/child_process.h"
#include "io/system/process.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <unistd.h>
#include <vector>

namespace {
// Timers and animation frames of the page run without waiting. The clock stops at the budget.
std::vector<std::string> command_of(const std::string& browser, const BrowserRun& run) {
    const long milliseconds = std::lround(1000.0 * run.seconds);
    std::vector<std::string> command{browser,
                                     "--headless=new",
                                     "--no-first-run",
                                     "--disable-extensions",
                                     "--disable-dev-shm-usage",
                                     "--disable-background-networking",
                                     "--host-resolver-rules=MAP * ~NOTFOUND",
                                     fmt::format("--user-data-dir={}", run.profile.string()),
                                     fmt::format("--virtual-time-budget={}", milliseconds),
                                     fmt::format("--timeout={}", milliseconds),
                                     "--ignore-gpu-blocklist"};
    if (run.uses_software)
        command.insert(command.end(), {"--use-angle=swiftshader", "--enable-unsafe-swiftshader"});
    else
        command.emplace_back("--use-angle=gl-egl");
    if (::geteuid() == 0)  // its sandbox does not work for root
        command.emplace_back("--no-sandbox");
    command.insert(command.end(), {"--dump-dom", run.url});
    return command;
}
}  // namespace

std::string find_browser() {
    for (const char* const name : {"chromium", "chromium-browser", "google-chrome"})
        if (is_in_path(name))
            return name;
    return {};
}

Result<std::string> run_in_browser(const BrowserRun& run) {
    constexpr std::size_t longest = std::size_t{256} << 20;
    const std::string browser = find_browser();
    if (browser.empty())
        return fail({{}, 0, "chromium is not installed"});
    auto child = ChildProcess::start(command_of(browser, run));
    if (!child)
        return fail(child.error());
    auto page = child->read_all_within(run.seconds, longest, run.is_cancelled);
    if (!page)
        return fail(
            {{}, 0, fmt::format("{} took more than {} s. Raise --timeout.", browser, run.seconds)});
    if (!child->finish())
        return fail({{}, 0, fmt::format("{} failed: {}", browser, child->complaint())});
    return std::move(*page);
}
