#include "ui/passes/pass_graph_panel.h"

#include "model/look/own_name.h"
#include "model/plan/parameter_use.h"
#include "model/plan/pass_graph.h"
#include "ui/picture/pass_switch_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
using Node = PassGraph::Node;
using Edge = PassGraph::Edge;

/// Position and spacing of the graph in the pane.
struct Paper {
    ImVec2 middle_of_left;  // of column 0, row 0
    float column = 0.0f;    // spacing
    float row = 0.0f;
    ImVec2 node;  // size

    ImVec2 at(int column_number, double row_number) const {
        return {middle_of_left.x + column * static_cast<float>(column_number),
                middle_of_left.y + row * static_cast<float>(row_number)};
    }
    ImVec2 left(const Node& of) const {
        const ImVec2 middle = at(of.column, of.row);
        return {middle.x - node.x * 0.5f, middle.y};
    }
    ImVec2 right(const Node& of) const {
        const ImVec2 middle = at(of.column, of.row);
        return {middle.x + node.x * 0.5f, middle.y};
    }
};

ImVec2 on_curve(const std::array<ImVec2, 4>& p, float t) {
    const float s = 1.0f - t;
    const std::array w{s * s * s, 3.0f * s * s * t, 3.0f * s * t * t, t * t * t};
    return {w[0] * p[0].x + w[1] * p[1].x + w[2] * p[2].x + w[3] * p[3].x,
            w[0] * p[0].y + w[1] * p[1].y + w[2] * p[2].y + w[3] * p[3].y};
}

void draw_curve(const std::array<ImVec2, 4>& p, ImU32 color, float width, bool is_dashed) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (!is_dashed) {
        list.AddBezierCubic(p[0], p[1], p[2], p[3], color, width);
        return;
    }
    const float length = std::hypot(p[3].x - p[0].x, p[3].y - p[0].y) + std::abs(p[1].y - p[0].y) +
                         std::abs(p[2].y - p[3].y);
    const int dashes = std::max(3, static_cast<int>(length / (7.0f * width)));
    for (int i = 0; i < dashes; ++i) {
        const auto start = static_cast<float>(i) / static_cast<float>(dashes);
        list.AddLine(on_curve(p, start), on_curve(p, start + 0.55f / static_cast<float>(dashes)),
                     color, width);
    }
}

void draw_arrow(const ImVec2& tip, const ImVec2& toward, ImU32 color, float size) {
    const float length = std::max(std::hypot(toward.x, toward.y), 1e-3f);
    const ImVec2 along(toward.x / length * size, toward.y / length * size);
    const ImVec2 across(-along.y * 0.5f, along.x * 0.5f);
    ImGui::GetWindowDrawList()->AddTriangleFilled(
        tip, {tip.x - along.x + across.x, tip.y - along.y + across.y},
        {tip.x - along.x - across.x, tip.y - along.y - across.y}, color);
}

// From column to column, horizontal at both ends.
void draw_forward(const Edge& edge, const PassGraph& graph, const Paper& paper, ImU32 color,
                  float width) {
    const Node& from = graph.nodes[edge.from];
    const Node& to = graph.nodes[edge.to];
    ImVec2 at = paper.right(from);
    const bool is_dashed = edge.frames_ago > 0;
    const auto go = [&](const ImVec2& next) {
        const float pull = (next.x - at.x) * 0.5f;
        draw_curve({at, {at.x + pull, at.y}, {next.x - pull, next.y}, next}, color, width,
                   is_dashed);
        at = next;
    };
    for (std::size_t i = 0; i < edge.bends.size(); ++i) {
        const ImVec2 middle = paper.at(from.column + 1 + static_cast<int>(i), edge.bends[i]);
        const float half = paper.node.x * 0.5f;
        go({middle.x - half, middle.y});
        ImGui::GetWindowDrawList()->AddLine(at, {middle.x + half, middle.y}, color, width);
        at.x = middle.x + half;
    }
    const ImVec2 end = paper.left(to);
    const float arrow = 5.0f * width;
    go({end.x - arrow * 0.6f, end.y});
    draw_arrow(end, {1.0f, 0.0f}, color, arrow);
}

// An edge from an earlier frame runs below the passes back to its reader.
void draw_backward(const Edge& edge, const PassGraph& graph, const Paper& paper, ImU32 color,
                   float width) {
    const Node& from = graph.nodes[edge.from];
    const Node& to = graph.nodes[edge.to];
    const float half = paper.node.y * 0.5f;
    ImVec2 start = paper.at(from.column, from.row);
    ImVec2 end = paper.at(to.column, to.row);
    const bool is_own = edge.from == edge.to;
    start.x += paper.node.x * (is_own ? 0.25f : 0.1f);
    end.x -= paper.node.x * (is_own ? 0.25f : 0.1f);
    start.y += half;
    end.y += half;
    const float sag = paper.row * (is_own ? 0.55f : 0.8f);
    const float low = std::max(start.y, end.y) + sag;
    const float arrow = 5.0f * width;
    draw_curve({start, {start.x, low}, {end.x, low}, {end.x, end.y + arrow * 0.6f}}, color, width,
               true);
    draw_arrow(end, {0.0f, -1.0f}, color, arrow);
}

void draw_edge(const Edge& edge, const PassGraph& graph, const Paper& paper, ImU32 color,
               float width) {
    const bool is_back = edge.frames_ago > 0 && graph.nodes[edge.from].kind == Input::From::pass;
    if (is_back)
        draw_backward(edge, graph, paper, color, width);
    else
        draw_forward(edge, graph, paper, color, width);
}

// The switch state of a pass, on the upper edge of its node.
void draw_state(const std::string& state, const ImVec2& middle, const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    const ImVec2 text_size = ImGui::CalcTextSize(state.c_str());
    const ImVec2 low(std::floor(middle.x - text_size.x * 0.5f),
                     std::floor(middle.y - text_size.y * 0.6f));
    const float pad = 3.0f * scene.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x - pad, low.y}, {low.x + text_size.x + pad, low.y + text_size.y},
                       theme::packed(theme::popup), pad);
    list.AddText(low, theme::packed(theme::warning), state.c_str());
}

std::size_t pass_of(const Node& node, const Scene& scene) {
    const auto pass = find_pass(scene.lab.renderer->executor().look(), node.name);
    return static_cast<std::size_t>(pass.value_or(0));
}

std::string help_of(std::size_t node, const PassGraph& graph, const Scene& scene) {
    const Node& drawn = graph.nodes[node];
    const bool is_pass = drawn.kind == Input::From::pass;
    std::string text = is_pass                               ? drawn.name
                       : drawn.kind == Input::From::source   ? "Source picture"
                       : drawn.kind == Input::From::keyboard ? "Keyboard"
                       : drawn.kind == Input::From::sound    ? fmt::format("Sound: {}", drawn.name)
                                                             : fmt::format("Image: {}", drawn.name);
    if (is_pass) {
        const PlannedTarget& target =
            scene.lab.renderer->executor().plan().targets[pass_of(drawn, scene)];
        text += fmt::format("\n{} {}", size_text(target.extent), info_of(target.format).name);
    }
    for (const Edge& edge : graph.edges)
        if (edge.to == node)
            text += edge.frames_ago > 0
                        ? fmt::format("\nReads {}@{} as {}", graph.nodes[edge.from].name,
                                      edge.frames_ago, fmt::join(edge.uniforms, ", "))
                        : fmt::format("\nReads {} as {}", graph.nodes[edge.from].name,
                                      fmt::join(edge.uniforms, ", "));
    for (const Edge& edge : graph.edges)
        if (edge.from == node)
            text += fmt::format("\nRead by {}", graph.nodes[edge.to].name);
    return text;
}

void draw_node(std::size_t index, const PassGraph& graph, const Paper& paper, const Scene& scene,
               bool is_chosen, Edits& edits) {
    const Node& node = graph.nodes[index];
    const bool is_pass = node.kind == Input::From::pass;
    const ImVec2 middle = paper.at(node.column, node.row);
    const ImVec2 low(middle.x - paper.node.x * 0.5f, middle.y - paper.node.y * 0.5f);
    const ScopedId id(static_cast<int>(index));
    ImGui::SetCursorScreenPos(low);
    if (ImGui::InvisibleButton("##node", paper.node) && is_pass)
        edits.arrange([name = node.name](WindowState& window) {
            window.views.inspected.inspect(name);
            window.layout.panels.show(panel_id::inspector);
        });
    edits.mark("node:" + node.name);
    tooltip(help_of(index, graph, scene));
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_pass && ImGui::BeginPopupContextItem("##switches")) {
        draw_pass_switches(node.name, scene, edits);
        ImGui::EndPopup();
    }
    const ImVec2 high(low.x + paper.node.x, low.y + paper.node.y);
    const float round = (is_pass ? 3.0f : 9.0f) * scene.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::packed(is_hovered ? theme::field_hovered : theme::field),
                       round);
    list.AddRect(low, high, theme::packed(is_chosen ? theme::accent : theme::faint), round);
    const std::string text = own_name(node.name);
    const ImVec2 text_size = ImGui::CalcTextSize(text.c_str());
    list.AddText({middle.x - text_size.x * 0.5f, middle.y - text_size.y * 0.5f},
                 theme::packed(is_pass ? theme::text : theme::dim), text.c_str());
    if (!is_pass)
        return;
    const Look& look = scene.lab.renderer->executor().look();
    const std::string state =
        pass_switch_text(pass_of(node, scene), look, scene.lab.frames.passes().switches());
    if (!state.empty())
        draw_state(state, {middle.x, low.y}, scene);
}

// The graph without idle passes, but with the inspected one.
PassGraph graph_of_current(const Executor& executor, std::size_t inspected) {
    const Look& look = executor.look();
    Look current;
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        if (i != inspected && is_idle(look, i, executor.plan().targets[i].extent))
            continue;
        Pass& pass = current.passes.emplace_back();
        pass.name = look.passes[i].name;
        pass.inputs = look.passes[i].inputs;
    }
    return graph_of(current);
}

Paper paper_for(const PassGraph& graph) {
    Paper paper;
    float widest = 0.0f;
    for (const Node& node : graph.nodes)
        widest = std::max(widest, ImGui::CalcTextSize(own_name(node.name).c_str()).x);
    const float letter = ImGui::GetFontSize();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    paper.node = {widest + letter, std::floor(letter * 1.6f)};
    const float tight = paper.node.x + 1.6f * letter;
    const float wide = paper.node.x + 6.0f * letter;
    const int gaps = std::max(graph.columns - 1, 1);
    paper.column =
        std::clamp((room.x - paper.node.x - letter) / static_cast<float>(gaps), tight, wide);
    const auto rows = static_cast<float>(graph.lowest - graph.highest);
    paper.row = std::clamp((room.y - paper.node.y - letter) / std::max(rows + 0.6f, 1.0f),
                           paper.node.y * 1.35f, paper.node.y * 2.2f);
    const float height = rows * paper.row + paper.node.y;
    const float width = static_cast<float>(graph.columns - 1) * paper.column + paper.node.x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float left = low.x + std::max(0.0f, (room.x - width) * 0.5f);
    // Space for backward edges below the lowest row.
    const float below = paper.row * 0.6f;
    const float top = low.y + std::max(0.0f, (room.y - height - below) * 0.5f);
    paper.middle_of_left = {
        std::floor(left + paper.node.x * 0.5f),
        std::floor(top + paper.node.y * 0.5f - static_cast<float>(graph.highest) * paper.row)};
    ImGui::Dummy({width, height + below});  // scrollable area
    return paper;
}

bool is_over(const Node& node, const Paper& paper) {
    const ImVec2 middle = paper.at(node.column, node.row);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
           std::abs(mouse.x - middle.x) <= paper.node.x * 0.5f &&
           std::abs(mouse.y - middle.y) <= paper.node.y * 0.5f;
}

// A graph larger than its pane is first scrolled so that the inspected pass is centred.
void scroll_at_first(const ImVec2& middle) {
    if (!ImGui::IsWindowAppearing())
        return;
    ImGui::SetScrollFromPosX(middle.x - ImGui::GetWindowPos().x);
    ImGui::SetScrollFromPosY(middle.y - ImGui::GetWindowPos().y);
}
}  // namespace

void draw_pass_graph(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer || scene.lab.renderer->executor().plan().targets.empty())
        return;
    const Executor& executor = scene.lab.renderer->executor();
    const auto inspected =
        static_cast<std::size_t>(inspected_pass(executor.look(), scene.window.views.inspected));
    const PassGraph graph = graph_of_current(executor, inspected);
    ImGui::BeginChild("##graph", {0.0f, 0.0f}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NavFlattened);
    const Paper paper = paper_for(graph);
    const std::string& name = executor.look().passes[inspected].name;
    const auto found = std::ranges::find(graph.nodes, name, &Node::name);
    const auto chosen = static_cast<std::size_t>(found - graph.nodes.begin());
    scroll_at_first(paper.at(graph.nodes[chosen].column, graph.nodes[chosen].row));
    std::size_t highlighted = chosen;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        if (is_over(graph.nodes[i], paper))
            highlighted = i;
    const auto is_highlighted = [highlighted](const Edge& edge) {
        return edge.from == highlighted || edge.to == highlighted;
    };
    for (const bool is_front : {false, true})
        for (const Edge& edge : graph.edges)
            if (is_highlighted(edge) == is_front) {
                const theme::Color color = !is_front                ? theme::faint
                                           : edge.to == highlighted ? theme::accent
                                                                    : theme::label;
                draw_edge(edge, graph, paper, theme::packed(color), 1.5f * scene.scale);
            }
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        draw_node(i, graph, paper, scene, i == chosen, edits);
    ImGui::EndChild();
}
