"""Checks the limits of type_sizes.py on this tree, and its counts on small trees of C++ code."""

import tempfile
import unittest
from pathlib import Path

import type_sizes

ROOT = Path(__file__).resolve().parent.parent


def in_tree(files, action):
    """What `action(root)` returns for a tree with these files: {path below app/: text}."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            file = Path(root, "app", path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return action(root)


def breaches_in(files, exceptions=None):
    return in_tree(files, lambda root: type_sizes.check_tree(root, exceptions or {}))


def lines(form, count):
    return "".join(form.format(number) + "\n" for number in range(count))


class TypeSizesTest(unittest.TestCase):
    def assert_functions(self, text, expected, name="X", others=None):
        """Checks the names of the public functions of a type in lab/x.h, separated by spaces."""
        files = {"lab/x.h": text, **(others or {})}
        found = in_tree(files, lambda root: self.type_in(root, name, type_sizes.Tree.functions))
        self.assertEqual(sorted(found), sorted(expected.split()))

    def assert_members(self, text, expected, name="X", others=None):
        files = {"lab/x.h": text, **(others or {})}
        found = in_tree(files, lambda root: self.type_in(root, name, type_sizes.Tree.members))
        self.assertEqual(found, expected.split())

    def assert_plain(self, text, is_plain):
        found = in_tree({"lab/x.h": text}, lambda root: self.type_in(root, "X", type_sizes.Tree.is_plain_value))
        self.assertEqual(found, is_plain, text)

    def type_in(self, root, name, count):
        tree = type_sizes.Tree(root)
        self.assertIn(name, tree.types)
        return count(tree, tree.types[name][0])

    def test_this_tree_keeps_the_limits(self):
        self.assertEqual(type_sizes.check_tree(ROOT, type_sizes.EXCEPTIONS), [])

    def test_a_type_may_have_20_public_functions_and_not_21(self):
        def files(count):
            return {"lab/x.h": "\nclass X {\npublic:\n    X();\n" + lines("    void f{}();", count) + "};\n"}

        self.assertEqual(breaches_in(files(20)), [])
        self.assertEqual(
            breaches_in(files(21)), ["app/lab/x.h:2: error: X has 21 public functions; 20 are the most"]
        )

    def test_a_type_may_have_15_data_members_and_not_16(self):
        def files(count):
            return {"lab/x.cpp": "namespace {\nclass X {\n" + lines("    int m_{} = 0;", count) + "};\n}\n"}

        self.assertEqual(breaches_in(files(15)), [])
        self.assertEqual(breaches_in(files(16)), ["app/lab/x.cpp:2: error: X has 16 data members; 15 are the most"])

    def test_overloads_of_a_name_count_once(self):
        self.assert_functions(
            "struct X { int* f(); const int* f() const; template <class T> void f(T); void g() const {} };", "f g"
        )

    def test_only_public_functions_count(self):
        self.assert_functions(
            "class X { void a(); public: void b(); protected: void c(); private: void d(); public: void e(); };",
            "b e",
        )
        self.assert_functions("struct X { void a(); private: void b(); };", "a")

    def test_constructors_destructors_and_operators_do_not_count(self):
        self.assert_functions(
            """
            template <class T>
            class X : Y {
            public:
                X() = default;
                explicit X(int a) : Y{a}, m_a(a), m_b{[] { return 1; }()} { call(); }
                X(const X&) = delete;
                explicit(true) X(char);
                virtual ~X() override { end(); }
                X& operator=(const X&) = delete;
                bool operator==(const X&) const = default;
                auto operator<=>(const X& other) const { return compare(other); }
                bool operator<(const X& other) const;
                std::ostream& operator<<(int) { return out; }
                void operator()(int) const {}
                int& operator[](std::size_t);
                operator bool() const { return true; }
                explicit operator std::function<void(int)>() const;
                void other();
            };
            """,
            "other",
        )

    def test_deleted_functions_do_not_count(self):
        self.assert_functions("struct X { void a(int); void b(double) = delete; virtual void c() = 0; };", "a c")

    def test_inherited_public_functions_count(self):
        self.assert_functions(
            "namespace a { struct X : public gpu::Base, private Other { void own(); void shared() override; }; }",
            "own shared mine root",
            "a::X",
            {
                "gpu/base.h": "struct Root { void root(); };\n"
                "namespace gpu { class Base final : public Root {\n"
                "void no(); public: void shared(); void mine(); }; }",
                "lab/other.h": "struct Other { void hidden(); };",
            },
        )

    def test_bases_are_private_in_a_class_and_public_in_a_struct(self):
        base = "struct Base { void a(); };"
        self.assert_functions(base + "class X : Base { public: void b(); };", "b")
        self.assert_functions(base + "struct X : Base { void b(); };", "a b")
        self.assert_functions(base + "struct X : virtual Base { void b(); };", "a b")
        self.assert_functions(base + "struct X : protected virtual Base { void b(); };", "b")

    def test_bases_are_found_in_the_namespaces_around(self):
        self.assert_functions(
            "namespace a { struct Base { void a(); }; namespace b { inline namespace c {\n"
            "struct X : Base { void b(); }; } } }",
            "a b",
            "a::b::c::X",
        )

    def test_bases_from_libraries_and_templates(self):
        self.assert_functions("struct X : std::vector<int>, Base<X, int> { void a(); };", "a b", others={
            "lab/base.h": "template <class T, class U> class Base { public: void b(); };"
        })

    def test_functions_that_a_using_declaration_makes_public_count(self):
        self.assert_functions(
            "class Base { public: Base(); void a(); void b(); int data; };\n"
            "class X : Base { public: using Base::a; using Base::data; using Base::Base;\n"
            "using Y = std::size_t; using typename Base::Z; "
            "private: using Base::b; };",
            "a",
        )

    def test_static_functions_count(self):
        self.assert_functions("class X { public: static X make(); static inline int b(int a = 3) { return a; } };",
                              "make b")

    def test_friend_functions_count(self):
        self.assert_functions(
            "class X { void a(); friend void b(const X&); friend int c(X x) { return x; } friend class Y; "
            "friend bool operator==(const X&, const X&);\n"
            "public: friend struct Z; private: struct Z { void d(); }; };",
            "b c",
        )

    def test_functions_of_public_nested_types_count(self):
        self.assert_functions(
            "class X { public: void a(); struct Part { void a(); struct Deep { void b(); }; }; class Later;\n"
            "enum class E { f, g }; private: struct Hidden { void c(); }; struct Late; };",
            "a Part::a Part::Deep::b Later::d",
            others={"lab/x.cpp": "class X::Later { public: void d(); };\nstruct X::Late { void e(); };"},
        )

    def test_data_members_of_all_kinds_count(self):
        self.assert_members(
            """
            class X {
                std::map<std::string, std::vector<int>> m_map;
                int m_a = 1, *m_b = nullptr, m_c[3] = {1, 2, 3}, m_d{4};
                std::function<void(int, int)> m_lambda = [](int a, int b) { int inner = a < b; use(inner); };
                std::function<void()> m_braces{[this] { f(); }};
                std::array<int, (1 < 2) ? 3 : 4> m_array{};
                std::map<int, int> m_filled = std::map<int, int>{{1, 2}};
                std::pair<int, long> m_pair = std::pair<int, long>(1, 2);
                void (*m_pointer)(int) = nullptr;
                void (Other::*m_method)(int) const;
                int (&m_reference)[3];
                unsigned m_bit : 3, m_other_bit : 1 = 0;
                alignas(16) mutable std::atomic<bool> m_flag = false;
                volatile int* const m_fixed;
                [[maybe_unused]] const volatile int m_constant = 3;
                enum class Kind { one, two } m_kind = Kind::one;
                struct { int x; int y; } m_point;
                struct Other* m_other;
                struct stat m_status = {};
                gpu::Window::Size m_size{1'000, 2'000};
                decltype(m_a) m_same;
                union { int m_whole; float m_real; };
            };
            """,
            "m_map m_a m_b m_c m_d m_lambda m_braces m_array m_filled m_pair m_pointer m_method m_reference m_bit "
            "m_other_bit m_flag m_fixed m_constant m_kind m_point m_other m_status m_size m_same m_whole m_real",
        )

    def test_what_is_no_data_does_not_count(self):
        self.assert_members(
            """
            class X {
            #define MEMBER int macro; \\
                int continued;
                // int m_comment;
                /* int m_comment; */
                static int m_static;
                unsigned int : 4;
                std::uint8_t : 4;
                static constexpr double most = 3.0, least = 1.0;
                inline static const std::map<int, int> m_table{{1, 2}};
                alignas(16) static int m_aligned;
                using Size = int;
                typedef int Number;
                static_assert(sizeof(int) == 4);
                struct Declared;
                class AlsoDeclared;
                enum class Kind { one, two };
                enum Small : char;
                struct Nested { int inner; };
                friend class Friend;
                int f(int a = g(1), int b = 2) const noexcept { int local; return local; }
                auto h() -> std::vector<int>;
                int (*function(int))(char);
                const char* m_real = "; int m_string;";
            };
            """,
            "m_real",
        )

    def test_functions_with_difficult_results_count(self):
        self.assert_functions(
            """
            struct X {
                [[nodiscard]] constexpr std::map<int, int> a(std::function<void()> f = [] {}) const& noexcept(true);
                template <class T, class = std::enable_if_t<(1 < 2)>>
                static auto b(T) -> decltype(T()) { return {}; }
                int (*c(int))(char);
                std::function<void(int)> data;
                void (*pointer)(int);
                gpu::Result<std::unique_ptr<X>> d() { if (x) { return {}; } else { return e(); } }
                virtual void f() const = 0;
            };
            """,
            "a b c d f",
        )

    def test_inherited_data_counts(self):
        self.assert_members(
            "class Base { int m_a; protected: int m_b; };\nclass X : Base { int m_c; };", "m_a m_b m_c"
        )

    def test_plain_values_are_exempt(self):
        for rest in ("", "X(); explicit X(int a) : m_0(a) {}", "bool operator==(const X&) const = default;",
                     "static constexpr int most = 3; enum class Kind { a }; struct Part { int a; };"):
            text = "struct X {" + lines("int m_{} = 0;", 16) + rest + "};"
            self.assert_plain(text, True)
            self.assertEqual(breaches_in({"lab/x.h": text}), [])

    def test_types_with_functions_or_hidden_data_are_no_plain_values(self):
        for rest in ("bool is_empty() const { return true; }", "static X make();", "~X() { end(); }",
                     "private: int m_hidden;", "private: void f();", "friend void f(X);",
                     "struct Part { void f(); };"):
            text = "struct X {" + lines("int m_{};", 16) + rest + "};"
            self.assert_plain(text, False)
            self.assertEqual(len(breaches_in({"lab/x.h": text})), 1, rest)
        self.assert_plain("struct Base { void f(); }; struct X : Base { int a; };", False)
        self.assert_plain("struct Base { int b; }; class X : private Base { public: int a; };", False)
        self.assert_plain("struct Base { int b; }; struct X : Base { int a; };", True)

    def test_types_inside_functions_have_the_same_limits(self):
        text = "void f() {\n    struct Local {\n        void g();\n" + lines("int m_{};", 16) + "};\n}\n"
        self.assertEqual(
            breaches_in({"lab/x.cpp": text}), ["app/lab/x.cpp:2: error: Local has 16 data members; 15 are the most"]
        )

    def test_the_functions_of_a_class_are_in_one_cpp_file(self):
        header = "#pragma once\nnamespace gpu {\nclass X {\npublic:\n    X();\n    ~X();\n    void f();\n};\n}\n"
        one = "namespace gpu {\nX::X() : m_a{1} {}\nstd::vector<int> X::f() { return {}; }\n}\n"
        message = "app/gpu/x.h:3: error: functions of gpu::X are in app/gpu/x.cpp, {}; one .cpp is the most"
        self.assertEqual(breaches_in({"gpu/x.h": header, "gpu/x.cpp": one}), [])
        for text in ("namespace gpu { void X::f() {} }", "int gpu::X::f(int a) const { return a; }",
                     "gpu::X::~X() = default;", "bool gpu::X::operator==(const X&) const { return true; }",
                     "gpu::X::operator bool() const { return true; }",
                     "template <class T> void gpu::X<T>::f() {}"):
            self.assertEqual(
                breaches_in({"gpu/x.h": header, "gpu/x.cpp": one, "gpu/y.cpp": text}),
                [message.format("app/gpu/y.cpp")],
            )
        for text in ("void g() { gpu::X::f(); }", "int gpu::X::m_static = 3;", "namespace gpu { void f() {} }",
                     "void gpu::f() {}", "class X { void f(); };\nvoid X::f() {}"):
            self.assertEqual(breaches_in({"gpu/x.h": header, "gpu/x.cpp": one, "gpu/y.cpp": text}), [])

    def test_classes_of_the_same_name_in_cpp_files_are_told_apart(self):
        own = "namespace {\nclass X { void f(); };\nvoid X::f() {}\n}\n"
        files = {"lab/x.h": "class X { void f(); };", "lab/x.cpp": "void X::f() {}"}
        files.update({"lab/a.cpp": own, "lab/y.cpp": own})
        self.assertEqual(breaches_in(files), [])
        self.assertEqual(
            breaches_in({**files, "lab/z.cpp": "void X::g() {}"}),
            ["app/lab/x.h:1: error: functions of X are in app/lab/x.cpp, app/lab/z.cpp; one .cpp is the most"],
        )

    def test_functions_of_nested_types_are_in_the_same_cpp_file(self):
        files = {"lab/x.h": "class X { struct Part { void f(); }; void g(); };", "lab/x.cpp": "void X::g() {}"}
        self.assertEqual(
            breaches_in({**files, "lab/part.cpp": "void X::Part::f() {}"}),
            ["app/lab/x.h:1: error: functions of X are in app/lab/part.cpp, app/lab/x.cpp; one .cpp is the most"],
        )

    def test_functions_are_not_in_another_header(self):
        self.assertEqual(
            breaches_in({"lab/x.h": "struct X { void f(); };", "lab/x_more.h": "inline void X::f() {}"}),
            ["app/lab/x.h:1: error: functions of X are in app/lab/x_more.h; one .cpp is the most"],
        )

    def test_a_type_has_one_header(self):
        files = {"lab/x.h": "struct X { int a; };", "ui/x.h": "\nstruct X { int b; };"}
        self.assertEqual(
            breaches_in(files),
            ["app/lab/x.h:1: error: X is also defined in app/ui/x.h",
             "app/ui/x.h:2: error: X is also defined in app/lab/x.h"],
        )
        files = {"lab/x.h": "struct X { int a; };", "ui/x.cpp": "namespace {\nstruct X { int b; };\n}"}
        self.assertEqual(breaches_in(files), [])

    def test_an_exception_covers_its_own_limit(self):
        files = {"lab/x.h": "class X {\npublic:\n" + lines("    int f{0}();\n    int m_{0};", 21) + "};\n"}
        self.assertEqual(breaches_in(files, {"X": ("functions, members", "a reason")}), [])
        self.assertEqual(
            breaches_in(files, {"X": ("functions", "a reason")}),
            ["app/lab/x.h:1: error: X has 21 data members; 15 are the most"],
        )

    def test_an_exception_that_is_not_needed_is_a_breach(self):
        files = {"lab/x.h": "class X {\n" + lines("    int m_{};", 16) + "};\n"}
        message = "tests/type_sizes.py: error: the exception for {} is not needed for functions: remove it"
        self.assertEqual(breaches_in(files, {"X": ("members, functions", "a reason")}), [message.format("X")])
        files = {"lab/x.h": "class X { void f(); };"}
        for name in ("X", "Gone"):
            self.assertEqual(breaches_in(files, {name: ("functions", "a reason")}), [message.format(name)])

    def test_an_exception_has_a_reason(self):
        files = {"lab/x.h": "class X {\n" + lines("    int m_{};", 16) + "};\n"}
        self.assertEqual(
            breaches_in(files, {"X": ("members", "")}),
            ["tests/type_sizes.py: error: the exception for X has no reason"],
        )

    def test_the_counted_names_can_be_printed(self):
        files = {"lab/x.h": "class X {\n    int m_a;\npublic:\n    void f();\n};\n"}
        self.assertEqual(
            in_tree(files, lambda root: list(type_sizes.describe(root, "X"))),
            ["app/lab/x.h:1: X", "1 public functions: f", "1 data members: m_a"],
        )


if __name__ == "__main__":
    unittest.main()
