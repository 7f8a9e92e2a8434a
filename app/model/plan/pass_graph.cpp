#include "model/plan/pass_graph.h"

#include <algorithm>
#include <optional>

namespace {
using Node = PassGraph::Node;
using Edge = PassGraph::Edge;

std::size_t node_read_by(const Input& input, std::vector<Node>& nodes) {
    const bool is_of_pass_or_image =
        input.from == Input::From::pass || input.from == Input::From::image;
    const std::string name = is_of_pass_or_image
                                 ? input.name
                                 : Input{{}, input.from, {}, 0, {}, input.sound}.reference();
    const auto found = std::ranges::find_if(
        nodes, [&](const Node& node) { return node.kind == input.from && node.name == name; });
    const auto index = static_cast<std::size_t>(found - nodes.begin());
    if (found == nodes.end())
        nodes.push_back({input.from, name});
    return index;
}

void add_edges(const Look& look, std::size_t reader, PassGraph& graph) {
    for (const Input& input : look.passes[reader].inputs) {
        if (input.from == Input::From::pass && !find_pass(look, input.name))
            continue;
        const std::size_t from = node_read_by(input, graph.nodes);
        // A pass that is not drawn yet in this frame is read from the previous frame.
        const bool is_reserved_later = input.from == Input::From::pass && from >= reader;
        const int ago = is_reserved_later ? std::max(input.frames_ago, 1) : input.frames_ago;
        const auto same = std::ranges::find_if(graph.edges, [&](const Edge& edge) {
            return edge.from == from && edge.to == reader && edge.frames_ago == ago;
        });
        if (same == graph.edges.end())
            graph.edges.push_back({from, reader, ago, {input.uniform}, {}});
        else
            same->uniforms.push_back(input.uniform);
    }
}

bool is_forward(const Edge& edge, const PassGraph& graph) {
    return edge.frames_ago == 0 || graph.nodes[edge.from].kind != Input::From::pass;
}

// Passes are as far left as their inputs allow; other inputs are directly before their first
// reader.
void assign_columns(std::size_t passes, PassGraph& graph) {
    for (std::size_t i = 0; i < passes; ++i)
        for (const Edge& edge : graph.edges)
            if (edge.to == i && is_forward(edge, graph)) {
                const bool is_pass = graph.nodes[edge.from].kind == Input::From::pass;
                const int before = is_pass ? graph.nodes[edge.from].column : 0;
                graph.nodes[i].column = std::max(graph.nodes[i].column, before + 1);
            }
    for (std::size_t i = passes; i < graph.nodes.size(); ++i) {
        int first = static_cast<int>(passes);
        for (const Edge& edge : graph.edges)
            if (edge.from == i)
                first = std::min(first, graph.nodes[edge.to].column);
        graph.nodes[i].column = first - 1;
    }
    for (const Node& node : graph.nodes)
        graph.columns = std::max(graph.columns, node.column + 1);
}

/// A node, or the point where an edge crosses a column.
struct Stop {
    std::optional<std::size_t> node;
    std::size_t edge = 0;
    std::vector<std::pair<int, std::size_t>> neighbours;  // column and index in it
};
using Columns = std::vector<std::vector<Stop>>;

Columns stops_of(const PassGraph& graph, std::vector<std::size_t>& index_in_column) {
    Columns columns(static_cast<std::size_t>(graph.columns));
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        auto& column = columns[static_cast<std::size_t>(graph.nodes[i].column)];
        index_in_column.push_back(column.size());
        column.push_back({i, 0, {}});
    }
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const Edge& edge = graph.edges[i];
        if (!is_forward(edge, graph))
            continue;
        std::pair before{graph.nodes[edge.from].column, index_in_column[edge.from]};
        const int end = graph.nodes[edge.to].column;
        for (int at = before.first + 1; at <= end; ++at) {
            auto& column = columns[static_cast<std::size_t>(at)];
            const std::size_t index = at == end ? index_in_column[edge.to] : column.size();
            if (at < end)
                column.push_back({std::nullopt, i, {}});
            column[index].neighbours.push_back(before);
            columns[static_cast<std::size_t>(before.first)][before.second].neighbours.emplace_back(
                at, index);
            before = {at, index};
        }
    }
    return columns;
}

/// Rows by column and index.
using Rows = std::vector<std::vector<double>>;

// In the order of the wanted rows, 1 apart and centred.
void spread(std::vector<double>& rows) {
    std::vector<std::size_t> order(rows.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {}, [&rows](std::size_t i) { return rows[i]; });
    const double middle = (static_cast<double>(rows.size()) - 1.0) / 2.0;
    for (std::size_t i = 0; i < order.size(); ++i)
        rows[order[i]] = static_cast<double>(i) - middle;
}

void pull(const Columns& columns, std::size_t column, Rows& rows) {
    for (std::size_t i = 0; i < columns[column].size(); ++i) {
        const auto& neighbours = columns[column][i].neighbours;
        double sum = 0.0;
        for (const auto& [at, index] : neighbours)
            sum += rows[static_cast<std::size_t>(at)][index];
        if (!neighbours.empty())
            rows[column][i] = sum / static_cast<double>(neighbours.size());
    }
    spread(rows[column]);
}

// Moves each node to the mean of its neighbours, in sweeps to the right and left.
// Source: Sugiyama, Tagawa and Toda, "Methods for visual understanding of hierarchical system
// structures", IEEE Trans. SMC 11 (1981).
Rows rows_of(const Columns& columns) {
    Rows rows;
    for (const auto& column : columns) {
        rows.emplace_back();
        for (std::size_t i = 0; i < column.size(); ++i)
            rows.back().push_back(static_cast<double>(i));
        spread(rows.back());
    }
    constexpr int sweeps = 4;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            pull(columns, i, rows);
        for (std::size_t i = columns.size(); i-- > 0;)
            pull(columns, i, rows);
    }
    return rows;
}
}  // namespace

PassGraph graph_of(const Look& look) {
    PassGraph graph;
    for (const Pass& pass : look.passes)
        graph.nodes.push_back({Input::From::pass, pass.name});
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        add_edges(look, i, graph);
    assign_columns(look.passes.size(), graph);
    std::vector<std::size_t> index_in_column;
    const Columns columns = stops_of(graph, index_in_column);
    const Rows rows = rows_of(columns);
    for (std::size_t column = 0; column < columns.size(); ++column)
        for (std::size_t i = 0; i < columns[column].size(); ++i) {
            const Stop& stop = columns[column][i];
            const double row = rows[column][i];
            graph.lowest = std::max(graph.lowest, row);
            graph.highest = std::min(graph.highest, row);
            if (stop.node)
                graph.nodes[*stop.node].row = row;
            else
                graph.edges[stop.edge].bends.push_back(row);
        }
    return graph;
}
