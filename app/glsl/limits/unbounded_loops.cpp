#include "glsl/limits/unbounded_loops.h"

#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <compare>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

using glslang::TIntermTyped;
using glslang::TOperator;

namespace {
/// A variable, or one component of a vector.
struct Place {
    long long symbol = 0;
    int component = -1;  // -1: the whole variable

    bool operator==(const Place&) const = default;
    bool operator<(const Place& other) const {
        return std::tie(symbol, component) < std::tie(other.symbol, other.component);
    }
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
    Place place;
    int direction = 0;        // 1: up, -1: down, 2: by a factor; 0: not a step
    bool is_certain = false;  // happens in every round
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
    /// `is_certain`: every round reaches the code.
    Writes(TIntermNode* node, bool is_certain) : m_is_certain(is_certain) {
        if (node)
            node->traverse(this);
    }

    bool visitSelection(glslang::TVisit, glslang::TIntermSelection* node) override {
        node->getCondition()->traverse(this);
        perhaps({node->getTrueBlock(), node->getFalseBlock()});
        return false;
    }

    bool visitSwitch(glslang::TVisit, glslang::TIntermSwitch* node) override {
        node->getCondition()->traverse(this);
        perhaps({node->getBody()});
        return false;
    }

    bool visitLoop(glslang::TVisit, glslang::TIntermLoop* node) override {
        perhaps({node->getTest(), node->getBody(), node->getTerminal()});
        return false;
    }

    bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
        const TOperator op = node->getOp();
        if (op == glslang::EOpPreIncrement || op == glslang::EOpPostIncrement)
            add(*node->getOperand(), 1, nullptr);
        if (op == glslang::EOpPreDecrement || op == glslang::EOpPostDecrement)
            add(*node->getOperand(), -1, nullptr);
        return true;
    }

    bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
        TIntermTyped& step = *node->getRight();
        if (node->getOp() == glslang::EOpLogicalAnd || node->getOp() == glslang::EOpLogicalOr) {
            node->getLeft()->traverse(this);
            perhaps({&step});
            return false;
        }
        switch (node->getOp()) {
            case glslang::EOpAddAssign:
                add(*node->getLeft(), sign_of(step), &step);
                break;
            case glslang::EOpSubAssign:
                add(*node->getLeft(), -sign_of(step), &step);
                break;
            case glslang::EOpMulAssign:
            case glslang::EOpDivAssign:
                add(*node->getLeft(), factor_of(step, 1.0), &step);
                break;
            case glslang::EOpLeftShiftAssign:
            case glslang::EOpRightShiftAssign:
                add(*node->getLeft(), factor_of(step, 0.0), &step);
                break;
            case glslang::EOpAssign:
                add_assignment(*node);
                break;
            default:
                if (node->modifiesState())
                    add(*node->getLeft(), 0, nullptr);
        }
        return true;
    }

    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        if (node->getOp() != glslang::EOpFunctionCall)
            return true;
        const glslang::TQualifierList& qualifiers = node->getQualifierList();
        for (std::size_t i = 0; i < node->getSequence().size() && i < qualifiers.size(); ++i)
            if (qualifiers[i] == glslang::EvqOut || qualifiers[i] == glslang::EvqInOut)
                add(*node->getSequence()[i]->getAsTyped(), 0, nullptr);
        return true;
    }

    std::vector<Write> all;

private:
    // Code that a round does not always reach.
    void perhaps(std::initializer_list<TIntermNode*> code) {
        const bool was_certain = std::exchange(m_is_certain, false);
        for (TIntermNode* part : code)
            if (part)
                part->traverse(this);
        m_is_certain = was_certain;
    }

    void add(TIntermTyped& target, int direction, TIntermTyped* step) {
        const auto place = place_of(target);
        Write write{place.value_or(Place{variable_of(target)}), place ? direction : 0,
                    m_is_certain};
        if (step)
            write.step_reads = Reads(*step).all;
        all.push_back(std::move(write));
    }

    // `i = i + step`, `i = i * factor` and so on are steps.
    void add_assignment(glslang::TIntermBinary& node) {
        const glslang::TIntermBinary* sum = node.getRight()->getAsBinaryNode();
        const auto place = place_of(*node.getLeft());
        if (!sum || !place || place_of(*sum->getLeft()) != place)
            return add(*node.getLeft(), 0, nullptr);
        TIntermTyped& step = *sum->getRight();
        switch (sum->getOp()) {
            case glslang::EOpAdd:
                return add(*node.getLeft(), sign_of(step), &step);
            case glslang::EOpSub:
                return add(*node.getLeft(), -sign_of(step), &step);
            case glslang::EOpMul:
            case glslang::EOpDiv:
                return add(*node.getLeft(), factor_of(step, 1.0), &step);
            case glslang::EOpLeftShift:
            case glslang::EOpRightShift:
                return add(*node.getLeft(), factor_of(step, 0.0), &step);
            default:
                return add(*node.getLeft(), 0, nullptr);
        }
    }

    bool m_is_certain;
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

bool has_end_last(TIntermNode* node) {
    if (const glslang::TIntermAggregate* sequence = sequence_of(node))
        return !sequence->getSequence().empty() && has_end_last(sequence->getSequence().back());
    const glslang::TIntermBranch* branch = node ? node->getAsBranchNode() : nullptr;
    return branch && branch->getFlowOp() != glslang::EOpContinue;
}

// Whether code ends the loop whenever it is reached.
bool ends_loop(TIntermNode* node) {
    return has_end_last(node) && !Continues(*node).found;
}

bool is_step_operator(TOperator op) {
    return op == glslang::EOpPreIncrement || op == glslang::EOpPostIncrement ||
           op == glslang::EOpPreDecrement || op == glslang::EOpPostDecrement;
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
                is_step_operator(unary->getOp())) &&
               grows_with_counter(*unary->getOperand());
    glslang::TIntermBinary* binary = node.getAsBinaryNode();
    if (!binary)
        return false;
    const TOperator op = binary->getOp();
    return (op == glslang::EOpAdd || op == glslang::EOpSub || op == glslang::EOpMul ||
            op == glslang::EOpDiv) &&
           grows_with_counter(*binary->getLeft()) && grows_with_counter(*binary->getRight());
}

/// A statement of a loop's body, outside of inner blocks. If one block of an `if` ends the loop,
/// the other block is not an inner block: each round that is not the last runs it.
struct Statement {
    TIntermNode* code = nullptr;
    bool is_certain = true;           // every round reaches it
    TIntermNode* changing = nullptr;  // the part of it that can change variables for the next round
};

// A `continue` skips the statements after it.
void add_statements(TIntermNode* code, bool& is_certain, std::vector<Statement>& statements) {
    if (!code)
        return;
    if (const glslang::TIntermAggregate* sequence = sequence_of(code)) {
        for (TIntermNode* part : sequence->getSequence())
            add_statements(part, is_certain, statements);
        return;
    }
    glslang::TIntermSelection* choice = code->getAsSelectionNode();
    if (choice && (ends_loop(choice->getTrueBlock()) || ends_loop(choice->getFalseBlock()))) {
        statements.push_back({code, is_certain, choice->getCondition()});
        add_statements(
            ends_loop(choice->getTrueBlock()) ? choice->getFalseBlock() : choice->getTrueBlock(),
            is_certain, statements);
        return;
    }
    statements.push_back({code, is_certain, code});
    is_certain = is_certain && !Continues(*code).found;
}

/// How a variable or component changes in a loop.
struct Change {
    bool is_certain = false;  // at least one step happens in every round
    bool is_up = false;
    bool is_down = false;
    bool is_other = false;  // not a step, or a step by something that the loop changes

    void add(const Change& other) {
        is_certain = is_certain || other.is_certain;
        is_up = is_up || other.is_up;
        is_down = is_down || other.is_down;
        is_other = is_other || other.is_other;
    }
};

/// One loop.
class Loop {
public:
    explicit Loop(glslang::TIntermLoop& loop) : m_loop(loop) {
        bool is_certain = true;
        add_statements(loop.getBody(), is_certain, m_statements);
        std::vector<Write> writes;
        const auto read = [&](TIntermNode* code, bool is_reached) {
            const Writes found(code, is_reached);
            writes.insert(writes.end(), found.all.begin(), found.all.end());
        };
        for (const Statement& statement : m_statements)
            read(statement.changing, statement.is_certain);
        read(loop.getTerminal(), true);
        read(loop.getTest(), true);
        for (const Write& write : writes)
            m_changed.insert(write.place.symbol);
        for (const Write& write : writes)
            m_changes[write.place].add(change_of(write));
    }

    bool is_bounded() const {
        if (TIntermTyped* test = m_loop.getTest(); test && is_bounding(*test, true))
            return true;
        return std::ranges::any_of(m_statements, [&](const Statement& statement) {
            if (!statement.is_certain)
                return false;
            if (ends_loop(statement.code))
                return true;
            glslang::TIntermSelection* choice = statement.code->getAsSelectionNode();
            return choice && ((ends_loop(choice->getTrueBlock()) &&
                               is_bounding(*choice->getCondition(), false)) ||
                              (ends_loop(choice->getFalseBlock()) &&
                               is_bounding(*choice->getCondition(), true)));
        });
    }

private:
    Change change_of(const Write& write) const {
        const bool is_step =
            write.direction != 0 && std::ranges::none_of(write.step_reads, [&](long long read) {
                return m_changed.contains(read);
            });
        return {is_step && write.is_certain, write.direction == 1, write.direction == -1, !is_step};
    }

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
        const auto counted = counted_place(side);
        const Change change =
            change_in(counted.value_or(Place{*std::ranges::find_if(reads, is_changed)}));
        const int asked = counted ? direction : 0;
        return change.is_certain && !change.is_other && !(asked == 1 && change.is_down) &&
               !(asked == -1 && change.is_up) && !(asked == 0 && change.is_up && change.is_down);
    }

    // The changes of a place, of its parts, and of what it is a part of.
    Change change_in(const Place& place) const {
        Change sum;
        for (auto known = m_changes.lower_bound({place.symbol});
             known != m_changes.end() && known->first.symbol == place.symbol; ++known)
            if (place.component < 0 || known->first.component < 0 ||
                known->first.component == place.component)
                sum.add(known->second);
        return sum;
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

    glslang::TIntermLoop& m_loop;
    std::vector<Statement> m_statements;
    std::set<long long> m_changed;  // variables
    std::map<Place, Change> m_changes;
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
