#include "glsl/limits/unbounded_loops.h"

#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <compare>
#include <optional>
#include <set>

using glslang::TIntermTyped;
using glslang::TOperator;

namespace {
/// A variable, or one component of a vector.
struct Place {
    long long symbol = 0;
    int component = -1;  // -1: the whole variable

    auto operator<=>(const Place&) const = default;
};

// nullopt: neither a variable nor a component of one.
std::optional<Place> place_of(TIntermTyped& node) {
    if (const glslang::TIntermSymbol* symbol = node.getAsSymbolNode())
        return Place{symbol->getId()};
    const glslang::TIntermBinary* binary = node.getAsBinaryNode();
    if (!binary || binary->getOp() != glslang::EOpIndexDirect)
        return std::nullopt;
    const glslang::TIntermSymbol* symbol = binary->getLeft()->getAsSymbolNode();
    const glslang::TIntermConstantUnion* index = binary->getRight()->getAsConstantUnion();
    if (!symbol || !index)
        return std::nullopt;
    return Place{symbol->getId(), index->getConstArray()[0].getIConst()};
}

// The variable that an expression such as `a[i].b` is part of; 0: none.
long long variable_of(TIntermTyped& node) {
    TIntermTyped* base = &node;
    while (glslang::TIntermBinary* binary = base->getAsBinaryNode())
        base = binary->getLeft();
    const glslang::TIntermSymbol* symbol = base->getAsSymbolNode();
    return symbol ? symbol->getId() : 0;
}

/// The variables that an expression reads.
class Reads : public glslang::TIntermTraverser {
public:
    explicit Reads(TIntermNode& node) { node.traverse(this); }

    void visitSymbol(glslang::TIntermSymbol* symbol) override { all.insert(symbol->getId()); }

    std::set<long long> all;
};

/// A change of a variable in a loop.
struct Write {
    TIntermNode* node = nullptr;
    Place place;
    int direction = 0;  // 1: up, -1: down, 2: by a factor; 0: not a step
    std::set<long long> step_reads = {};
};

// nullopt: not a constant.
std::optional<double> constant_of(TIntermTyped& node) {
    const glslang::TIntermConstantUnion* constant = node.getAsConstantUnion();
    if (!constant)
        return std::nullopt;
    const glslang::TConstUnion& number = constant->getConstArray()[0];
    switch (number.getType()) {
        case glslang::EbtInt:
            return number.getIConst();
        case glslang::EbtUint:
            return number.getUConst();
        case glslang::EbtFloat:
        case glslang::EbtDouble:
            return number.getDConst();
        default:
            return std::nullopt;
    }
}

// The sign of a constant; 1 for other values, whose sign is not known.
int sign_of(TIntermTyped& step) {
    const double value = constant_of(step).value_or(1.0);
    return (value > 0.0) - (value < 0.0);
}

// 2 for a constant above `least`, otherwise 0.
int factor_of(TIntermTyped& step, double least) {
    return constant_of(step).value_or(least) > least ? 2 : 0;
}

/// All changes of variables in some code.
class Writes : public glslang::TIntermTraverser {
public:
    explicit Writes(TIntermNode* node) {
        if (node)
            node->traverse(this);
    }

    bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
        const TOperator op = node->getOp();
        if (op == glslang::EOpPreIncrement || op == glslang::EOpPostIncrement)
            add(*node, *node->getOperand(), 1, nullptr);
        if (op == glslang::EOpPreDecrement || op == glslang::EOpPostDecrement)
            add(*node, *node->getOperand(), -1, nullptr);
        return true;
    }

    bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
        TIntermTyped& step = *node->getRight();
        switch (node->getOp()) {
            case glslang::EOpAddAssign:
                add(*node, *node->getLeft(), sign_of(step), &step);
                break;
            case glslang::EOpSubAssign:
                add(*node, *node->getLeft(), -sign_of(step), &step);
                break;
            case glslang::EOpMulAssign:
            case glslang::EOpDivAssign:
                add(*node, *node->getLeft(), factor_of(step, 1.0), &step);
                break;
            case glslang::EOpLeftShiftAssign:
            case glslang::EOpRightShiftAssign:
                add(*node, *node->getLeft(), factor_of(step, 0.0), &step);
                break;
            case glslang::EOpAssign:
                add_assignment(*node);
                break;
            default:
                if (node->modifiesState())
                    add(*node, *node->getLeft(), 0, nullptr);
        }
        return true;
    }

    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        if (node->getOp() != glslang::EOpFunctionCall)
            return true;
        const glslang::TQualifierList& qualifiers = node->getQualifierList();
        for (std::size_t i = 0; i < node->getSequence().size() && i < qualifiers.size(); ++i)
            if (qualifiers[i] == glslang::EvqOut || qualifiers[i] == glslang::EvqInOut)
                add(*node, *node->getSequence()[i]->getAsTyped(), 0, nullptr);
        return true;
    }

    std::vector<Write> all;

private:
    void add(TIntermNode& node, TIntermTyped& target, int direction, TIntermTyped* step) {
        const auto place = place_of(target);
        Write write{&node, place.value_or(Place{variable_of(target)}), place ? direction : 0};
        if (step)
            write.step_reads = Reads(*step).all;
        all.push_back(std::move(write));
    }

    // `i = i + step`, `i = i * factor` and so on are steps.
    void add_assignment(glslang::TIntermBinary& node) {
        const glslang::TIntermBinary* sum = node.getRight()->getAsBinaryNode();
        const auto place = place_of(*node.getLeft());
        if (!sum || !place || place_of(*sum->getLeft()) != place)
            return add(node, *node.getLeft(), 0, nullptr);
        TIntermTyped& step = *sum->getRight();
        switch (sum->getOp()) {
            case glslang::EOpAdd:
                return add(node, *node.getLeft(), sign_of(step), &step);
            case glslang::EOpSub:
                return add(node, *node.getLeft(), -sign_of(step), &step);
            case glslang::EOpMul:
            case glslang::EOpDiv:
                return add(node, *node.getLeft(), factor_of(step, 1.0), &step);
            case glslang::EOpLeftShift:
            case glslang::EOpRightShift:
                return add(node, *node.getLeft(), factor_of(step, 0.0), &step);
            default:
                return add(node, *node.getLeft(), 0, nullptr);
        }
    }
};

/// Whether some code continues the loop that it is in.
class Continues : public glslang::TIntermTraverser {
public:
    explicit Continues(TIntermNode& node) { node.traverse(this); }

    bool visitLoop(glslang::TVisit, glslang::TIntermLoop*) override { return false; }
    bool visitBranch(glslang::TVisit, glslang::TIntermBranch* node) override {
        found = found || node->getFlowOp() == glslang::EOpContinue;
        return true;
    }

    bool found = false;
};

const glslang::TIntermAggregate* sequence_of(TIntermNode* node) {
    const glslang::TIntermAggregate* aggregate = node ? node->getAsAggregate() : nullptr;
    return aggregate && aggregate->getOp() == glslang::EOpSequence ? aggregate : nullptr;
}

// Whether code ends the loop whenever it is reached.
bool ends_loop(TIntermNode* node) {
    if (const glslang::TIntermAggregate* sequence = sequence_of(node))
        return !sequence->getSequence().empty() && ends_loop(sequence->getSequence().back());
    const glslang::TIntermBranch* branch = node ? node->getAsBranchNode() : nullptr;
    return branch && branch->getFlowOp() != glslang::EOpContinue;
}

bool is_conversion(glslang::TIntermUnary& node) {
    return node.getType().getBasicType() != node.getOperand()->getType().getBasicType();
}

// Whether an expression has no bound if its variables have none: no functions such as sin().
bool grows_with_counter(TIntermTyped& node) {
    if (node.getAsConstantUnion() || place_of(node))
        return true;
    if (glslang::TIntermUnary* unary = node.getAsUnaryNode())
        return (unary->getOp() == glslang::EOpNegative || is_conversion(*unary) ||
                Writes(unary).all.size() == 1) &&
               grows_with_counter(*unary->getOperand());
    glslang::TIntermBinary* binary = node.getAsBinaryNode();
    if (!binary)
        return false;
    const TOperator op = binary->getOp();
    return (op == glslang::EOpAdd || op == glslang::EOpSub || op == glslang::EOpMul ||
            op == glslang::EOpDiv) &&
           grows_with_counter(*binary->getLeft()) && grows_with_counter(*binary->getRight());
}

/// The statements that every round of a loop reaches.
std::vector<TIntermNode*> reached_in(glslang::TIntermLoop& loop) {
    std::vector<TIntermNode*> reached;
    if (TIntermNode* body = loop.getBody()) {
        std::vector<TIntermNode*> statements{body};
        if (const glslang::TIntermAggregate* sequence = sequence_of(body))
            statements.assign(sequence->getSequence().begin(), sequence->getSequence().end());
        for (TIntermNode* statement : statements) {
            if (statement)
                reached.push_back(statement);
            if (statement && Continues(*statement).found)
                break;
        }
    }
    if (loop.getTerminal())
        reached.push_back(loop.getTerminal());
    return reached;
}

/// One loop.
class Loop {
public:
    explicit Loop(glslang::TIntermLoop& loop) : m_loop(loop), m_reached(reached_in(loop)) {
        for (TIntermNode* part : {loop.getBody(), static_cast<TIntermNode*>(loop.getTerminal()),
                                  static_cast<TIntermNode*>(loop.getTest())}) {
            const Writes writes(part);
            m_writes.insert(m_writes.end(), writes.all.begin(), writes.all.end());
        }
        for (const Write& write : m_writes)
            m_changed.insert(write.place.symbol);
    }

    bool is_bounded() const {
        if (TIntermTyped* test = m_loop.getTest(); test && is_bounding(*test, true))
            return true;
        return std::ranges::any_of(m_reached, [&](TIntermNode* statement) {
            if (ends_loop(statement))
                return true;
            glslang::TIntermSelection* choice = statement->getAsSelectionNode();
            return choice && ((ends_loop(choice->getTrueBlock()) &&
                               is_bounding(*choice->getCondition(), false)) ||
                              (ends_loop(choice->getFalseBlock()) &&
                               is_bounding(*choice->getCondition(), true)));
        });
    }

private:
    // Whether the loop can go on for a bounded time only while `condition` is `value`.
    bool is_bounding(TIntermTyped& condition, bool value) const {
        if (const glslang::TIntermConstantUnion* constant = condition.getAsConstantUnion())
            return constant->getConstArray()[0].getBConst() != value;
        if (glslang::TIntermUnary* negated = condition.getAsUnaryNode();
            negated && negated->getOp() == glslang::EOpLogicalNot)
            return is_bounding(*negated->getOperand(), !value);
        glslang::TIntermBinary* both = condition.getAsBinaryNode();
        if (!both)
            return false;
        const TOperator op = both->getOp();
        if (op == (value ? glslang::EOpLogicalAnd : glslang::EOpLogicalOr))
            return is_bounding(*both->getLeft(), value) || is_bounding(*both->getRight(), value);
        if (op == (value ? glslang::EOpLogicalOr : glslang::EOpLogicalAnd))
            return is_bounding(*both->getLeft(), value) && is_bounding(*both->getRight(), value);
        return is_bounding_comparison(*both, value);
    }

    bool is_bounding_comparison(glslang::TIntermBinary& node, bool value) const {
        int rising = 0;  // the direction in which the left side ends the loop
        switch (node.getOp()) {
            case glslang::EOpLessThan:
            case glslang::EOpLessThanEqual:
                rising = value ? 1 : -1;
                break;
            case glslang::EOpGreaterThan:
            case glslang::EOpGreaterThanEqual:
                rising = value ? -1 : 1;
                break;
            case glslang::EOpNotEqual:
            case glslang::EOpEqual:
                if ((node.getOp() == glslang::EOpNotEqual) != value)
                    return false;
                break;
            default:
                return false;
        }
        return is_counter(*node.getLeft(), rising, *node.getRight()) ||
               is_counter(*node.getRight(), -rising, *node.getLeft());
    }

    // Whether `side` is a counter that moves in a direction (0: any), and `bound` stays.
    bool is_counter(TIntermTyped& side, int direction, TIntermTyped& bound) const {
        const auto is_changed = [&](long long read) { return m_changed.contains(read); };
        const std::set<long long> reads = Reads(side).all;
        if (!grows_with_counter(side) || std::ranges::any_of(Reads(bound).all, is_changed) ||
            std::ranges::count_if(reads, is_changed) != 1)
            return false;
        const auto place = counted_place(side);
        return std::ranges::any_of(m_writes, [&](const Write& write) {
            return reads.contains(write.place.symbol) &&
                   (!place || !are_apart(write.place, *place)) &&
                   is_step(write, place ? direction : 0);
        });
    }

    // nullopt: the direction of a variable is not that of the expression.
    static std::optional<Place> counted_place(TIntermTyped& side) {
        TIntermTyped* node = &side;
        while (glslang::TIntermUnary* unary = node->getAsUnaryNode()) {
            if (!is_conversion(*unary))
                return std::nullopt;
            node = unary->getOperand();
        }
        return place_of(*node);
    }

    // Whether they are different variables, or different components of one.
    static bool are_apart(const Place& one, const Place& other) {
        return one.symbol != other.symbol ||
               (one.component >= 0 && other.component >= 0 && one.component != other.component);
    }

    // Whether a write happens in every round, and all writes of its place are such steps.
    bool is_step(const Write& step, int direction) const {
        if (step.direction == 0 || !is_reached(*step.node))
            return false;
        return std::ranges::all_of(m_writes, [&](const Write& write) {
            if (are_apart(write.place, step.place))
                return true;
            const bool has_direction =
                write.direction == 2 || direction == 0 || write.direction == direction;
            return write.direction != 0 && has_direction &&
                   std::ranges::none_of(write.step_reads,
                                        [&](long long read) { return m_changed.contains(read); });
        });
    }

    bool is_reached(const TIntermNode& write) const {
        if (m_loop.getTest() && has_write(m_loop.getTest(), write))
            return true;
        return std::ranges::any_of(m_reached, [&](TIntermNode* statement) {
            return !statement->getAsSelectionNode() && !statement->getAsSwitchNode() &&
                   !statement->getAsLoopNode() && has_write(statement, write);
        });
    }

    static bool has_write(TIntermNode* code, const TIntermNode& write) {
        const Writes writes(code);
        return std::ranges::any_of(writes.all,
                                   [&](const Write& one) { return one.node == &write; });
    }

    glslang::TIntermLoop& m_loop;
    std::vector<TIntermNode*> m_reached;
    std::vector<Write> m_writes;
    std::set<long long> m_changed;
};

class Loops : public glslang::TIntermTraverser {
public:
    bool visitLoop(glslang::TVisit, glslang::TIntermLoop* loop) override {
        if (!Loop(*loop).is_bounded())
            lines.push_back(loop->getLoc().line);
        return true;
    }

    std::vector<int> lines;
};
}  // namespace

std::vector<int> unbounded_loops(glslang::TShader& shader) {
    Loops loops;
    if (TIntermNode* root = shader.getIntermediate()->getTreeRoot())
        root->traverse(&loops);
    std::ranges::sort(loops.lines);
    return loops.lines;
}
