#include "lab/golden/golden_check.h"

#include "base/text.h"
#include "io/files/atomic_file.h"
#include "lab/golden/golden_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace fs = std::filesystem;

namespace {
/// The items to draw and the orphaned names to handle.
struct GoldenTasks {
    std::vector<GoldenItem> items;
    std::vector<std::string> orphans;
};

Result<GoldenTasks> tasks_of(const GoldenRequest& request, const GoldenFolder& folder,
                             const GoldenRecord& record) {
    std::vector<std::string> known;
    for (const GoldenItem& item : folder.items)
        known.push_back(item.name);
    GoldenTasks tasks{folder.items, {}};
    for (const auto& [name, picture] : record.pictures)
        if (std::ranges::find(known, name) == known.end())
            tasks.orphans.push_back(name);
    if (request.names.empty())
        return tasks;
    known.insert(known.end(), tasks.orphans.begin(), tasks.orphans.end());
    std::set<std::string> wanted;
    for (const std::string& text : request.names) {
        const std::string name = text.ends_with(".png") ? text.substr(0, text.size() - 4) : text;
        if (std::ranges::find(known, name) == known.end())
            return fail({{},
                         0,
                         fmt::format("'{}' has no look or preset with the picture '{}'{}",
                                     request.folder.string(), name, did_you_mean(name, known))});
        wanted.insert(name);
    }
    std::erase_if(tasks.items, [&](const GoldenItem& item) { return !wanted.contains(item.name); });
    std::erase_if(tasks.orphans, [&](const std::string& name) { return !wanted.contains(name); });
    return tasks;
}

Result<void> check_targets(const GoldenRequest& request) {
    if (auto writable = check_writable(golden_report_file(request)); !writable)
        return writable;
    return request.updates ? check_writable(golden_record_file(request)) : Result<void>();
}

// Looks and presets of the user's own folder are not used, so that the pictures depend only on the
// program and on the given folder.
Library library_with(const Library& library, const GoldenRequest& request,
                     const std::vector<LookEntry>& looks) {
    Roots roots = library.roots();
    roots.user = fs::absolute(request.folder).lexically_normal();
    return Library(std::move(roots), files_of_build(), looks);
}
}  // namespace

Result<GoldenOutcome> check_golden(const GoldenRequest& request, const Library& library,
                                   const std::function<void(int done, int all)>& progress) {
    const auto folder = read_golden_folder(request.folder);
    if (!folder)
        return fail(folder.error());
    const auto record = load_golden_record(golden_record_file(request));
    if (!record)
        return fail(record.error());
    const auto tasks = tasks_of(request, *folder, *record);
    if (!tasks)
        return fail(tasks.error());
    if (auto writable = check_targets(request); !writable)
        return fail(writable.error());
    const auto driver = read_golden_driver();
    if (!driver)
        return fail(driver.error());
    GoldenRun run(request, *record, *driver,
                  GoldenDrawer(library_with(library, request, folder->looks)));
    GoldenOutcome outcome{.bounds = run.bounds(), .driver = *driver};
    for (const GoldenItem& item : tasks->items) {
        auto result = run.result_of(item);
        if (!result)
            return fail(result.error());
        outcome.results.push_back(std::move(*result));
        progress(static_cast<int>(outcome.results.size()), static_cast<int>(tasks->items.size()));
    }
    for (const std::string& name : tasks->orphans) {
        auto result = run.orphan(name);
        if (!result)
            return fail(result.error());
        outcome.results.push_back(std::move(*result));
    }
    if (request.updates)
        if (auto saved = run.save_record(); !saved)
            return fail(saved.error());
    outcome.warnings = run.warnings();
    std::ranges::stable_sort(outcome.results, {}, [](const GoldenResult& result) {
        return std::tuple(result.status, result.item.name);
    });
    return outcome;
}
