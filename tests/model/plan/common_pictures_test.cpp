#include "model/plan/common_pictures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace {
constexpr Extent viewport{100, 10};
constexpr std::size_t picture_bytes = 100 * 10 * 8;  // rgba16f

Input from(const std::string& name, int frames_ago = 0, bool mipmap = false) {
    return {"from_" + name + std::to_string(frames_ago),
            Input::From::pass,
            name,
            frames_ago,
            {Filter::linear, Wrap::edge, mipmap}};
}

Pass drawn(const std::string& name, std::vector<Input> inputs = {}) {
    Pass made;
    made.name = name;
    made.inputs = std::move(inputs);
    made.format = Format::rgba16f;
    return made;
}

Look look_of(std::vector<Pass> passes) {
    Look look;
    look.passes = std::move(passes);
    return look;
}

// p0 -> p1 -> ... Each pass reads the previous one.
Look chain(int count) {
    std::vector<Pass> passes{drawn("p0")};
    for (int i = 1; i < count; ++i)
        passes.push_back(drawn("p" + std::to_string(i), {from("p" + std::to_string(i - 1))}));
    return look_of(std::move(passes));
}

PlanTerms last_seen(const Look& look) {
    PlanTerms terms{.draws_once = true};
    terms.seen.assign(look.passes.size(), false);
    terms.seen.back() = true;
    return terms;
}

Plan planned(const Look& look, const PlanTerms& terms) {
    return plan_targets(look, viewport, {}, {}, terms).value();
}

std::size_t pictures(const Look& look, const PlanTerms& terms) {
    return memory_of(planned(look, terms)) / picture_bytes;
}
std::size_t pictures(const Look& look) {
    return pictures(look, last_seen(look));
}
}  // namespace

TEST_CASE("a chain of any length needs two shared pictures and the last pass's own") {
    CHECK(pictures(chain(1)) == 1);
    CHECK(pictures(chain(2)) == 2);
    CHECK(pictures(chain(3)) == 3);
    for (const int count : {4, 5, 9, 30}) {
        CAPTURE(count);
        CHECK(pictures(chain(count)) == 3);
        CHECK(pictures(chain(count), {.seen = last_seen(chain(count)).seen}) ==
              static_cast<std::size_t>(count));
    }
    const Plan plan = planned(chain(6), last_seen(chain(6)));
    CHECK(plan.common == std::vector<CommonPicture>(2, {viewport, Format::rgba16f, false}));
    CHECK(plan.targets[0].common == 0);
    CHECK(plan.targets[1].common == 1);
    CHECK(plan.targets[2].common == 0);
    CHECK(plan.targets[2].last_reader == 3);
    CHECK_FALSE(plan.targets[5].common.has_value());
}

TEST_CASE("a picture is kept until its last reader is drawn") {
    Look look = chain(6);
    look.passes[5].inputs.push_back(from("p0"));
    CHECK(pictures(look) == 4);  // p0 and the two alternating pictures
    look.passes[3].inputs.push_back(from("p1"));
    CHECK(pictures(look) == 5);  // p1 and p2 during p3
}

TEST_CASE("displayed, kept and accumulating passes keep their own picture") {
    const Look look = chain(5);
    PlanTerms terms = last_seen(look);
    CHECK(pictures(look, terms) == 3);
    terms.seen[2] = true;
    CHECK(pictures(look, terms) == 4);
    terms.seen[2] = false;
    terms.kept = {false, false, true};
    CHECK(pictures(look, terms) == 4);
    Look gathering = chain(5);
    gathering.passes[2].accumulate = true;
    for (Pass& pass : gathering.passes)
        pass.format = Format::rgba8;
    CHECK(memory_of(planned(gathering, last_seen(gathering))) == 4 * picture_bytes / 2);
    Look late = chain(5);  // p0 reads the output of p2 of the previous frame
    late.passes[0].inputs = {from("p2")};
    CHECK(pictures(late) == 4);
}

TEST_CASE("pictures are shared only with the same size, format and mipmaps") {
    for (const int other : {0, 1, 2, 3}) {
        Look look = chain(5);
        if (other == 1)
            look.passes[2].size[0] = {Side::By::pixels, 50, {}};
        if (other == 2)
            look.passes[2].format = Format::rgba32f;
        if (other == 3)
            look.passes[3].inputs = {from("p2", 0, true)};  // so p2 has mipmaps
        CHECK(planned(look, last_seen(look)).targets[2].common.has_value() == (other == 0));
    }
    Look levels = chain(6);
    for (const std::size_t reader : {1U, 3U, 5U})
        levels.passes[reader].inputs[0].sampler.mipmap = true;
    const Plan plan = planned(levels, last_seen(levels));
    CHECK(plan.targets[0].common == plan.targets[2].common);
    CHECK(plan.targets[2].common == plan.targets[4].common);
    CHECK(plan.targets[1].common != plan.targets[0].common);
    // Three passes with mipmaps share one picture, two without share another; the last has its own.
    CHECK(memory_of(plan) == picture_bytes * 4 / 3 + 2 * picture_bytes);
}

TEST_CASE("two passes with feedback share one spare picture") {
    const auto glow = [](const std::string& name, const std::string& beam) {
        return drawn(name, {from(beam), from(name, 1)});
    };
    const Look look =
        look_of({drawn("beam"), glow("a", "beam"), glow("b", "a"), drawn("show", {from("b")})});
    // a, b and show have their own. While a is drawn: beam, a. While b is drawn: a, b.
    CHECK(pictures(look, {.seen = last_seen(look).seen}) == 6);
    // NaN detection after the frame may read the beam's floats, so they stay until the frame's end.
    CHECK(pictures(look) == 5);
    Look bytes = look;
    for (Pass& pass : bytes.passes)
        pass.format = Format::rgba8;
    CHECK(memory_of(planned(bytes, last_seen(bytes))) == 5 * picture_bytes / 2);
    const Plan plan = planned(look, last_seen(look));
    CHECK(plan.targets[1].common == plan.targets[2].common);
    CHECK(plan.targets[1].last_reader == 1);
}

TEST_CASE("a pass that only later frames read is drawn last where that saves a picture") {
    // The charge reuses the picture of the light, because show has already read it.
    const Look look = look_of({drawn("beam"), drawn("charge", {from("beam"), from("charge", 1)}),
                               drawn("light", {from("beam"), from("charge", 1)}),
                               drawn("show", {from("light")})});
    const Plan plan = planned(look, last_seen(look));
    CHECK(draw_order(plan) == std::vector<std::size_t>{0, 2, 3, 1});
    CHECK(memory_of(plan) == 4 * picture_bytes);  // beam, previous charge, light and charge, show
    Look read = look;
    read.passes[2].inputs[1].frames_ago = 0;
    CHECK(draw_order(planned(read, last_seen(read))) == std::vector<std::size_t>{0, 1, 2, 3});
}

TEST_CASE("inputs that no program reads and passes that are left out need no picture") {
    Look look = look_of(
        {drawn("unread"), drawn("a", {from("unread"), from("a", 1)}), drawn("show", {from("a")})});
    PlanTerms terms = last_seen(look);
    CHECK(pictures(look, terms) == 4);
    terms.read = {{}, {false, false}, {true}};
    CHECK(planned(look, terms).targets[1].slots == 1);
    terms.kept = terms.left_out = {true, false, false};
    CHECK(memory_of(planned(look, terms)) == 2 * picture_bytes + 8);  // and one texel
    terms.seen[0] = true;
    CHECK(pictures(look, terms) == 3);
    terms.draws_once = false;
    CHECK(pictures(look, terms) == 4);
}

namespace {
/// Simulates drawing a plan: the pass and frame that each picture holds.
class DrawnPlan {
public:
    explicit DrawnPlan(const Look& look, Plan plan) : m_look(look), m_plan(std::move(plan)) {
        m_common.resize(m_plan.common.size());
        for (const PlannedTarget& target : m_plan.targets)
            m_own.emplace_back(static_cast<std::size_t>(target.slots - (target.common ? 1 : 0)));
    }

    void draw(int frame) {
        for (std::size_t i = 0; i < m_own.size(); ++i)
            if (!m_plan.targets[i].common)  // the oldest is overwritten
                std::rotate(m_own[i].begin(), m_own[i].end() - 1, m_own[i].end());
        m_newest_is_common.assign(m_own.size(), true);
        for (const std::size_t pass : draw_order(m_plan)) {
            for (const Input& input : m_look.passes[pass].inputs)
                check_reading(pass, input, frame);
            at(pass, 0) = {static_cast<int>(pass), frame};
            for (std::size_t i = 0; i < m_own.size(); ++i)
                if (m_plan.targets[i].common && m_plan.targets[i].last_reader == pass)
                    release(i);
        }
        CHECK(at(m_own.size() - 1, 0) == Tag{static_cast<int>(m_own.size()) - 1, frame});
    }

private:
    using Tag = std::pair<int, int>;

    void release(std::size_t pass) {
        m_newest_is_common[pass] = false;
        if (m_own[pass].empty())
            return;
        std::swap(m_own[pass].back(), m_common[*m_plan.targets[pass].common]);
        std::rotate(m_own[pass].begin(), m_own[pass].end() - 1, m_own[pass].end());
    }

    Tag& at(std::size_t pass, int frames_ago) {
        const auto common = m_plan.targets[pass].common;
        const bool is_beside = common && (m_newest_is_common[pass] || m_own[pass].empty());
        if (is_beside && frames_ago == 0)
            return m_common[*common];
        return m_own[pass].at(static_cast<std::size_t>(frames_ago - (is_beside ? 1 : 0)));
    }

    void check_reading(std::size_t reader, const Input& input, int frame) {
        const int read = *find_pass(m_look, input.name);
        const bool is_late = input.frames_ago == 0 && read >= static_cast<int>(reader);
        const int ago = is_late ? 1 : input.frames_ago;
        const int kept = is_late && m_plan.targets[static_cast<std::size_t>(read)].slots == 1
                             ? 0
                             : ago;  // not overwritten yet
        if (frame > ago)
            CHECK(at(static_cast<std::size_t>(read), kept) == Tag{read, frame - ago});
    }

    const Look& m_look;
    Plan m_plan;
    std::vector<std::vector<Tag>> m_own;  // the newest first
    std::vector<Tag> m_common;
    std::vector<bool> m_newest_is_common;
};
}  // namespace

TEST_CASE("random graphs: no picture is overwritten before its last reader") {
    std::mt19937 chance(5);
    const auto below = [&](std::size_t count) { return chance() % count; };
    std::size_t saved = 0;
    for (int n = 0; n < 2000; ++n) {
        const std::size_t count = 2 + below(8);
        Look look = chain(static_cast<int>(count));
        for (Pass& pass : look.passes) {
            if (below(4) == 0)
                pass.inputs.clear();
            for (std::size_t more = below(3); more > 0; --more)
                pass.inputs.push_back(
                    from("p" + std::to_string(below(count)), static_cast<int>(below(3))));
            pass.format = below(5) == 0 ? Format::rgba16f : Format::rgba8;
        }
        const PlanTerms terms = last_seen(look);
        const Plan plan = planned(look, terms);
        const std::size_t apart = memory_of(planned(look, {.seen = terms.seen}));
        CHECK(memory_of(plan) <= apart);
        saved += memory_of(plan) < apart ? 1 : 0;
        DrawnPlan drawing(look, plan);
        for (int frame = 1; frame <= 6; ++frame)
            drawing.draw(frame);
    }
    CHECK(saved > 500);
}
