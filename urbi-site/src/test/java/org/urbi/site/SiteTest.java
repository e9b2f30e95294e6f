package org.urbi.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Small projects, and what is made of them. */
class SiteTest {
  @TempDir Path folder;
  private Path project;

  @BeforeEach
  void project() throws IOException {
    project = folder.resolve("project");
    write("README.md", "# All\n\n[Contents](docs/contents.md)\n");
    write(
        "docs/contents.md",
        "# Contents\n\n## Begin\n\n* [All of it](../README.md)\n* [One](sub/one.md)\n");
    write("docs/sub/one.md", "# One\n");
  }

  private void write(String name, String text) throws IOException {
    Path file = project.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  private String made(String name) throws IOException, SiteException {
    Path site = folder.resolve("site");
    Site.make(project, site, "1.2.3");
    return Files.readString(site.resolve(name));
  }

  private List<String> mistakes() {
    return assertThrows(SiteException.class, () -> made("index.html")).mistakes();
  }

  private static void has(String part, String whole) {
    assertTrue(whole.contains(part), () -> "no " + part + " in " + whole);
  }

  @Test
  void linksThatLeadNowhereAreMistakes() throws Exception {
    write(
        "docs/sub/one.md",
        "# One\n\n[a](two.md) and\n[b](#nothing), [c](../contents.md#begin)\n\n"
            + "[d](../contents.md#ends), [e](../../../project.md), ![f](f.png)\n");
    assertEquals(
        List.of(
            "docs/sub/one.md:3: there is no docs/sub/two.md",
            "docs/sub/one.md:6: there is no ../project.md",
            "docs/sub/one.md:6: there is no docs/sub/f.png",
            "docs/sub/one.md:4: docs/sub/one.md has no #nothing",
            "docs/sub/one.md:6: docs/contents.md has no #ends"),
        mistakes());
    assertFalse(Files.exists(folder.resolve("site")));
  }

  @Test
  void aPageThatNobodyFindsIsAMistake() throws Exception {
    write("docs/lost.md", "# Lost\n");
    assertEquals(List.of("docs/lost.md:1: no page has a link to this one"), mistakes());
  }

  @Test
  void listingsAreColouredAsTheScannerReadsThem() throws Exception {
    write(
        "docs/sub/one.md",
        "# One\n\n<!-- listing: separate session -->\n\n```urbiscript\nvar x = 1s < \"</pre>\"; // a\n"
            + "[00000001:error] !!! it's & so\nx\n```\n\n    $ echo <x>\n");
    String page = made("sub/one.html");
    has(
        "<pre><code><span class=\"keyword\">var</span> x = <span class=\"duration\">1s</span> &lt; "
            + "<span class=\"string\">&quot;&lt;/pre&gt;&quot;</span>; <span class=\"comment\">// a</span>\n"
            + "<span class=\"answer\">[00000001:error] !!! it's &amp; so\n</span>x\n</code></pre>",
        page);
    has("<pre><code>$ echo &lt;x&gt;\n</code></pre>", page);
    assertFalse(page.contains("listing:"), page);
  }

  @Test
  void whatLooksLikeHtmlIsText() throws Exception {
    write("docs/sub/one.md", "# One\n\n<script>alert(1)</script>\n\ntag_<name>, 2<sup>3</sup>\n");
    String page = made("sub/one.html");
    has("&lt;script&gt;alert(1)&lt;/script&gt;", page);
    has("tag_&lt;name&gt;, 2<sup>3</sup>", page);
  }

  @Test
  void headingsAreReachedAndTellThemselvesApart() throws Exception {
    write("docs/sub/one.md", "# One\n\n## `a`, `b`\n\n[again](#again-1)\n\n## Again\n\n## Again\n");
    String page = made("sub/one.html");
    has("<h2 id=\"a-b\"><code>a</code>, <code>b</code>", page);
    has("<h2 id=\"again-1\">", page);
    has("<li class=\"level2\"><a href=\"#again-1\">Again</a></li>", page);
  }

  @Test
  void contentsAreBesideEachPage() throws Exception {
    String page = made("sub/one.html");
    has("<h2>Begin</h2>\n<ul>\n<li><a href=\"../index.html\">All of it</a></li>", page);
    has("<li><a href=\"one.html\" aria-current=\"page\">One</a></li>", page);
    has("<title>One · Urbi 1.2.3</title>", page);
    has("href=\"../style.css\"", page);
  }

  @Test
  void whatIsSearchedHasQuotesAndNoAnswers() throws Exception {
    write(
        "docs/sub/one.md",
        "# One\n\n## Two\n\nA \"quoted\" \\\\ back\nslash\u2028\n\n```urbiscript\n1;\n[00000001] 1\n```\n");
    has(
        "[\"sub/one.html#two\",\"One\",\"Two\",\"A \\\"quoted\\\" \\\\ back slash\\u2028 1;\"],\n",
        made("search-data.js"));
  }

  @Test
  void filesAndFoldersThatPagesNameAreShown() throws Exception {
    write(
        "docs/sub/one.md", "# One\n\n[program](../../code/a.u), [all](../../code), ![i](i.png)\n");
    write("docs/sub/i.png", "picture");
    write("code/a.u", "var a;\n");
    write("code/bin/built", "");
    Files.write(project.resolve("code/binary"), new byte[] {(byte) 0xff, 0});
    String page = made("sub/one.html");
    has("href=\"../files/code/a.u.html\"", page);
    has("href=\"../files/code.html\"", page);
    has("src=\"i.png\"", page);
    Path site = folder.resolve("site");
    has(
        "<span class=\"keyword\">var</span> a",
        Files.readString(site.resolve("files/code/a.u.html")));
    has(
        "<ul>\n<li><a href=\"code/a.u.html\">a.u</a></li>\n<li>binary</li>\n</ul>",
        Files.readString(site.resolve("files/code.html")));
    assertEquals("picture", Files.readString(site.resolve("sub/i.png")));
  }

  @Test
  void allPagesOfThisProjectAreFoundAndTheirLinksLeadSomewhere() throws Exception {
    Path site = folder.resolve("site");
    Site.make(Path.of(".."), site, "1.2.3");
    try (Stream<Path> pages = Files.list(site.resolve("library"))) {
      assertTrue(pages.count() > 80);
    }
  }
}
