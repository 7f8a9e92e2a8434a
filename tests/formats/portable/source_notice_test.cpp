#include "formats/portable/source_notice.h"

#include <doctest/doctest.h>

TEST_CASE("an SPDX identifier and the lines beside it are the notice of a file") {
    const SourceNotice notice = source_notice(
        "// SPDX-License-Identifier: GPL-2.0-or-later\n"
        "// Written by A. Person\n"
        "void main() {}  // nothing else\n");
    CHECK(notice.license == "GPL-2.0-or-later");
    CHECK(notice.text == "SPDX-License-Identifier: GPL-2.0-or-later\nWritten by A. Person");
}

TEST_CASE("block comments about a licence are kept without their marks") {
    const SourceNotice notice = source_notice(
        "#version 410\n"
        "/***\n * Copyright (c) 2010 A. Person\n *\n"
        " * Permission is hereby granted\n ***/\n"
        "/* a comment about a blur */\n");
    CHECK(notice.license == "see comments");
    CHECK(notice.text == "Copyright (c) 2010 A. Person\nPermission is hereby granted");
}

TEST_CASE("an author alone is kept, and the licence is not stated") {
    const SourceNotice notice = source_notice("void f() {}\n// Author: B. Person\n");
    CHECK(notice == SourceNotice{"not stated", "Author: B. Person"});
}

TEST_CASE("texts without notices, and unfinished comments, are accepted") {
    CHECK(source_notice("") == SourceNotice{"not stated", ""});
    CHECK(source_notice("/") == SourceNotice{"not stated", ""});
    CHECK(source_notice("float a = 1.0 / 2.0;  // half") == SourceNotice{"not stated", ""});
    CHECK(source_notice("/* license of").license == "see comments");
    CHECK(source_notice("// two comments: license\nfloat x;\n// copyright").text ==
          "two comments: license\n\ncopyright");
}
