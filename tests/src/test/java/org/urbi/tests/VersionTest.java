package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.urbi.server.Version;

/** The version of the software is told in few places, and they agree. */
class VersionTest {
  private static final Path ROOT = Path.of("..");

  private static String found(String file, String expression) throws Exception {
    Matcher matcher = Pattern.compile(expression).matcher(Files.readString(ROOT.resolve(file)));
    assertTrue(matcher.find(), file);
    return matcher.group(1);
  }

  @Test
  void theFilesForOtherBuildSystemsHaveTheVersion() throws Exception {
    String version = found("pom.xml", "(?m)^  <version>(.+)</version>$");
    assertEquals(version, Version.number());
    assertEquals(version, found("share/pkgconfig/urbi.pc", "(?m)^Version: (.+)$"));
    assertEquals(
        version, found("share/cmake/Urbi/UrbiConfigVersion.cmake", "PACKAGE_VERSION \"(.+?)\""));
    assertEquals(version, found("editors/vscode/package.json", "\"version\": \"(.+?)\""));
    assertEquals(version, found("editors/emacs/urbiscript-mode.el", "(?m)^;; Version: (.+)$"));
  }

  @Test
  void theDialectIsToldBesideIt() {
    assertTrue(
        Version.text("urbi")
            .startsWith(
                "urbi version "
                    + Version.number()
                    + " (Urbi on the JVM), urbiscript of Urbi 2.7.5\n"));
  }

  @Test
  void everyReleaseInTheChangelogHasItsDate() throws Exception {
    String text = Files.readString(ROOT.resolve("CHANGELOG.md"));
    assertTrue(text.contains("\n## [Unreleased]\n"));
    text.lines()
        .filter(line -> line.startsWith("## ") && !line.equals("## [Unreleased]"))
        .forEach(line ->
            assertTrue(line.matches("## \\[\\d+\\.\\d+\\.\\d+] - \\d{4}-\\d{2}-\\d{2}"), line));
  }
}
