#include "formats/slang/settings.h"

#include "base/text.h"
#include "formats/slang/slang_text.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace {
// The settings of a file as "key=value|" texts.
class Read {
public:
    explicit Read(const std::string& text) {
        m_folder.write("a.slangp", text);
        const auto read = read_slang_settings(m_folder / "a.slangp", m_files, m_warnings);
        REQUIRE(read.has_value());
        m_settings = *read;
    }
    std::string said() const {
        std::string text;
        for (const SlangSetting& setting : m_settings.settings)
            text += setting.key + "=" + setting.value + "|";
        return text;
    }
    std::string references() const {
        std::string text;
        for (const SlangSetting& reference : m_settings.references)
            text += reference.value + "|";
        return text;
    }
    std::vector<int> warned_lines() const {
        std::vector<int> lines;
        for (const Diagnostic& warning : m_warnings)
            lines.push_back(warning.line);
        return lines;
    }
    const SlangSettings& settings() const { return m_settings; }
    const Diagnostics& warnings() const { return m_warnings; }

private:
    TemporaryFolder m_folder;
    SlangFiles m_files;
    Diagnostics m_warnings;
    SlangSettings m_settings;
};
}  // namespace

TEST_CASE("a slang value is quoted or ends at the next space") {
    const Read read("a = one\nb=two\n  c\t=\t\"three words\"  \nd = \"\"\ne =\nf = g h\n");
    CHECK(read.said() == "a=one|b=two|c=three words|d=|e=|f=g|");
    CHECK(read.settings().find("c")->declared.line == 3);
    CHECK(read.settings().find("z") == nullptr);
    CHECK(read.warnings().empty());
}

TEST_CASE("a missing closing quote extends the value to the end of the line") {
    CHECK(Read("a = \"one two\nb = 3\n").said() == "a=one two|b=3|");
}

TEST_CASE("a ';' after a slang value is ignored") {
    CHECK(Read("a = source;\nb=two.slang;;\nc = \"three;\";\nd = ;\n").said() ==
          "a=source|b=two.slang|c=three;|d=|");
}

TEST_CASE("a byte order mark and all line ends are accepted") {
    CHECK(Read("\xef\xbb\xbf"
               "a = 1\r\nb = \"2\"\r\nc = 3")
              .said() == "a=1|b=2|c=3|");
}

TEST_CASE("comments start with # or // on their own line, or follow a value") {
    const Read read(
        "# a = 1\n// b = 2\n#c = 3\nd = \"4\" // more\ne = 5 # more\nf = 6#more\n"
        "g = \"#7\"\nh = ../x//y\n   # i = 9\n");
    CHECK(read.said() == "d=4|e=5|f=6|g=#7|h=../x//y|");
    CHECK(read.warnings().empty());
}

TEST_CASE("the first of duplicate keys counts, and a different value gives a warning") {
    const Read read("a = 1\nb = 2\na = 1\nb = 3\n");
    CHECK(read.said() == "a=1|b=2|");
    CHECK(read.warned_lines() == std::vector{4});
    CHECK(read.warnings().front().message ==
          "'b' is already set to '2' on line 2; this line is ignored");
    CHECK(read.warnings().front().severity == Severity::warning);
}

TEST_CASE("an invalid line gives a warning, except within /* */") {
    const Read read(
        "/* About this preset: the\nkey = is said\nrest is prose */\na \"1\"\n"
        "two words = 3\n= 4\n");
    CHECK(read.said() == "key=is|");
    CHECK(read.warned_lines() == std::vector{4, 5, 6});
    CHECK(read.warnings().front().message == "expected 'key = value'; this line is ignored");
}

TEST_CASE("quoted and unquoted references are collected") {
    const Read read(
        "#reference \"a.slangp\"\n#reference b.slangp\n#reference\t\"c d.slangp\" # e\n"
        "#references \"f\"\n# reference \"g\"\n");
    CHECK(read.references() == "a.slangp|b.slangp|c d.slangp|");
    CHECK(read.settings().references[2].declared.line == 3);
}

TEST_CASE("an #include is replaced by the lines of its file") {
    TemporaryFolder folder;
    folder.write("deep/b.inc", "a = 2\nb = 2\n#include \"c.inc\"\n");
    folder.write("deep/c.inc", "c = 3\n");
    const auto top = folder.write("a.slangp", "a = 1\n#include \"deep/b.inc\"\nb = 4\n");
    SlangFiles files;
    Diagnostics warnings;
    const auto read = read_slang_settings(top, files, warnings);
    REQUIRE(read.has_value());
    CHECK(read->find("a")->value == "1");
    CHECK(read->find("b")->value == "2");
    CHECK(read->find("c")->declared == Location{folder / "deep/c.inc", 1});
    CHECK(files.seen().size() == 3);

    folder.write("deep/c.inc", "#include \"b.inc\"\n#include \"gone.inc\"\n");
    SlangFiles again;
    const auto refused = read_slang_settings(top, again, warnings);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().size() == 2);
    CHECK(refused.error()[0].line == 1);
    CHECK(refused.error()[0].message == "circular #include");
    CHECK(refused.error()[1].message == "can't include 'gone.inc': file not found");
}

TEST_CASE("booleans are parsed leniently, and other values give a warning") {
    Diagnostics warnings;
    const auto read = [&](const std::string& value) {
        return read_slang_boolean({"srgb_framebuffer0", value, {"a.slangp", 9}}, warnings);
    };
    CHECK(read("true") == true);
    CHECK(read("1") == true);
    CHECK(read("TRUE;") == true);
    CHECK(read("false") == false);
    CHECK(read("0") == false);
    CHECK(warnings.empty());
    CHECK_FALSE(read("maybe").has_value());
    CHECK(to_string(warnings.front()) ==
          "a.slangp:9: warning: 'srgb_framebuffer0' must be true or false, got 'maybe'");
}

TEST_CASE("a decimal comma gives a note with the parsed and the correct value") {
    CHECK(decimal_comma_note("a", "0,5") ==
          "'a' is 0 because '0,5' has a decimal comma; use '0.5'");
    CHECK(decimal_comma_note("b", "-12,25") ==
          "'b' is -12 because '-12,25' has a decimal comma; use '-12.25'");
    for (const char* plain : {"0.5", "1", "", ",5", "1,", "a,5", "1.0,2.0", "x"})
        CHECK(decimal_comma_note("a", plain).empty());
}
