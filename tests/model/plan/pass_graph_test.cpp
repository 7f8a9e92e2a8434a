#include "model/plan/pass_graph.h"

#include <doctest/doctest.h>

#include <set>
#include <utility>

namespace {
using From = Input::From;

Pass named(const std::string& name, const std::vector<Input>& inputs = {}) {
    Pass pass;
    pass.name = name;
    pass.inputs = inputs;
    return pass;
}

Input read(const std::string& uniform, const std::string& pass, int frames_ago = 0) {
    return {uniform, From::pass, pass, frames_ago, {}};
}

Look look_of(std::vector<Pass> passes) {
    Look look;
    look.passes = std::move(passes);
    return look;
}

const PassGraph::Edge& edge(const PassGraph& graph, const std::string& from, const std::string& to,
                            int frames_ago = 0) {
    for (const PassGraph::Edge& found : graph.edges)
        if (graph.nodes[found.from].name == from && graph.nodes[found.to].name == to &&
            found.frames_ago == frames_ago)
            return found;
    FAIL("no line from " << from << " to " << to);
    return graph.edges.front();
}

int column(const PassGraph& graph, const std::string& name) {
    for (const PassGraph::Node& node : graph.nodes)
        if (node.name == name)
            return node.column;
    return -1;
}
}  // namespace

TEST_CASE("a pass is right of the passes it reads from this frame; past frames do not count") {
    const PassGraph graph = graph_of(look_of(
        {named("beam"), named("light", {read("current", "beam"), read("before", "light", 1)}),
         named("glow", {read("image", "light"), read("late", "screen", 2)}),
         named("screen", {read("light", "light"), read("glow", "glow")})}));
    CHECK(graph.columns == 4);
    CHECK(column(graph, "beam") == 0);
    CHECK(column(graph, "light") == 1);
    CHECK(column(graph, "glow") == 2);
    CHECK(column(graph, "screen") == 3);
    CHECK(graph.edges.size() == 6);
    CHECK(edge(graph, "light", "light", 1).uniforms == std::vector<std::string>{"before"});
    CHECK(edge(graph, "screen", "glow", 2).bends.empty());
}

TEST_CASE("a line across columns has its own row in each, apart from all passes") {
    const PassGraph graph =
        graph_of(look_of({named("a"), named("b", {read("x", "a")}), named("c", {read("x", "b")}),
                          named("d", {read("x", "c"), read("y", "a")})}));
    REQUIRE(edge(graph, "a", "d").bends.size() == 2);
    std::set<std::pair<int, double>> places;
    for (const PassGraph::Node& node : graph.nodes)
        places.emplace(node.column, node.row);
    for (int i = 0; i < 2; ++i)
        places.emplace(i + 1, edge(graph, "a", "d").bends[static_cast<std::size_t>(i)]);
    CHECK(places.size() == 6);
    CHECK(graph.highest == -0.5);
    CHECK(graph.lowest == 0.5);
}

TEST_CASE("avoidable line crossings are avoided") {
    // Two chains; the second reader is listed first.
    const PassGraph graph =
        graph_of(look_of({named("a"), named("b"), named("of_b", {read("x", "b")}),
                          named("of_a", {read("x", "a")})}));
    const auto row = [&](std::size_t node) { return graph.nodes[node].row; };
    CHECK((row(0) < row(1)) == (row(3) < row(2)));
}

TEST_CASE("source and images are left of their first reader; a later pass is read from the past") {
    const Input source{"scene", From::source, "", 0, {}};
    const Input image{"lut", From::image, "colors", 0, {}};
    const PassGraph graph = graph_of(look_of(
        {named("a", {source, read("ahead", "b")}), named("b", {read("x", "a"), image, source})}));
    CHECK(graph.nodes.size() == 4);
    CHECK(column(graph, "source") == 0);
    CHECK(column(graph, "a") == 1);
    CHECK(column(graph, "colors") == 1);
    CHECK(column(graph, "b") == 2);
    CHECK(edge(graph, "b", "a", 1).uniforms == std::vector<std::string>{"ahead"});
    CHECK(edge(graph, "source", "b").bends.size() == 1);
}

TEST_CASE("samplers with the same input share a line; a missing input has none") {
    const PassGraph graph = graph_of(
        look_of({named("a"), named("b", {read("x", "a"), read("y", "a"), read("z", "lost")})}));
    REQUIRE(graph.edges.size() == 1);
    CHECK(graph.edges.front().uniforms == std::vector<std::string>{"x", "y"});
}
