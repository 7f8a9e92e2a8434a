#include "lab/storage/instance_lock.h"

#include "base/file.h"
#include "lab/session.h"
#include "lab/storage/remote_store.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <optional>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {
/// Roots with a state folder, deleted at the end.
class StateFolder {
public:
    StateFolder() {
        std::string name = (fs::temp_directory_path() / "afterglow-window-XXXXXX").string();
        m_folder = mkdtemp(name.data());
    }
    ~StateFolder() { fs::remove_all(m_folder); }
    StateFolder(const StateFolder&) = delete;
    StateFolder& operator=(const StateFolder&) = delete;

    Roots roots(int instance = 1) const {
        Roots roots{m_folder / "program", m_folder / "user", m_folder / "state"};
        roots.instance = instance;
        return roots;
    }

private:
    fs::path m_folder;
};
}  // namespace

TEST_CASE("each window gets the lowest free number") {
    const StateFolder folder;
    std::optional<InstanceLock> first = InstanceLock::take(folder.roots());
    const InstanceLock second = InstanceLock::take(folder.roots());
    CHECK(first->number() == 1);
    CHECK(second.number() == 2);
    first.reset();
    CHECK(InstanceLock::take(folder.roots()).number() == 1);
}

TEST_CASE("the number is free after a crash") {
    const StateFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        const InstanceLock lock = InstanceLock::take(folder.roots());
        _exit(lock.number() == 1 ? 0 : 1);  // without destructors, as in a crash
    }
    int status = -1;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(status == 0);
    CHECK(InstanceLock::take(folder.roots()).number() == 1);
}

TEST_CASE("a state folder that cannot be written does not prevent the start") {
    Roots roots;
    roots.state = "/proc/afterglow";
    CHECK(InstanceLock::take(roots).number() == 1);
}

TEST_CASE("a second window starts from the session of the first and saves its own") {
    const StateFolder folder;
    Session session;
    session.look = "phosphor";
    session.opened.front().saved.preset.look = session.current.preset.look = "phosphor";
    REQUIRE(save_session(folder.roots(), session).has_value());
    Diagnostics warnings;
    Session second = load_session(folder.roots(2), warnings);
    CHECK(second.look == "phosphor");
    second.look = "crt";
    REQUIRE(save_session(folder.roots(2), second).has_value());
    CHECK(load_session(folder.roots(), warnings).look == "phosphor");
    CHECK(load_session(folder.roots(2), warnings).look == "crt");
    CHECK(warnings.empty());
}

TEST_CASE("a second window does not listen for OSC, and both windows save only their changes") {
    const StateFolder folder;
    const Roots first_roots = folder.roots();
    const Roots second_roots = folder.roots(2);
    RemoteStore first(first_roots);
    RemoteStore second(second_roots);
    RemoteSettings settings;
    settings.listens_to_osc = true;
    settings.osc_port = 9123;
    REQUIRE(first.save(settings).has_value());
    auto of_second = second.load();
    REQUIRE(of_second.has_value());
    CHECK_FALSE(of_second->listens_to_osc);
    of_second->has_soft_takeover = !of_second->has_soft_takeover;
    settings.osc_reply_port = 9200;
    REQUIRE(first.save(settings).has_value());
    REQUIRE(second.save(*of_second).has_value());
    const auto stored = RemoteStore(first_roots).load();
    REQUIRE(stored.has_value());
    CHECK(stored->listens_to_osc);
    CHECK(stored->osc_port == 9123);
    CHECK(stored->osc_reply_port == 9200);
    CHECK(stored->has_soft_takeover == of_second->has_soft_takeover);
}
